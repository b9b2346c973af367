/** Loops around cubes: closed, of every crossing once, alike on both sides of a face. */
import { describe, expect, test } from 'vitest';
import { CubeLoops } from '../../src/field/cubeLoops.ts';
import { random } from '../fixtures/random.ts';

const CORNERS = Array.from({ length: 8 }, (_, corner) => corner);

/** Values of the signs that `mask` says. */
const valuesOf = (mask: number, next: () => number) =>
  CORNERS.map((corner) => (((mask >> corner) & 1) === 1 ? 1 : -1) * (0.1 + next()));

describe('loops', () => {
  test('every crossed edge is in one loop, once, whatever the values (seed 61)', () => {
    const next = random(61);
    const loops = new CubeLoops();
    for (let mask = 0; mask < 256; mask++) {
      const crossed = [1, 2, 4].flatMap((step, axis) =>
        CORNERS.filter((c) => !(c & step) && ((mask >> c) ^ (mask >> (c | step))) & 1).map(
          (c) => c + 8 * axis,
        ),
      );
      for (let round = 0; round < 20; round++) {
        loops.trace(mask, valuesOf(mask, next));
        const end = loops.count > 0 ? loops.ends[loops.count - 1]! : 0;
        expect([...loops.edges.subarray(0, end)].sort((a, b) => a - b)).toEqual(
          crossed.sort((a, b) => a - b),
        );
        let start = 0;
        for (let i = 0; i < loops.count; i++) {
          expect(loops.ends[i]! - start).toBeGreaterThan(2);
          start = loops.ends[i]!;
        }
      }
    }
  });
});
