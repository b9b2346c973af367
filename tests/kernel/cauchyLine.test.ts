/** The quick way of the Cauchy kernel, held against its way through a frame, which the conformance suite judges. */
import { describe, expect, it } from 'vitest';
import { cauchy } from '../../src/kernel/cauchy.ts';
import { LineFrame } from '../../src/kernel/kernel.ts';
import { random } from '../fixtures/random.ts';

const SEED = 5;

/** Value and gradient along x (the line) and y, of a line from the origin along x, seen from (x, y, 0). */
function both(length: number, [w0, w1]: readonly [number, number], x: number, y: number) {
  const line = { a: [0, 0, 0], u: [1, 0, 0], per: 1, length, w0, w1 };
  const quick = new Float64Array(4);
  cauchy.linear!(line)!.add(x, y, 0, 1, quick);
  const frame = new LineFrame();
  Object.assign(frame, { rho2: y * y, alpha: -x, beta: length - x, length, degree: w1 === 0 ? 0 : 1 });
  frame.weights.set([w0, w1]);
  const [value, across, along] = [new Float64Array(3)].flatMap((out) => {
    cauchy.line(frame, out);
    return [...out];
  }) as [number, number, number];
  return { quick, framed: [value, along, 2 * across * y] as const };
}

describe('the Cauchy kernel along a line', () => {
  it(`is the same through a frame: near, beyond the ends, on the axis, far (seed ${SEED})`, () => {
    const next = random(SEED);
    const spread = (low: number, high: number) => 10 ** (low + (high - low) * next());
    for (let i = 0; i < 4000; i++) {
      const length = spread(-3, 1.8);
      const weights = [next() - 0.3, (next() - 0.3) / length] as const;
      const x = length * (0.5 + (next() - 0.5) * spread(0, 3));
      const y = i % 5 === 0 ? 0 : length * spread(-3, 3);
      const { quick, framed } = both(length, weights, x, y);
      const most = Math.abs(weights[0]) + Math.abs(weights[1]) * length;
      const q = (t: number) => 1 + y * y + (t - x) * (t - x);
      const nearest = q(Math.min(Math.max(x, 0), length));
      const scale = most * Math.min(length, Math.sqrt(nearest)) * nearest ** -2;
      const misses = framed.map((wanted, k) => Math.abs(quick[k]! - wanted) / scale);
      if (!(Math.max(...misses) < 2e-12)) {
        expect(misses, `length ${length}, weights ${weights}, at ${x}, ${y}`).toEqual([0, 0, 0]);
      }
    }
  });

  it('leaves long lines to the frame', () => {
    const line = { a: [0, 0, 0], u: [1, 0, 0], per: 1, w0: 1, w1: 0 };
    expect(cauchy.linear!({ ...line, length: 64 })).not.toBeNull();
    expect(cauchy.linear!({ ...line, length: 65 })).toBeNull();
  });
});
