/**
 * Box about the origin, the distance. Outside an edge or a corner the surfaces of equal value are round. Inside, where
 * two faces are equally near, the gradient is that of the first of them.
 */
import type { FieldValue } from '../skeleton/skeleton.ts';
import { convexField, type Facets, requireSize, type ShapeKind, side } from './shape.ts';

export interface BoxShape {
  readonly type: 'box';
  /** half of the edges, mm */
  readonly half: readonly [x: number, y: number, z: number];
}

export const box: ShapeKind<BoxShape> = {
  name: 'box',
  label: 'Box',
  exact: true,
  examples: [
    { type: 'box', half: [10, 6, 8] },
    { type: 'box', half: [20, 0.05, 5] },
    { type: 'box', half: [1e-6, 2e-6, 3e-6] },
    { type: 'box', half: [1e6, 2e6, 3e6] },
  ],
  takes: ['vec3f'],
  numbers: ({ half }) => half,
  bind({ half }) {
    half.forEach((size, i) => {
      requireSize(size, `half[${i}]`);
    });
    const [hx, hy, hz] = half;
    const field = convexField(half, {
      value: (x, y, z) => boxValue(Math.abs(x) - hx, Math.abs(y) - hy, Math.abs(z) - hz),
      evaluate(x, y, z, out) {
        boxEvaluate(x, y, z, Math.abs(x) - hx, Math.abs(y) - hy, Math.abs(z) - hz, out);
      },
    });
    return { ...field, facets: boxFacets(half) };
  },
};

/** The faces: −x, x, −y, y, −z, z. */
function boxFacets(half: BoxShape['half']): Facets {
  return {
    count: 6,
    nearest(x, y, z) {
      const [dx, dy, dz] = [Math.abs(x) - half[0], Math.abs(y) - half[1], Math.abs(z) - half[2]];
      if (dx >= dy && dx >= dz) return x < 0 ? 0 : 1;
      return dy >= dz ? (y < 0 ? 2 : 3) : z < 0 ? 4 : 5;
    },
    evaluate(facet, x, y, z, out) {
      const axis = facet >> 1;
      const way = (facet & 1) === 0 ? -1 : 1;
      out.fill(0, 0, 4);
      out[0] = half[axis]! - way * (axis === 0 ? x : axis === 1 ? y : z);
      out[1 + axis] = -way;
    },
  };
}

/** By how far the point lies beyond each pair of faces (negative: inside). */
export function boxValue(dx: number, dy: number, dz: number): number {
  const ox = Math.max(dx, 0);
  const oy = Math.max(dy, 0);
  const oz = Math.max(dz, 0);
  return -Math.sqrt(ox * ox + oy * oy + oz * oz) - Math.min(Math.max(dx, dy, dz), 0);
}

/** The same with gradient. */
export function boxEvaluate(
  x: number,
  y: number,
  z: number,
  dx: number,
  dy: number,
  dz: number,
  out: FieldValue,
): void {
  const ox = Math.max(dx, 0);
  const oy = Math.max(dy, 0);
  const oz = Math.max(dz, 0);
  const outside = Math.sqrt(ox * ox + oy * oy + oz * oz);
  if (outside > 0) {
    out[0] = -outside;
    out[1] = (-side(x) * ox) / outside;
    out[2] = (-side(y) * oy) / outside;
    out[3] = (-side(z) * oz) / outside;
    return;
  }
  const nearest = Math.max(dx, dy, dz);
  out[0] = -nearest;
  out[1] = dx === nearest ? -side(x) : 0;
  out[2] = dx < nearest && dy === nearest ? -side(y) : 0;
  out[3] = dx < nearest && dy < nearest ? -side(z) : 0;
}
