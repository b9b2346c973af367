/** What the card shows of the selected surface on the form itself; it lasts as long as the part is selected. */
import { isSurface, type SurfacePart } from '../document/document.ts';
import type { Mark } from '../tool/marks.ts';
import { controlMarks, sectionMarks } from '../tool/partMarks.ts';
import type { Session } from './session.ts';

interface Shown {
  readonly part: string;
  /** index in the part's list; null: none is lit */
  readonly section: number | null;
}

const lit = new WeakMap<Session, Shown>();
/** whoever wants to see control meshes wants to see that of the next part, too */
const meshes = new WeakSet<Session>();

export const isMeshShown = (session: Session): boolean => meshes.has(session);

export function showMesh(session: Session, on: boolean): void {
  if (on) meshes.add(session);
  else meshes.delete(session);
  session.update();
}

/** The section of this part that is lit; null: none. */
export function litSection(session: Session, { id }: Pick<SurfacePart, 'id'>): number | null {
  const shown = lit.get(session);
  return shown?.part === id ? shown.section : null;
}

/** Again puts it out. */
export function lightSection(
  session: Session,
  { id }: Pick<SurfacePart, 'id'>,
  section: number | null,
): void {
  const isLit = litSection(session, { id }) === section;
  lit.set(session, { part: id, section: isLit ? null : section });
  session.update();
}

const made = new WeakMap<SurfacePart, { readonly key: string; readonly marks: readonly Mark[] }>();

/** For the one surface that is selected. */
export function surfaceMarks(session: Session): readonly Mark[] {
  const { selection, tool } = session;
  if (selection.length !== 1 || tool !== 'select') return [];
  const part = session.shown().parts.find(({ id }) => id === selection[0]);
  if (!part || !isSurface(part) || part.hidden) return [];
  const section = litSection(session, part);
  const key = `${section} ${isMeshShown(session)}`;
  const known = made.get(part);
  if (known?.key === key) return known.marks;
  const u = section === null ? undefined : part.sections[section]?.u;
  const marks = [
    ...(isMeshShown(session) ? controlMarks(part) : []),
    ...(u === undefined ? [] : sectionMarks(part, u)),
  ];
  made.set(part, { key, marks });
  return marks;
}
