/** What keys and buttons do with the selected parts and groups. */
import { groupsChosen, partsWith } from '../document/chosen.ts';
import { copiesOf } from '../document/command/duplicateParts.ts';
import type { Joins } from '../document/document.ts';
import { mirrorOf } from '../document/mirror.ts';
import { add3, rotate3, scale3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { isHidden } from './partRows.ts';
import type { Session } from './session.ts';

/** A copy lies this much right of and below its original, in parts of what one sees. */
const BESIDE = 0.06;

/** False when nothing is selected. */
export function removeSelection(session: Session): boolean {
  const ids = session.selection;
  if (ids.length > 0) session.run({ type: 'removeParts', ids });
  return ids.length > 0;
}

/** Hides them; when none of them can be seen, shows them. */
export function hideSelection(session: Session): boolean {
  const ids = session.selection;
  if (ids.length > 0) session.run({ type: 'showParts', ids, visible: isHidden(session.document, ids) });
  return ids.length > 0;
}

/** mm, right and down as one looks. */
export function besideOf({ view }: Session): Vec3 {
  const by = BESIDE * view.height;
  const right = rotate3(view.rotation, [1, 0, 0]);
  const down = rotate3(view.rotation, [0, -1, 0]);
  // Whole millimetres where there is room for them: nobody wants to read the rest.
  const [x, y, z] = scale3(add3(right, down), by);
  const round = (mm: number) => (by > 5 ? Math.round(mm) : mm);
  return [round(x), round(y), round(z)];
}

/** The copies are what is selected next. */
export function duplicateSelection(session: Session): boolean {
  const { document, selection: ids } = session;
  if (ids.length === 0) return false;
  const copies = copiesOf(document, ids);
  session.run({ type: 'duplicateParts', ids, offset: besideOf(session) });
  session.select(copies);
  return true;
}

export function mirrorSelection(session: Session): boolean {
  const { document, selection: ids, view } = session;
  const mirror = mirrorOf(document, ids, view);
  if (mirror) session.run({ type: 'mirrorParts', ids, about: mirror.about, normal: mirror.normal });
  return mirror !== null;
}

/** An ear becomes two; what lies in the middle gets a copy beside it. */
export function mirrorCopy(session: Session): boolean {
  const { document, selection: ids, view } = session;
  const mirror = mirrorOf(document, ids, view);
  if (!mirror) return false;
  const { about, normal } = mirror;
  const offset: Vec3 = mirror.across === null ? besideOf(session) : [0, 0, 0];
  const copies = copiesOf(document, ids);
  session.run({ type: 'duplicateParts', ids, offset, mirror: { about: add3(about, offset), normal } });
  session.select(copies);
  return true;
}

/** Groups go elsewhere, and stay selected. */
export function joinSelection(session: Session, ids: readonly string[], to: Joins | null): void {
  const groups = groupsChosen(session.document, ids).map(({ group }) => group.id);
  if (groups.length === 0) return;
  session.run({ type: 'moveGroups', ids: groups, to });
  session.select(groups);
}

/** Up from a group to its part, then nothing; false when nothing was selected. */
export function letGoOf(session: Session): boolean {
  const { document, selection } = session;
  if (selection.length === 0) return false;
  const parts = partsWith(document, selection).map(({ id }) => id);
  const isInside = selection.some((id) => !parts.includes(id));
  session.select(isInside ? parts : []);
  session.saySelection();
  return true;
}

export function selectAll(session: Session): void {
  const seen = session.document.parts.filter(({ hidden }) => !hidden);
  if (session.tool !== 'select') session.setTool('select');
  session.select(seen.map(({ id }) => id));
  session.saySelection();
}
