/** Round cylinder about the y axis with flat ends, the distance: a rectangle in the plane of axis and point. */
import { convexField, type Facets, requireSize, type ShapeKind, side } from './shape.ts';

export interface Cylinder {
  readonly type: 'cylinder';
  /** mm */
  readonly radius: number;
  /** half of the height, mm */
  readonly half: number;
}

export const cylinder: ShapeKind<Cylinder> = {
  name: 'cylinder',
  label: 'Cylinder',
  exact: true,
  examples: [
    { type: 'cylinder', radius: 6, half: 10 },
    { type: 'cylinder', radius: 10, half: 0.05 },
    { type: 'cylinder', radius: 1e-6, half: 3e-6 },
    { type: 'cylinder', radius: 1e6, half: 3e6 },
  ],
  takes: ['f32', 'f32'],
  numbers: ({ radius, half }) => [radius, half],
  bind({ radius, half }) {
    requireSize(radius, 'radius');
    requireSize(half, 'half');
    const field = convexField([radius, half, radius], {
      value(x, y, z) {
        const across = Math.sqrt(x * x + z * z) - radius;
        const along = Math.abs(y) - half;
        const oa = Math.max(across, 0);
        const ol = Math.max(along, 0);
        return -Math.sqrt(oa * oa + ol * ol) - Math.min(Math.max(across, along), 0);
      },
      evaluate(x, y, z, out) {
        const rho = Math.sqrt(x * x + z * z);
        const across = rho - radius;
        const along = Math.abs(y) - half;
        const oa = Math.max(across, 0);
        const ol = Math.max(along, 0);
        const outside = Math.sqrt(oa * oa + ol * ol);
        // how much of the gradient points across and along; inside, the nearer face has all of it
        const toSide = outside > 0 ? oa / outside : across > along ? 1 : 0;
        const toEnd = outside > 0 ? ol / outside : across > along ? 0 : 1;
        const inverse = rho > 0 ? toSide / rho : 0;
        out[0] = outside > 0 ? -outside : -Math.max(across, along);
        out[1] = -x * inverse;
        out[2] = -side(y) * toEnd;
        out[3] = -z * inverse;
      },
    });
    return { ...field, facets: cylinderFacets(radius, half) };
  },
};

/** The side, the lower and the upper end. */
function cylinderFacets(radius: number, half: number): Facets {
  return {
    count: 3,
    nearest(x, y, z) {
      if (Math.sqrt(x * x + z * z) - radius >= Math.abs(y) - half) return 0;
      return y < 0 ? 1 : 2;
    },
    evaluate(facet, x, y, z, out) {
      out.fill(0, 0, 4);
      if (facet === 0) {
        const rho = Math.sqrt(x * x + z * z);
        out[0] = radius - rho;
        out[1] = rho > 0 ? -x / rho : 0;
        out[3] = rho > 0 ? -z / rho : 0;
        return;
      }
      const way = facet === 1 ? -1 : 1;
      out[0] = half - way * y;
      out[2] = -way;
    },
  };
}
