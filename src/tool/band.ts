/** The parts that a rectangle drawn with the pen takes in: those with a vertex inside it. */
import { solids } from '../document/build.ts';
import type { Document } from '../document/document.ts';
import { boxOfMesh } from '../document/extent.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import type { Box, Mesh } from '../mesh/mesh.ts';
import { project } from '../stroke/plane.ts';
import type { Band } from './tool.ts';
import type { Viewport } from './viewport.ts';

/** Ids, in the document's order. */
export function partsIn({ from, to }: Band, document: Document, viewport: Viewport): string[] {
  const left = Math.min(from.x, to.x);
  const right = Math.max(from.x, to.x);
  const top = Math.min(from.y, to.y);
  const bottom = Math.max(from.y, to.y);
  const inside = (p: Vec2 | null) =>
    p !== null && p[0] >= left && p[0] <= right && p[1] >= top && p[1] <= bottom;
  const shown = (p: Vec3) => project(viewport.view, viewport.size, p);
  const takesIn = (mesh: Mesh) => {
    // A box outside shows at once that no vertex is inside, without looking at each.
    const ends = corners(boxOfMesh(mesh)).map(shown);
    if (ends.every(inside)) return mesh.positions.length > 0;
    const beside = (out: (p: Vec2) => boolean) => ends.every((p) => p !== null && out(p));
    if (beside(([x]) => x < left) || beside(([x]) => x > right)) return false;
    if (beside(([, y]) => y < top) || beside(([, y]) => y > bottom)) return false;
    return vertices(mesh).some((p) => inside(shown(p)));
  };
  return solids(document)
    .filter(({ mesh }) => takesIn(mesh))
    .map(({ id }) => id);
}

const corners = ({ min, max }: Box): Vec3[] =>
  [min[0], max[0]].flatMap((x) =>
    [min[1], max[1]].flatMap((y) => [min[2], max[2]].map((z): Vec3 => [x, y, z])),
  );

function vertices({ positions }: Mesh): Vec3[] {
  const found: Vec3[] = [];
  for (let i = 0; i + 2 < positions.length; i += 3)
    found.push([positions[i]!, positions[i + 1]!, positions[i + 2]!]);
  return found;
}
