import { describe, expect, test } from 'vitest';
import { topology } from '../../src/mesh/check.ts';
import { bounds, volume } from '../../src/mesh/measure.ts';
import {
  buildSheet,
  buildSurface,
  type PlacedOutline,
  type SurfaceInput,
  type SurfaceKind,
  sheetMesh,
  surfaces,
} from '../../src/surface/index.ts';
import { joined, round } from '../../src/surface/joined.ts';
import { straight } from '../../src/surface/outline.ts';
import { FLAT, line, normalAgreement, TILTED } from './curves.ts';
import { mushroom, wave } from './outlines.ts';

const OPTIONS = { radius: 6, pressure: false, caps: true, u: 16, v: 16 };
/** as many strokes side by side as a surface wants */
const strokes = (count: number) =>
  Array.from({ length: count }, (_, i) => line([20 * i, 0], [25 * i, 30], [20 * i, 60]));
const solid: readonly PlacedOutline[] = [
  { u: 0.2, outline: joined(wave(0.8, 1), 'mirror') },
  { u: 0.8, outline: joined(mushroom, 'mirror') },
];
const inputOf = (count: number, sections = solid): SurfaceInput => ({
  curves: strokes(count),
  sections,
  bends: [],
});

describe('every surface of the list', () => {
  for (const [key, surface] of Object.entries(surfaces)) {
    const kind = key as SurfaceKind;
    const { least, most } = surface.strokes;

    test(`${key}: is what its key says`, () => {
      expect(surface.id).toBe(key);
      expect(surface.label).not.toBe('');
      expect(least).toBeLessThanOrEqual(most);
    });

    for (let count = least; count <= most; count++) {
      const input = inputOf(count);
      const of = `${key} of ${count}`;

      test(`${of}: a closed, outward, finite solid, texture from 0 to 1`, () => {
        const mesh = buildSurface(kind, input, TILTED, OPTIONS);
        expect(topology(mesh)).toMatchObject({
          watertight: true,
          components: 1,
          degenerate: 0,
          finite: true,
        });
        expect(volume(mesh)).toBeGreaterThan(0);
        for (const x of mesh.uvs) expect(x >= 0 && x <= 1).toBe(true);
      });

      test(`${of}: holds its strokes`, () => {
        const { min, max } = bounds(buildSurface(kind, input, FLAT, OPTIONS));
        for (const curve of input.curves) {
          for (const u of [0, 0.3, 0.7, 1]) {
            curve.point(u).forEach((x, axis) => {
              expect(x).toBeGreaterThan(min[axis]! - 0.5);
              expect(x).toBeLessThan(max[axis]! + 0.5);
            });
          }
        }
      });

      test(`${of}: without caps is open`, () => {
        expect(topology(buildSurface(kind, input, FLAT, { ...OPTIONS, caps: false })).watertight).toBe(false);
      });

      test(`${of}: the same strokes make the same bits`, () => {
        expect(buildSurface(kind, input, TILTED, OPTIONS)).toEqual(
          buildSurface(kind, input, TILTED, OPTIONS),
        );
      });

      test(`${of}: every row has its place on the spine, those of caps stiff`, () => {
        const sheet = buildSheet(kind, input, OPTIONS)!;
        const { stops } = sheet.spine;
        expect([stops[0], stops.at(-1)]).toEqual([0, 1]);
        for (const { at } of sheet.rows) expect(at.u >= 0 && at.u <= 1).toBe(true);
        const inner = sheet.rows.filter(({ at }) => !at.rigid).map(({ at }) => at.u);
        expect([...inner].sort((a, b) => a - b)).toEqual(inner);
        expect(inner.length).toBeLessThan(sheet.rows.length);
      });

      test(`${of}: bent, with a corner, stays closed and outward`, () => {
        const bend = {
          curve: line([0, 0], [3, 37], [25, 50]),
          plane: { origin: [10, 0, 0], x: [0, 0, -1], y: [0, 1, 0] } as const,
          keepsLength: false,
        };
        const mesh = buildSurface(kind, { ...input, bends: [bend] }, FLAT, OPTIONS);
        expect(topology(mesh)).toMatchObject({ watertight: true, components: 1, finite: true });
        expect(volume(mesh)).toBeGreaterThan(0);
        expect(normalAgreement(mesh)).toBeGreaterThan(-0.2);
        expect(bounds(mesh).min[2]).toBeLessThan(-20);
      });
    }

    test(`${key}: another number of strokes is refused`, () => {
      const take = new RegExp(`'${key}' takes .*${most} stroke`);
      expect(() => buildSurface(kind, inputOf(most + 1), FLAT, OPTIONS)).toThrow(take);
      expect(() => buildSurface(kind, inputOf(0), FLAT, OPTIONS)).toThrow(take);
    });
  }

  test('another kind is refused by name', () => {
    expect(() => buildSurface('pyramid' as SurfaceKind, inputOf(0), FLAT, OPTIONS)).toThrow(/pyramid/);
  });

  test('a sheet that is none is a mesh without triangles', () => {
    expect(sheetMesh(null, FLAT).indices).toHaveLength(0);
    const dots: SurfaceInput = { curves: [line([1, 1]), line([1, 1])], sections: [], bends: [] };
    for (const kind of ['rotational', 'crossSection'] as const)
      expect(buildSurface(kind, dots, FLAT, OPTIONS).indices).toHaveLength(0);
  });

  test('open sections make open sheets, whatever the caps', () => {
    const mesh = buildSurface('crossSection', inputOf(2, [{ u: 0.5, outline: straight }]), FLAT, OPTIONS);
    expect(topology(mesh)).toMatchObject({ watertight: false, components: 1, degenerate: 0 });
    expect(buildSurface('crossSection', inputOf(2, [{ u: 0, outline: round }]), FLAT, OPTIONS)).not.toEqual(
      mesh,
    );
  });
});
