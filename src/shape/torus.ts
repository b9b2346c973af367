/** Ring about the y axis, the distance. On the axis the gradient's part across it is zero. */
import { FieldError } from '../skeleton/skeleton.ts';
import { distanceField, requireSize, type ShapeKind } from './shape.ts';

export interface Torus {
  readonly type: 'torus';
  /** of the circle in the middle of the ring, mm */
  readonly ring: number;
  /** of the ring itself, mm; at most `ring` */
  readonly tube: number;
}

export const torus: ShapeKind<Torus> = {
  name: 'torus',
  label: 'Ring',
  exact: true,
  examples: [
    { type: 'torus', ring: 10, tube: 3 },
    { type: 'torus', ring: 4, tube: 4 },
    { type: 'torus', ring: 50, tube: 2 },
    { type: 'torus', ring: 2e-6, tube: 1e-6 },
    { type: 'torus', ring: 2e6, tube: 1e6 },
  ],
  takes: ['f32', 'f32'],
  numbers: ({ ring, tube }) => [ring, tube],
  bind({ ring, tube }) {
    requireSize(ring, 'ring');
    requireSize(tube, 'tube');
    if (tube > ring) throw new FieldError(`tube must be at most ring (${ring}), got ${tube}`);
    return distanceField([ring + tube, tube, ring + tube], {
      value(x, y, z) {
        const across = Math.sqrt(x * x + z * z) - ring;
        return tube - Math.sqrt(across * across + y * y);
      },
      evaluate(x, y, z, out) {
        const rho = Math.sqrt(x * x + z * z);
        const across = rho - ring;
        const distance = Math.sqrt(across * across + y * y);
        const inverse = distance > 0 ? 1 / distance : 0;
        const outwards = rho > 0 ? (across * inverse) / rho : 0;
        out[0] = tube - distance;
        out[1] = -x * outwards;
        out[2] = -y * inverse;
        out[3] = -z * outwards;
      },
    });
  },
};
