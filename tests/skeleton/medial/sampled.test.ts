/** Outlines from the places of a pen. */
import { describe, expect, it } from 'vitest';
import type { Vec2 } from '../../../src/math/vec.ts';
import { outlineOf } from '../../../src/skeleton/medial/sampled.ts';
import { random } from '../../fixtures/random.ts';
import { blob, box, disc, SHAPES } from '../../fixtures/silhouettes.ts';

const sizeOf = (loop: readonly Vec2[]) =>
  Math.max(
    ...[0, 1].map((axis) => Math.max(...loop.map((p) => p[axis]!)) - Math.min(...loop.map((p) => p[axis]!))),
  );
const edges = (loop: readonly Vec2[]) =>
  loop.map((p, i) => [p[0] - loop.at(i - 1)![0], p[1] - loop.at(i - 1)![1]] as const);
/** as a pen goes: every half millimetre, back at the start */
const drawn = (loop: readonly Vec2[]): Vec2[] =>
  [...loop, loop[0]!].flatMap((b, i, all) => {
    const a = all[Math.max(i - 1, 0)]!;
    const count = Math.max(1, Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1]) / 0.5));
    return Array.from({ length: count }, (_, k): Vec2 => {
      const t = (k + 1) / count;
      return [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
    });
  });

describe('outlineOf', () => {
  it.each([
    ...Object.entries(SHAPES).map(([name, [outer]]) => [name, outer!] as const),
    ...[1, 2, 3].map((seed) => [`blob (seed ${seed})`, blob(seed)] as const),
  ])('%s: edges of at most 0.05 W, at least 0.01 W where they bend, near what was drawn', (_, loop) => {
    const found = outlineOf(drawn(loop))!;
    const size = sizeOf(loop);
    const parts = edges(found);
    for (const [i, [x, y]] of parts.entries()) {
      const length = Math.hypot(x, y);
      expect(length).toBeLessThanOrEqual(0.0525 * size);
      const [u, v] = parts[(i + 1) % parts.length]!;
      const turn = Math.abs(Math.atan2(x * v - y * u, x * u + y * v));
      // 0.01 along the way: a chord across the sharpest corner, 20°, is a sixth of it
      if (turn > Math.PI / 9) expect(length).toBeGreaterThan(0.0017 * size);
    }
    for (const [x, y] of found) {
      expect(Math.min(...drawn(loop).map(([u, v]) => Math.hypot(x - u, y - v)))).toBeLessThan(0.02 * size);
    }
  });

  it('is far fewer places where nothing bends', () => {
    expect(outlineOf(drawn(box(100, 100)))!.length).toBeLessThan(100);
    expect(outlineOf(drawn(box(100, 100)))!.length).toBeGreaterThan(75);
  });

  it('closes what is nearly closed, and no open line', () => {
    const ring = drawn(disc(30));
    expect(outlineOf(ring.slice(0, -6))).not.toBeNull();
    expect(outlineOf(ring.slice(0, Math.floor(ring.length / 2)))).toBeNull();
  });

  it('cuts what was drawn too far', () => {
    const ring = drawn(disc(30));
    const found = outlineOf([...ring, ...ring.slice(0, 9).map(([x, y]): Vec2 => [x - 1, y])])!;
    expect(found.length).toBeLessThan(outlineOf(ring)!.length + 3);
  });

  it('is none of nothing, and no number of none (seed 1)', () => {
    const next = random(1);
    expect(outlineOf([])).toBeNull();
    expect(
      outlineOf([
        [1, 1],
        [1, 1],
        [1, 1],
      ]),
    ).toBeNull();
    expect(
      outlineOf([
        [0, 0],
        [1, 0],
      ]),
    ).toBeNull();
    const ring = drawn(disc(20));
    const bad = ring.map((p): Vec2 => (next() < 0.1 ? [Number.NaN, p[1]] : p));
    for (const p of outlineOf(bad)!.flat()) expect(Number.isFinite(p)).toBe(true);
    for (const scale of [1e-6, 1e5]) {
      const places = ring.map(([x, y]): Vec2 => [scale * x, scale * y]);
      expect(outlineOf(places)!.length).toBe(outlineOf(ring)!.length);
    }
  });
});
