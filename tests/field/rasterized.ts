/** A mesh in pixels, in software: in each the nearest triangle that its middle is in. */
import type { FieldMesh } from '../../src/field/brickMesh.ts';
import { NOWHERE, type RayCamera } from '../../src/field/rayImage.ts';
import { sub3, unrotate3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { eyeDistance, project } from '../../src/stroke/plane.ts';

export interface Raster {
  /** mm before the plane of the pivot, NOWHERE where there is nothing */
  readonly depth: Float64Array;
  /** three a pixel */
  readonly colours: Float64Array;
}

/** A corner on the screen: pixels, mm before the pivot, and what falls with the distance from the eye. */
interface Corner {
  readonly x: number;
  readonly y: number;
  readonly before: number;
  readonly near: number;
  readonly colour: Vec3;
}

export function rasterized({ positions, indices, colours }: FieldMesh, camera: RayCamera): Raster {
  const { view, width, height } = camera;
  const eye = eyeDistance(view);
  const raster: Raster = {
    depth: new Float64Array(width * height).fill(NOWHERE),
    colours: new Float64Array(3 * width * height),
  };
  const three = (of: ArrayLike<number>, v: number): Vec3 => [of[3 * v]!, of[3 * v + 1]!, of[3 * v + 2]!];
  const cornerOf = (v: number): Corner => {
    const at = three(positions, v);
    const [x, y] = project(view, camera, at)!;
    const before = unrotate3(view.rotation, sub3(at, view.pivot))[2];
    return { x, y, before, near: eye === null ? 1 : 1 / (eye - before), colour: three(colours, v) };
  };
  for (let n = 0; n < indices.length; n += 3) {
    fill(raster, camera, cornerOf(indices[n]!), cornerOf(indices[n + 1]!), cornerOf(indices[n + 2]!));
  }
  return raster;
}

const twice = (a: Corner, b: Corner, x: number, y: number): number =>
  (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);

function fill(
  { depth, colours }: Raster,
  { width, height }: RayCamera,
  a: Corner,
  b: Corner,
  c: Corner,
): void {
  const area = twice(a, b, c.x, c.y);
  if (area === 0) return;
  const from = (least: number) => Math.max(Math.ceil(least - 0.5), 0);
  const to = (most: number, size: number) => Math.min(Math.floor(most - 0.5), size - 1);
  for (let y = from(Math.min(a.y, b.y, c.y)); y <= to(Math.max(a.y, b.y, c.y), height); y++) {
    for (let x = from(Math.min(a.x, b.x, c.x)); x <= to(Math.max(a.x, b.x, c.x), width); x++) {
      const parts = [
        twice(b, c, x + 0.5, y + 0.5) / area,
        twice(c, a, x + 0.5, y + 0.5) / area,
        twice(a, b, x + 0.5, y + 0.5) / area,
      ];
      if (parts.some((part) => part < 0)) continue;
      // straight lines stay straight in 1/distance
      const shares = [a, b, c].map(({ near }, i) => parts[i]! * near);
      const sum = shares[0]! + shares[1]! + shares[2]!;
      const mean = (of: (corner: Corner) => number) =>
        (shares[0]! * of(a) + shares[1]! * of(b) + shares[2]! * of(c)) / sum;
      const before = mean((corner) => corner.before);
      const at = y * width + x;
      if (before <= depth[at]!) continue;
      depth[at] = before;
      for (let channel = 0; channel < 3; channel++) {
        colours[3 * at + channel] = mean(({ colour }) => colour[channel]!);
      }
    }
  }
}
