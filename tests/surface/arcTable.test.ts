import { describe, expect, test } from 'vitest';
import { arcTable } from '../../src/surface/arcTable.ts';

/** Counts its calls. */
function counted(f: (u: number) => number): { readonly f: (u: number) => number; calls: number } {
  const out = {
    calls: 0,
    f: (u: number) => {
      out.calls++;
      return f(u);
    },
  };
  return out;
}

describe('arc tables', () => {
  test('know the integral at every u, not only at cells', () => {
    const probe = counted((u) => 2 + Math.cos(19 * u) + 0.3 * Math.sin(50 * u));
    const exact = (u: number): number => 2 * u + Math.sin(19 * u) / 19 + (0.3 * (1 - Math.cos(50 * u))) / 50;
    const table = arcTable(probe.f, [0, 1]);
    for (let u = 0; u <= 1; u += 0.00317) expect(Math.abs(table.upTo(u) - exact(u))).toBeLessThan(1e-11);
    expect(table.whole).toBeCloseTo(exact(1), 12);
    // ten for a cell of the twelve, twenty for its halves; a few are halved again
    expect(probe.calls).toBeLessThan(1000);
  });

  test('kinks at breaks cost nothing, others little', () => {
    const at = counted((u) => Math.abs(u - 0.3));
    const table = arcTable(at.f, [0, 0.3, 1]);
    expect(table.upTo(0.3)).toBeCloseTo(0.045, 14);
    expect(table.upTo(0.65)).toBeCloseTo(0.045 + 0.35 ** 2 / 2, 14);
    expect(at.calls).toBeLessThan(500);
    const between = counted((u) => 1 + Math.max(u - 0.31415, 0) ** 2);
    const other = arcTable(between.f, [0, 1]);
    expect(Math.abs(other.upTo(0.5) - 0.5 - (0.5 - 0.31415) ** 3 / 3)).toBeLessThan(1e-10);
    expect(between.calls).toBeLessThan(800);
  });

  test('where the way turns back the least and the most are inside', () => {
    const table = arcTable((u) => (u < 0.25 ? 4 : -2), [0, 0.25, 1]);
    expect([table.least, table.most, table.whole]).toEqual([
      expect.closeTo(-0.5, 12),
      expect.closeTo(1, 12),
      expect.closeTo(-0.5, 12),
    ]);
  });
});
