import { describe, expect, test } from 'vitest';
import { topology } from '../../src/mesh/check.ts';
import { bounds, volume } from '../../src/mesh/measure.ts';
import { buildSurface, type SurfaceKind, surfaces } from '../../src/surface/index.ts';
import { FLAT, line, TILTED } from './curves.ts';

const OPTIONS = { radius: 6, pressure: false, caps: true, u: 16, v: 16 };
/** as many strokes side by side as a surface wants */
const strokes = (count: number) =>
  Array.from({ length: count }, (_, i) => line([20 * i, 0], [25 * i, 30], [20 * i, 60]));

describe('every surface of the list', () => {
  for (const [key, surface] of Object.entries(surfaces)) {
    const curves = strokes(surface.strokes);
    const kind = key as SurfaceKind;

    test(`${key}: is what its key says`, () => {
      expect(surface.id).toBe(key);
      expect(surface.label).not.toBe('');
    });

    test(`${key}: a closed, outward, finite solid, texture from 0 to 1`, () => {
      const mesh = buildSurface(kind, curves, TILTED, OPTIONS);
      expect(topology(mesh)).toMatchObject({ watertight: true, components: 1, degenerate: 0, finite: true });
      expect(volume(mesh)).toBeGreaterThan(0);
      for (const x of mesh.uvs) expect(x >= 0 && x <= 1).toBe(true);
    });

    test(`${key}: holds its strokes`, () => {
      const { min, max } = bounds(buildSurface(kind, curves, FLAT, OPTIONS));
      for (const curve of curves) {
        for (const u of [0, 0.3, 0.7, 1]) {
          curve.point(u).forEach((x, axis) => {
            expect(x).toBeGreaterThan(min[axis]! - 0.5);
            expect(x).toBeLessThan(max[axis]! + 0.5);
          });
        }
      }
    });

    test(`${key}: without caps is open, with another number of strokes refused`, () => {
      expect(topology(buildSurface(kind, curves, FLAT, { ...OPTIONS, caps: false })).watertight).toBe(false);
      const take = new RegExp(`'${key}' takes ${surface.strokes}`);
      expect(() => buildSurface(kind, strokes(surface.strokes + 1), FLAT, OPTIONS)).toThrow(take);
    });

    test(`${key}: the same strokes make the same bits`, () => {
      const [a, b] = [
        buildSurface(kind, curves, TILTED, OPTIONS),
        buildSurface(kind, curves, TILTED, OPTIONS),
      ];
      expect(a).toEqual(b);
    });
  }

  test('another kind is refused by name', () => {
    expect(() => buildSurface('pyramid' as SurfaceKind, [], FLAT, OPTIONS)).toThrow(/pyramid/);
  });
});
