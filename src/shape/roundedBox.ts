/** Box with rounded edges: the smaller box grown by the radius, the distance. `half` is the outer size. */
import { FieldError } from '../skeleton/skeleton.ts';
import { boxEvaluate, boxValue } from './box.ts';
import { convexField, requireSize, type ShapeKind } from './shape.ts';

export interface RoundedBox {
  readonly type: 'roundedBox';
  /** half of the outer edges, mm */
  readonly half: readonly [x: number, y: number, z: number];
  /** of the edges, mm; at most the smallest of `half` */
  readonly radius: number;
}

export const roundedBox: ShapeKind<RoundedBox> = {
  name: 'roundedBox',
  label: 'Rounded box',
  exact: true,
  examples: [
    { type: 'roundedBox', half: [10, 6, 8], radius: 2 },
    { type: 'roundedBox', half: [5, 5, 5], radius: 5 },
    { type: 'roundedBox', half: [1e-6, 2e-6, 3e-6], radius: 5e-7 },
    { type: 'roundedBox', half: [1e6, 2e6, 3e6], radius: 1e5 },
  ],
  takes: ['vec3f', 'f32'],
  numbers: ({ half, radius }) => [...half, radius],
  bind({ half, radius }) {
    half.forEach((size, i) => {
      requireSize(size, `half[${i}]`);
    });
    requireSize(radius, 'radius');
    if (radius > Math.min(...half)) {
      throw new FieldError(
        `radius must be at most the smallest of half (${Math.min(...half)}), got ${radius}`,
      );
    }
    const [ix, iy, iz] = [half[0] - radius, half[1] - radius, half[2] - radius];
    return convexField(half, {
      value: (x, y, z) => radius + boxValue(Math.abs(x) - ix, Math.abs(y) - iy, Math.abs(z) - iz),
      evaluate(x, y, z, out) {
        boxEvaluate(x, y, z, Math.abs(x) - ix, Math.abs(y) - iy, Math.abs(z) - iz, out);
        out[0]! += radius;
      },
    });
  },
};
