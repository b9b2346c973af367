import { describe, expect, it } from 'vitest';
import { place3, turnAbout, UNMOVED } from '../../src/math/placement.ts';
import { rotate3 } from '../../src/math/tuple.ts';
import type { Quat, Vec3 } from '../../src/math/vec.ts';
import { placed } from '../../src/mesh/placed.ts';
import { random } from '../fixtures/random.ts';
import { box } from './solids.ts';

const at = (values: Float32Array, i: number): Vec3 => [values[i]!, values[i + 1]!, values[i + 2]!];

describe('placed', () => {
  it('is the mesh itself where nothing was moved', () => {
    const mesh = box(1, 2, 3);
    expect(placed(mesh, UNMOVED)).toBe(mesh);
  });

  it.each([1, 2, 3])(
    'maps every vertex as place3 and every normal as rotate3 do, to the bit (seed %i)',
    (seed) => {
      const next = random(seed);
      const raw = [next() - 0.5, next() - 0.5, next() - 0.5, next() - 0.5] as const;
      const length = Math.hypot(...raw);
      const turn: Quat = [raw[0] / length, raw[1] / length, raw[2] / length, raw[3] / length];
      const placement = turnAbout([10 * next(), 20 * next(), 30 * next()], turn, [next(), next(), next()]);
      const mesh = box(30 * next(), 30 * next(), 30 * next(), [next(), next(), next()]);
      const moved = placed(mesh, placement);
      for (let i = 0; i < mesh.positions.length; i += 3) {
        expect(at(moved.positions, i)).toEqual(place3(placement, at(mesh.positions, i)).map(Math.fround));
        expect(at(moved.normals, i)).toEqual(rotate3(turn, at(mesh.normals, i)).map(Math.fround));
      }
      expect(moved.indices).toBe(mesh.indices);
    },
  );
});
