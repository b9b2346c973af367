import { expect, test } from 'vitest';
import { Growing } from '../../src/math/growing.ts';

test.each([Float64Array, Float32Array, Uint32Array])('%o keeps what was added', (make) => {
  const growing = new Growing<
    Float64Array<ArrayBuffer> | Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>
  >(make);
  const all = Array.from({ length: 30_000 }, (_, i) => i);
  for (let i = 0; i < all.length; i += 3) growing.push(i, i + 1, i + 2);
  expect(growing.length).toBe(all.length);
  expect([...growing.numbers()]).toEqual(all);
});

test('nothing was added', () => {
  expect(new Growing(Float32Array).numbers().length).toBe(0);
});
