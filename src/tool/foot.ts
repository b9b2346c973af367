/** Where moved parts stand on the others: the point that slides when they are moved along a surface. */
import { solids } from '../document/build.ts';
import { boxOfMesh } from '../document/extent.ts';
import { length3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { distanceToBox, type Nearest, nearestOn } from '../mesh/nearest.ts';
import { project } from '../stroke/plane.ts';
import type { Bench } from './tool.ts';
import type { Hit, Viewport } from './viewport.ts';

export interface Foot {
  /** mm */
  readonly point: Vec3;
  /** of the surface there: unit, outward */
  readonly normal: Vec3;
}

/** Pixels between a point and what is seen in its place for it to be seen itself. */
const SEEN = 2;

/** The nearest point of the other parts when it is seen, else what is seen behind the middle; null when there are no others. */
export function footOf({ document, viewport }: Bench, ids: readonly string[], middle: Vec3): Foot | null {
  const others = solids(document).filter(({ id }) => !ids.includes(id));
  let nearest: Nearest | null = null;
  for (const { mesh } of others) {
    const least: number = nearest?.distance ?? Infinity;
    if (distanceToBox(boxOfMesh(mesh), middle) < least) nearest = nearestOn(mesh, middle, least) ?? nearest;
  }
  if (!nearest || isSeen(nearest, viewport, ids)) return nearest;
  return pickAt(viewport, middle, ids) ?? nearest;
}

function isSeen({ point }: Foot, viewport: Viewport, ids: readonly string[]): boolean {
  const hit = pickAt(viewport, point, ids);
  const pixel = viewport.view.height / viewport.size.height;
  return hit !== null && length3(sub3(hit.point, point)) < SEEN * pixel;
}

function pickAt(viewport: Viewport, point: Vec3, except: readonly string[]): Hit | null {
  const at = project(viewport.view, viewport.size, point);
  return at && viewport.pick(at[0], at[1], except);
}
