/** A polygon as segments: its triangles cut into slices along their longest sides, at Gauss points across. */

import type { Kernel } from '../../src/kernel/kernel.ts';
import { GAUSS, type GaussPoints } from '../../src/math/gaussLegendre.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import type { PolygonSkel, SegmentSkel } from '../../src/skeleton/skels.ts';
import { based, type Triangle } from './basedTriangle.ts';
import { bound, type Grid, paramsOf, type Timed } from './timing.ts';
import { trianglesOf } from './triangulated.ts';

/** of the whole plate's value, that all slices together may miss: what float32 does */
const TOLERANCE = 1e-5;
const POINTS: readonly GaussPoints[] = [3, 4, 5, 6, 10, 16];

export interface Slices {
  readonly segments: readonly SegmentSkel[];
  /** the largest, of the whole plate's value */
  readonly error: number;
}

/** The polygon lies in the plane z = 0. */
export function slicesOf(skel: PolygonSkel, kernel: Kernel, grid: Grid): Slices {
  const params = paramsOf(kernel);
  const unit = kernel.unit(params, 1);
  const plate = kernel.wholePlane!(0, 4) * unit * unit;
  const segments = trianglesOf(skel).flatMap((triangle) => {
    const whole = bound({ ...skel, loops: [triangle] }, kernel);
    // errors of triangles add up, but not all in one place
    return fewest(
      triangle,
      (slices) => apart(fields(slices, kernel), [whole], grid) <= 0.1 * TOLERANCE * plate,
    );
  });
  return { segments, error: apart(fields(segments, kernel), [bound(skel, kernel)], grid) / plate };
}

const fields = (segments: readonly SegmentSkel[], kernel: Kernel): readonly Timed[] =>
  segments.map((segment) => bindSkel(segment, kernel, paramsOf(kernel)));

/** As few as are good enough; as many as there are where none is. */
function fewest(
  triangle: Triangle,
  isGood: (slices: readonly SegmentSkel[]) => boolean,
): readonly SegmentSkel[] {
  const all = POINTS.map((points) => sliced(triangle, points));
  return all.find(isGood) ?? all.at(-1)!;
}

function sliced(triangle: Triangle, points: GaussPoints): readonly SegmentSkel[] {
  const { ax, ay, ux, uy, base, top, height, side } = based(triangle, 1);
  const { nodes, weights } = GAUSS[points];
  return Array.from(nodes, (node, i): SegmentSkel => {
    const part = 0.5 + 0.5 * node;
    const across = side * part * height;
    const at = (along: number) => [ax + along * ux - across * uy, ay + along * uy + across * ux, 0] as const;
    const start = part * top;
    return {
      type: 'segment',
      a: at(start),
      b: at(start + base * (1 - part)),
      weights: [0.5 * weights[i]! * height],
    };
  });
}

function apart(some: readonly Timed[], others: readonly Timed[], { x, y, z }: Grid): number {
  let most = 0;
  for (const px of x)
    for (const py of y)
      for (const pz of z) {
        let sum = 0;
        for (const field of some) sum += field.value(px, py, pz);
        for (const field of others) sum -= field.value(px, py, pz);
        most = Math.max(most, Math.abs(sum));
      }
  return most;
}
