/** What keys and buttons do with the selected parts. */
import { copiesOf } from '../document/command/duplicateParts.ts';
import { add3, rotate3, scale3 } from '../math/tuple.ts';
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
  const parts = session.document.parts.filter(({ id }) => ids.includes(id));
  if (ids.length > 0) session.run({ type: 'showParts', ids, visible: parts.every(({ hidden }) => hidden) });
  return ids.length > 0;
}

/** The copies are what is selected next. */
export function duplicateSelection(session: Session): void {
  const { document, selection: ids, view } = session;
  const by = BESIDE * view.height;
  const right = rotate3(view.rotation, [1, 0, 0]);
  const down = rotate3(view.rotation, [0, -1, 0]);
  // Whole millimetres where there is room for them: nobody wants to read the rest.
  const [x, y, z] = scale3(add3(right, down), by);
  const round = (mm: number) => (by > 5 ? Math.round(mm) : mm);
  const copies = copiesOf(document, ids);
  session.run({ type: 'duplicateParts', ids, offset: [round(x), round(y), round(z)] });
  session.select(copies);
}

export function selectAll(session: Session): void {
  const seen = session.document.parts.filter(({ hidden }) => !hidden);
  if (session.tool !== 'select') session.setTool('select');
  session.select(seen.map(({ id }) => id));
  session.saySelection();
}
