/**
 * What the element tells the page. All events are of the element itself: they neither bubble nor cross a shadow root, so
 * that a `change` of a drawing is never mistaken for that of a form around it.
 */
import type { Command } from '../document/command/index.ts';
import type { Document } from '../document/document.ts';
import type { Mode } from '../document/look.ts';

/** What a change came from. */
export type Cause = 'command' | 'undo' | 'redo';

export interface ChangeDetail {
  /** what was done; undo and redo carry none */
  readonly commands: readonly Command[];
  readonly cause: Cause;
  /** the document after it */
  readonly document: Document;
}

export interface SelectDetail {
  /** of the selected parts, in the document’s order */
  readonly ids: readonly string[];
}

export interface RenameDetail {
  /** of the drawing */
  readonly name: string;
}

export interface ModeDetail {
  /** what is seen of bodies */
  readonly mode: Mode;
}

export interface ErrorDetail {
  readonly error: unknown;
  /** in a sentence, as text: it may quote a file */
  readonly message: string;
}

export interface RotundSketchEventMap extends Omit<HTMLElementEventMap, 'change' | 'select' | 'error'> {
  ready: Event;
  change: CustomEvent<ChangeDetail>;
  rename: CustomEvent<RenameDetail>;
  select: CustomEvent<SelectDetail>;
  mode: CustomEvent<ModeDetail>;
  error: CustomEvent<ErrorDetail>;
}

export const changed = (detail: ChangeDetail): CustomEvent<ChangeDetail> =>
  new CustomEvent('change', { detail });

export const selected = (ids: readonly string[]): CustomEvent<SelectDetail> =>
  new CustomEvent('select', { detail: { ids } });

export const renamed = (name: string): CustomEvent<RenameDetail> =>
  new CustomEvent('rename', { detail: { name } });

export const modeChanged = (mode: Mode): CustomEvent<ModeDetail> =>
  new CustomEvent('mode', { detail: { mode } });

/** `preventDefault` says that the page tells the person itself: the element shows no notice then. */
export const failed = (error: unknown): CustomEvent<ErrorDetail> =>
  new CustomEvent('error', { cancelable: true, detail: { error, message: messageOf(error) } });

export const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));
