import { describe, expect, it } from 'vitest';
import type { Vec2 } from '../../src/math/vec.ts';
import { runsLeft } from '../../src/surface/chordWay.ts';
import { pairCurves } from '../../src/surface/pair.ts';
import { line } from './curves.ts';

/** The half that is full, as a direction on the plane: right of q_l → q_r, or left of it where chords run to the left. */
function fullSide(first: readonly Vec2[], second: readonly Vec2[]): Vec2 {
  const pair = pairCurves(line(...first), line(...second));
  const { left, right } = pair.at(0.5, 1);
  const sense = runsLeft((u) => pair.at(u, 1)) ? -1 : 1;
  return [sense * (right[1] - left[1]), -sense * (right[0] - left[0])];
}

const back = ([a, b]: readonly Vec2[]): readonly Vec2[] => [b!, a!];
const WEST: readonly Vec2[] = [
  [-10, 50],
  [-20, -50],
];
const EAST: readonly Vec2[] = [
  [10, 50],
  [20, -50],
];

describe('the full side', () => {
  it('is below, whichever way and in whichever order sides were drawn', () => {
    for (const a of [WEST, back(WEST)])
      for (const b of [EAST, back(EAST)])
        for (const [first, second] of [
          [a, b],
          [b, a],
        ] as const)
          expect(fullSide(first, second)[1]).toBeLessThan(-1);
  });

  it('is mirrored with the form, lying forms too', () => {
    const turned = (side: readonly Vec2[]) => side.map(([x, y]): Vec2 => [y, x]);
    const mirrored = (side: readonly Vec2[]) => side.map(([x, y]): Vec2 => [-x, y]);
    for (const [a, b] of [
      [WEST, EAST],
      [back(WEST), EAST],
      [turned(WEST), turned(EAST)],
      [turned(back(WEST)), turned(EAST)],
    ] as const) {
      const [x, y] = fullSide(a, b);
      const [mx, my] = fullSide(mirrored(a), mirrored(b));
      expect(mx).toBeCloseTo(-x, 9);
      expect(my).toBeCloseTo(y, 9);
    }
  });
});
