/** Which shapes' distances are convex functions, as rays beside them take for granted. */
import { describe, expect, it } from 'vitest';
import { isConvex } from '../../../src/gpu/raycast/stages.ts';
import { bindShape, type ShapeName, shapes } from '../../../src/shape/index.ts';
import { random } from '../../fixtures/random.ts';

const SEED = 7;

/** By how much the place between two is farther inside at least than the mean of both, at worst; in sizes of the shape. */
function worst(name: ShapeName): number {
  const next = random(SEED);
  const place = (size: number) => Array.from({ length: 3 }, () => 2 * size * (2 * next() - 1));
  const off = shapes[name].examples.map(bindShape).flatMap((field) => {
    const size = Math.max(10, ...(field.box?.max ?? []));
    const at = ([x, y, z]: readonly number[]) => field.value(x!, y!, z!);
    return Array.from({ length: 3000 }, () => {
      const [a, b] = [place(size), place(size)];
      return ((at(a) + at(b)) / 2 - at(a.map((from, i) => (from + b[i]!) / 2))) / size;
    });
  });
  return Math.max(...off);
}

describe('isConvex', () => {
  for (const name of (Object.keys(shapes) as ShapeName[]).filter(isConvex))
    it(`${name} is (seed ${SEED})`, () => expect(worst(name)).toBeLessThan(1e-9));

  it(`a torus is not (seed ${SEED})`, () => {
    expect(isConvex('torus')).toBe(false);
    expect(worst('torus')).toBeGreaterThan(0.01);
  });
});
