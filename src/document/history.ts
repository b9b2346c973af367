/**
 * Undo and redo. History keeps documents, not inverses: structural sharing makes a step cost only what it
 * changed. A live gesture is a preview that never enters it; one gesture is one step.
 */
import { apply, type Command, describe } from './command/index.ts';
import { type Document, EMPTY_DOCUMENT } from './document.ts';

interface Step {
  readonly before: Document;
  readonly after: Document;
  readonly words: string;
  readonly command: Command;
}

export interface History {
  readonly past: readonly Step[];
  readonly present: Document;
  readonly future: readonly Step[];
}

/** Steps kept; older ones are forgotten. A step is a few references. */
const LIMIT = 1000;

export const newHistory = (present: Document = EMPTY_DOCUMENT): History => ({
  past: [],
  present,
  future: [],
});

/** Carries a command out as one undo step; a command that changes nothing makes none. */
export function commit(history: History, command: Command): History {
  const { present } = history;
  const after = apply(present, command);
  if (after === present) return history;
  const last = history.past.at(-1);
  if (last && isSameChoice(last.command, command))
    return commit({ past: history.past.slice(0, -1), present: last.before, future: [] }, command);
  const step = { before: present, after, words: describe(present, command), command };
  return { past: [...history.past.slice(1 - LIMIT), step], present: after, future: [] };
}

/** Who tries one form of the strokes after the other has made one choice. */
const isSameChoice = (a: Command, b: Command): boolean =>
  a.type === 'setForm' &&
  b.type === 'setForm' &&
  String(Object.keys(a).sort()) === String(Object.keys(b).sort());

/** What undo would take back, in words; null when there is nothing. */
export const undoable = (history: History): string | null => history.past.at(-1)?.words ?? null;
export const redoable = (history: History): string | null => history.future[0]?.words ?? null;

/** The commands that lead from an empty document to the present one: undone steps are not among them. */
export function scriptOf({ past, present }: History): readonly Command[] {
  const first = past[0]?.before ?? present;
  const commands = past.map(({ command }) => command);
  return first === EMPTY_DOCUMENT ? commands : [{ type: 'load', document: first, name: '' }, ...commands];
}

export function undo(history: History): History {
  const step = history.past.at(-1);
  if (!step) return history;
  return { past: history.past.slice(0, -1), present: step.before, future: [step, ...history.future] };
}

export function redo(history: History): History {
  const step = history.future[0];
  if (!step) return history;
  return { past: [...history.past, step], present: step.after, future: history.future.slice(1) };
}
