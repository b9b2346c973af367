/** Long work in slices: to its end, or given up when nobody wants it any more. */
import { describe, expect, test } from 'vitest';
import { sliced } from '../../src/worker/sliced.ts';

/** Steps that each take longer than a slice. */
function* slow(steps: number): Generator<number, string> {
  for (let i = 0; i < steps; i++) {
    const end = performance.now() + 15;
    while (performance.now() < end);
    yield i / steps;
  }
  return 'done';
}

describe('work in slices', () => {
  test('comes to its end, and tells how much is done', async () => {
    const told: number[] = [];
    expect(
      await sliced(
        slow(4),
        () => true,
        (share) => told.push(share),
      ),
    ).toBe('done');
    expect(told).toEqual([0, 0.25, 0.5, 0.75]);
  });

  test('is given up in the first pause in which it is not wanted', async () => {
    const told: number[] = [];
    let pauses = 0;
    const wanted = () => ++pauses < 3;
    expect(await sliced(slow(50), wanted, (share) => told.push(share))).toBeNull();
    expect(told.length).toBe(3);
  });
});
