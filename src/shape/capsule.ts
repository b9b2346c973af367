/** Cylinder about the y axis with round ends: the points within the radius of a segment, the distance. */
import { FieldError } from '../skeleton/skeleton.ts';
import { convexField, requireSize, type ShapeKind } from './shape.ts';

export interface Capsule {
  readonly type: 'capsule';
  /** mm */
  readonly radius: number;
  /** half of the segment (without the ends), mm; 0 is a sphere */
  readonly half: number;
}

export const capsule: ShapeKind<Capsule> = {
  name: 'capsule',
  label: 'Capsule',
  exact: true,
  examples: [
    { type: 'capsule', radius: 5, half: 10 },
    { type: 'capsule', radius: 5, half: 0 },
    { type: 'capsule', radius: 0.1, half: 100 },
    { type: 'capsule', radius: 1e-6, half: 3e-6 },
    { type: 'capsule', radius: 1e6, half: 3e6 },
  ],
  takes: ['f32', 'f32'],
  numbers: ({ radius, half }) => [radius, half],
  bind({ radius, half }) {
    requireSize(radius, 'radius');
    if (!(half >= 0 && half < Infinity)) throw new FieldError(`half must be at least 0 mm, got ${half}`);
    return convexField([radius, half + radius, radius], {
      value(x, y, z) {
        const beyond = y - Math.min(Math.max(y, -half), half);
        return radius - Math.sqrt(x * x + beyond * beyond + z * z);
      },
      evaluate(x, y, z, out) {
        const beyond = y - Math.min(Math.max(y, -half), half);
        const distance = Math.sqrt(x * x + beyond * beyond + z * z);
        const inverse = distance > 0 ? 1 / distance : 0;
        out[0] = radius - distance;
        out[1] = -x * inverse;
        out[2] = -beyond * inverse;
        out[3] = -z * inverse;
      },
    });
  },
};
