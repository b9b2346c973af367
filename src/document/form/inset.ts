/**
 * Loops moved into the region that they go round, place by place along their normals. No place goes farther than a share of the largest circle
 * that touches the outline there: up to that circle's middle the place is the nearest of the outline, so that what is moved does not cross
 * itself, narrow places give less and sharp corners stay.
 */

import { add2, length2, scale2, sub2 } from '../../math/tuple.ts';
import { crossingsOf } from '../../math/untangle.ts';
import type { Vec2 } from '../../math/vec.ts';
import type { Loop } from '../../skeleton/medial/outline.ts';

export interface Rim {
  readonly at: Vec2;
  /** into the region */
  readonly inward: Vec2;
  /** mm, of the largest circle that touches here, inside the region and outside of it */
  readonly inside: number;
  readonly outside: number;
}

/** of the circle's radius: inwards, and outwards, where what lies opposite may come, too */
const INWARDS = 0.75;
const OUTWARDS = 0.4;

/** The places of loops that have the region on their left. */
export function rimsOf(loops: readonly Loop[]): readonly (readonly Rim[])[] {
  const all = loops.flat();
  return loops.map((loop) =>
    loop.map((at, i): Rim => {
      const inward = inwardAt(loop, i);
      let [inside, outside] = [Infinity, Infinity];
      for (const other of all) {
        const to = sub2(other, at);
        const height = 2 * (to[0] * inward[0] + to[1] * inward[1]);
        const squared = to[0] * to[0] + to[1] * to[1];
        if (height > 0) inside = Math.min(inside, squared / height);
        else if (height < 0) outside = Math.min(outside, squared / -height);
      }
      return { at, inward, inside, outside };
    }),
  );
}

function inwardAt(loop: Loop, i: number): Vec2 {
  const at = loop[i]!;
  const sides = [sub2(at, loop.at(i - 1)!), sub2(loop[(i + 1) % loop.length]!, at)];
  const [a, b] = sides.map((side) => scale2(side, 1 / (length2(side) || 1))) as [Vec2, Vec2];
  const along = add2(a, b);
  const length = length2(along);
  return length > 1e-9 ? [-along[1] / length, along[0] / length] : [-a[1], a[0]];
}

/** mm that a place may move, inwards above 0. */
export const allowed = ({ inside, outside }: Rim, by: number): number =>
  Math.min(Math.max(by, -OUTWARDS * outside), INWARDS * inside);

/** `by`: mm, for each place of each loop. Where moved loops would cross they move half as far, or not at all. */
export function inset(
  rims: readonly (readonly Rim[])[],
  by: readonly (readonly number[])[],
): readonly Loop[] {
  for (const share of [1, 0.5, 0.2]) {
    const moved = rims.map((loop, l) =>
      loop.map((rim, i) => add2(rim.at, scale2(rim.inward, share * allowed(rim, by[l]![i]!)))),
    );
    if (crossingsOf(moved).length === 0) return moved;
  }
  return rims.map((loop) => loop.map(({ at }) => at));
}
