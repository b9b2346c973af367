/** A drawing at one moment, with what is known of it besides: what is stored, or would be. */
import type { Drawing } from '../document/drawing.ts';
import type { Stored } from './vault.ts';

export type Facts = Pick<Stored, 'ownPaper' | 'file'>;

export interface Snapshot {
  readonly drawing: Drawing;
  readonly facts: Facts;
  /** the view and the facts: looking is no deed, but it is kept, too */
  readonly rest: string;
}

export function snapshot(drawing: Drawing, facts: Facts): Snapshot {
  const { ownPaper, file } = facts;
  return { drawing, facts, rest: JSON.stringify([drawing.view, ownPaper, file?.name, file?.unchanged]) };
}

/** A page without anything drawn and without a name: nothing to keep. */
export const isBlank = ({ document: { parts, draft }, name }: Drawing): boolean =>
  parts.length === 0 && !draft && name === '';

export const sameWork = (a: Snapshot | null, { drawing }: Snapshot): boolean =>
  a?.drawing.document === drawing.document && a.drawing.name === drawing.name;

export const same = (a: Snapshot | null, b: Snapshot): boolean =>
  a !== null && sameWork(a, b) && a.drawing.look === b.drawing.look && a.rest === b.rest;
