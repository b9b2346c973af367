/** All that lies behind a plane: f = offset − n·p, the distance; unbounded. */
import { FieldError } from '../skeleton/skeleton.ts';
import { ROUNDING, type ShapeKind } from './shape.ts';

export interface HalfSpace {
  readonly type: 'halfSpace';
  /** out of the inside; any length but 0 */
  readonly normal: readonly [x: number, y: number, z: number];
  /** of the plane from the origin along the normal, mm */
  readonly offset: number;
}

export const halfSpace: ShapeKind<HalfSpace> = {
  name: 'halfSpace',
  label: 'Half-space',
  exact: true,
  examples: [
    { type: 'halfSpace', normal: [0, 1, 0], offset: 0 },
    { type: 'halfSpace', normal: [3, -4, 12], offset: -5 },
    { type: 'halfSpace', normal: [1e-6, 1e-6, 0], offset: 1e-6 },
    { type: 'halfSpace', normal: [1e6, 0, 2e6], offset: 1 },
  ],
  takes: ['vec3f', 'f32'],
  numbers: ({ normal, offset }) => [...unit(normal), offset],
  bind({ normal, offset }) {
    if (!Number.isFinite(offset)) throw new FieldError(`offset must be a number in mm, got ${offset}`);
    const [nx, ny, nz] = unit(normal);
    return {
      value: (x, y, z) => offset - (nx * x + ny * y + nz * z),
      evaluate(x, y, z, out) {
        out[0] = offset - (nx * x + ny * y + nz * z);
        out[1] = -nx;
        out[2] = -ny;
        out[3] = -nz;
      },
      spread(x, y, z, radius, out) {
        const value = offset - (nx * x + ny * y + nz * z);
        const rest = ROUNDING * (Math.abs(x) + Math.abs(y) + Math.abs(z) + Math.abs(offset) + radius);
        out[0] = value;
        out[1] = -nx;
        out[2] = -ny;
        out[3] = -nz;
        out[4] = rest;
        out[5] = value - radius - rest;
        out[6] = value + radius + rest;
      },
      box: null,
      boxAbove: () => null,
    };
  },
};

function unit([x, y, z]: HalfSpace['normal']): readonly [x: number, y: number, z: number] {
  const length = Math.sqrt(x * x + y * y + z * z);
  if (!(length > 0 && length < Infinity))
    throw new FieldError(`normal must have a direction, got ${[x, y, z]}`);
  return [x / length, y / length, z / length];
}
