/**
 * Commands: everything a person can do to a document, as plain data. One file a command; the list below is
 * the registry from which `apply`, scripts and tests read.
 */
import type { Document } from '../document.ts';
import { addBody } from './addBody.ts';
import { addSection } from './addSection.ts';
import { addStroke } from './addStroke.ts';
import { bend } from './bend.ts';
import { drop } from './drop.ts';
import { duplicateParts } from './duplicateParts.ts';
import { editSkeleton } from './editSkeleton.ts';
import { keep } from './keep.ts';
import { load } from './load.ts';
import { mirrorParts } from './mirrorParts.ts';
import { moveGroups } from './moveGroups.ts';
import { moveParts } from './moveParts.ts';
import { paste } from './paste.ts';
import { recreate } from './recreate.ts';
import { redrawSection } from './redrawSection.ts';
import { removeAll } from './removeAll.ts';
import { removeLast } from './removeLast.ts';
import { removeParts } from './removeParts.ts';
import { removeSection } from './removeSection.ts';
import { renamePart } from './renamePart.ts';
import { scaleParts } from './scaleParts.ts';
import { setBend } from './setBend.ts';
import { setBody } from './setBody.ts';
import { setBrush } from './setBrush.ts';
import { setComponents } from './setComponents.ts';
import { setForm } from './setForm.ts';
import { setGroups } from './setGroups.ts';
import { setPartBrush } from './setPartBrush.ts';
import { setStroke } from './setStroke.ts';
import { setSurface } from './setSurface.ts';
import { setTubesOnly } from './setTubesOnly.ts';
import { showParts } from './showParts.ts';

/** How a command is carried out and named. `Data` is the command without its type. */
export interface CommandKind<Type extends string, Data> {
  readonly type: Type;
  /** Returns the same object when there is nothing to do: no undo step is made then. */
  apply(document: Document, command: Data): Document;
  /** What was done, in the words of the status line; `document` is the one before. */
  describe(document: Document, command: Data): string;
}

const kinds = {
  addStroke,
  addBody,
  setBody,
  keep,
  drop,
  setBrush,
  setTubesOnly,
  removeLast,
  removeAll,
  removeParts,
  renamePart,
  setPartBrush,
  showParts,
  moveParts,
  duplicateParts,
  scaleParts,
  mirrorParts,
  paste,
  setForm,
  setGroups,
  setComponents,
  moveGroups,
  editSkeleton,
  addSection,
  removeSection,
  redrawSection,
  setStroke,
  setSurface,
  bend,
  setBend,
  recreate,
  load,
} as const;

type Kinds = typeof kinds;
type Data<K> = K extends CommandKind<string, infer D> ? D : never;
/** A command is `{ type, …data }`. */
export type Command = { [K in keyof Kinds]: { readonly type: K } & Data<Kinds[K]> }[keyof Kinds];

export const COMMAND_TYPES = Object.keys(kinds) as readonly Command['type'][];

function kindOf(command: Command): CommandKind<string, Command> {
  return kinds[command.type] as unknown as CommandKind<string, Command>;
}

/** The document after the command; the argument is never changed. */
export function apply(document: Document, command: Command): Document {
  return kindOf(command).apply(document, command);
}

export function describe(document: Document, command: Command): string {
  return kindOf(command).describe(document, command);
}
