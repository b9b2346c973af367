/** Strokes of a part in hand again, seen as they were drawn, wherever the part is now. */
import { solidOf } from '../document/build.ts';
import { isSurface } from '../document/document.ts';
import { boxOfMesh } from '../document/extent.ts';
import { placedStroke } from '../document/placedStroke.ts';
import { viewOnto } from '../tool/sideView.ts';
import type { Session } from './session.ts';

export function recreatePart(session: Session, id: string): void {
  const part = session.document.parts.find((other) => other.id === id);
  const mesh = part && solidOf(part)?.mesh;
  if (!part || !isSurface(part)) return;
  session.setTool('draw');
  const { plane } = placedStroke(part.strokes[0]!, part.placement);
  if (mesh) session.lookFrom(viewOnto(plane, boxOfMesh(mesh), session));
  session.run({ type: 'recreate', id });
}
