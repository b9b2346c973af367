/** The Bend tool in the hand: what it begins with, and how it ends. */
import { draftIsWhole } from '../document/build.ts';
import { recreatedOf } from '../document/command/keep.ts';
import { type Document, isSurface } from '../document/document.ts';
import { bendPart, madeBend, withLength } from '../tool/bend.ts';
import type { Session } from './session.ts';
import type { ToolName } from './tools.ts';
import { EDIT_WORDS } from './words.ts';

/** the tool to go back to */
const before = new WeakMap<Session, ToolName>();

/** Of what is selected, the unfinished form, which is kept first, or the last part; of none of them a tap says which. True: it is in hand. */
export function startBend(session: Session): boolean {
  if (session.tool === 'bend' && session.state.bending) return true;
  if (session.document.draft && draftIsWhole(session.document)) {
    const again = recreatedOf(session.document);
    session.keep();
    const kept = again ?? session.document.parts.at(-1);
    session.select(kept ? [kept.id] : []);
  }
  if (!session.document.parts.some((part) => isSurface(part) && !part.hidden)) {
    session.said = EDIT_WORDS.noneToBend;
    session.update();
    return true;
  }
  const id = bendable(session.document, session.selection);
  take(session);
  if (id === null) {
    session.said = EDIT_WORDS.which;
    session.update();
    return true;
  }
  const count = bendCount(session.document, id);
  editBend(session, id, count);
  return true;
}

/** A bend of the list in hand again; or, at the end of the list, a new one. */
export function editBend(session: Session, id: string, index: number): void {
  const { bending } = session.state;
  const home = bending?.home ?? session.goal;
  take(session);
  session.select([id]);
  session.begin(bendPart(session, id, index, home));
}

function take(session: Session): void {
  if (session.tool !== 'bend') before.set(session, session.tool);
  session.setTool('bend');
}

/** One surface alone is meant: the selected one, else the last. */
function bendable({ parts }: Document, selection: readonly string[]): string | null {
  const surfaces = parts.filter((part) => isSurface(part) && !part.hidden);
  const chosen = surfaces.filter(({ id }) => selection.includes(id));
  if (chosen.length === 1 && selection.length === 1) return chosen[0]!.id;
  return selection.length === 0 && surfaces.length === 1 ? surfaces[0]!.id : null;
}

function bendCount({ parts }: Document, id: string): number {
  const part = parts.find((other) => other.id === id);
  return part && isSurface(part) ? part.bends.length : 0;
}

/** The bend stays, and the camera returns. */
export function keepBend(session: Session): void {
  const { bending } = session.state;
  session.setTool(before.get(session) === 'draw' ? 'draw' : 'select');
  if (bending && session.tool === 'select') session.select([bending.id]);
}

/** All is as it was before, and the camera returns. */
export function dropBend(session: Session): void {
  const { bending } = session.state;
  const made = bending && madeBend(bending, session.document);
  if (bending && made && made !== bending.old) {
    const { id, index, old } = bending;
    session.commit([{ type: 'setBend', id, index, change: old }]);
  } else session.said = EDIT_WORDS.left(EDIT_WORDS.bend);
  keepBend(session);
}

export function setBendLength(session: Session, keepsLength: boolean): void {
  const { bending } = session.state;
  if (!bending) return;
  session.begin(withLength(bending, keepsLength));
  const { id, index } = bending;
  if (madeBend(bending, session.document))
    session.commit([{ type: 'setBend', id, index, change: { keepsLength } }]);
}
