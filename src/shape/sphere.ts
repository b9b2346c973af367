/** Sphere about the origin: f = r − |p|, the distance. At the centre the gradient is zero. */
import { convexField, requireSize, type ShapeKind } from './shape.ts';

export interface Sphere {
  readonly type: 'sphere';
  /** mm */
  readonly radius: number;
}

export const sphere: ShapeKind<Sphere> = {
  name: 'sphere',
  label: 'Sphere',
  exact: true,
  examples: [
    { type: 'sphere', radius: 10 },
    { type: 'sphere', radius: 1e-6 },
    { type: 'sphere', radius: 1e6 },
  ],
  takes: ['f32'],
  numbers: ({ radius }) => [radius],
  bind({ radius }) {
    requireSize(radius, 'radius');
    return convexField([radius, radius, radius], {
      value: (x, y, z) => radius - Math.sqrt(x * x + y * y + z * z),
      evaluate(x, y, z, out) {
        const distance = Math.sqrt(x * x + y * y + z * z);
        const inverse = distance > 0 ? 1 / distance : 0;
        out[0] = radius - distance;
        out[1] = -x * inverse;
        out[2] = -y * inverse;
        out[3] = -z * inverse;
      },
    });
  },
};
