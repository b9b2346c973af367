/** What a shape may be within a ball: holds what it is, and shrinks with the ball. */
import { expect, test } from 'vitest';
import { bindShape, type Shape, shapes } from '../../src/shape/index.ts';
import { SPREAD } from '../../src/skeleton/skeleton.ts';
import { normal, random } from '../fixtures/random.ts';

const SEED = 53;
const BALLS = 60;
const spread = new Float64Array(SPREAD);
const examples = Object.values(shapes).flatMap(({ examples }) => examples as readonly Shape[]);

/** mm */
function sizeOf(shape: Shape): number {
  const { box } = bindShape(shape);
  return box ? Math.max(...box.max.map(Math.abs)) : 10;
}

test.each(examples)(`holds its values (${BALLS} balls, seed ${SEED}): %j`, (shape) => {
  const [next, bell] = [random(SEED), normal(SEED)];
  const field = bindShape(shape);
  const size = sizeOf(shape);
  for (let i = 0; i < BALLS; i++) {
    const one = () => (i % 5 === 0 ? 0 : 2 * size * (2 * next() - 1));
    const [x, y, z] = [one(), one(), one()];
    const radius = size * [0, 1e-3, 0.03, 0.3, 1, 3][i % 6]!;
    field.spread(x, y, z, radius, spread);
    const [middle, gx, gy, gz, rest, low, high] = spread as unknown as number[];
    for (let j = 0; j < 12; j++) {
      const v = [bell(), bell(), bell()];
      const length = Math.hypot(...v);
      const reach = (radius * (j % 2 === 0 ? 1 - 1e-15 : Math.cbrt(next()))) / length;
      const [dx, dy, dz] = v.map((c) => c * reach);
      const value = field.value(x + dx!, y + dy!, z + dz!);
      const form = middle! + gx! * dx! + gy! * dy! + gz! * dz!;
      const rounding = 1e-15 * (Math.abs(x) + Math.abs(y) + Math.abs(z) + radius + size);
      const held = value >= low! && value <= high! && Math.abs(value - form) <= rest! + rounding;
      if (!held) expect.fail(`${value} not in ${[...spread]}, ${radius} about ${x}, ${y}, ${z}`);
    }
  }
});

test.each(examples)('shrinks with the ball: %j', (shape) => {
  const field = bindShape(shape);
  const size = sizeOf(shape);
  const width = (radius: number) => {
    field.spread(0.9 * size, 0.3 * size, -0.4 * size, radius, spread);
    return spread[6]! - spread[5]!;
  };
  expect(width(1e-3 * size)).toBeLessThan(0.15 * width(1e-2 * size));
  expect(width(0)).toBeLessThan(1e-9 * width(1e-2 * size));
});
