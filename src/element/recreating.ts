/** Strokes of a part in hand again, seen as they were drawn, wherever the part is now. */
import { draftIsWhole, solidOf } from '../document/build.ts';
import { isSurface } from '../document/document.ts';
import { boxOfMesh } from '../document/extent.ts';
import { placedStroke } from '../document/placedStroke.ts';
import { viewOnto } from '../tool/sideView.ts';
import type { Session } from './session.ts';

/** The unfinished form is kept before; one that cannot be stays in hand, and words say so. True: the strokes are in hand. */
export function recreatePart(session: Session, id: string): boolean {
  const part = session.document.parts.find((other) => other.id === id);
  if (!part || !isSurface(part)) return false;
  if (!draftIsWhole(session.document)) {
    session.keep();
    return false;
  }
  session.run({ type: 'recreate', id });
  if (session.document.draft?.recreates?.part !== id) return false;
  session.setTool('draw');
  const { plane } = placedStroke(part.strokes[0]!, part.placement);
  // in hand it is as it was before it was bent
  const mesh = solidOf({ ...part, bends: [] })?.mesh;
  if (mesh) session.lookFrom(viewOnto(plane, boxOfMesh(mesh), session));
  return true;
}
