/**
 * Ellipsoid about the origin, axes along x, y, z. No distance (that needs the root of a sextic): with q = p/r and
 * n = q/r in units of the smallest radius m, f = m g / √(4|n|² + max(g, 0)), g = 1 − |q|². On the surface |∇f| = 1;
 * at the centre f = m; outside about half the distance, far away.
 *
 * Tried instead: |q| (1 − |q|) / |n|, whose value at the centre depends on the direction one comes from.
 */
import { boxAbout, flatSpread, ROUNDING, requireSize, type ShapeKind } from './shape.ts';

export interface Ellipsoid {
  readonly type: 'ellipsoid';
  /** mm */
  readonly radii: readonly [x: number, y: number, z: number];
}

export const ellipsoid: ShapeKind<Ellipsoid> = {
  name: 'ellipsoid',
  label: 'Ellipsoid',
  exact: false,
  examples: [
    { type: 'ellipsoid', radii: [12, 8, 6] },
    { type: 'ellipsoid', radii: [20, 0.5, 1] },
    { type: 'ellipsoid', radii: [5, 5, 0.1] },
    { type: 'ellipsoid', radii: [1e-6, 2e-6, 3e-6] },
    { type: 'ellipsoid', radii: [1e6, 2e6, 3e6] },
  ],
  takes: ['vec3f'],
  numbers: ({ radii }) => radii,
  bind({ radii }) {
    radii.forEach((radius, i) => {
      requireSize(radius, `radii[${i}]`);
    });
    const [rx, ry, rz] = radii;
    const least = Math.min(rx, ry, rz);
    const [ex, ey, ez] = [least / rx, least / ry, least / rz];
    const flattest = Math.min(ex, ey, ez);
    /** |q| where f falls to −c: f ≤ −m (|q| − 1/|q|)/2 outside */
    const boxAbove = (level: number) => {
      const h = -level / least;
      const grown = h + Math.sqrt(1 + h * h);
      return boxAbout([rx * grown, ry * grown, rz * grown]);
    };
    return {
      value(x, y, z) {
        const qx = x / rx;
        const qy = y / ry;
        const qz = z / rz;
        const nx = qx * ex;
        const ny = qy * ey;
        const nz = qz * ez;
        const g = 1 - (qx * qx + qy * qy + qz * qz);
        return (least * g) / Math.sqrt(4 * (nx * nx + ny * ny + nz * nz) + Math.max(g, 0));
      },
      evaluate(x, y, z, out) {
        const qx = x / rx;
        const qy = y / ry;
        const qz = z / rz;
        const nx = qx * ex;
        const ny = qy * ey;
        const nz = qz * ez;
        const g = 1 - (qx * qx + qy * qy + qz * qz);
        const d = 4 * (nx * nx + ny * ny + nz * nz) + Math.max(g, 0);
        const root = Math.sqrt(d);
        // f = m g d^−½; ∇g = −2 n/m and ∇d = 8 n e²/m + [g > 0] ∇g, e = m/r, all along one axis
        const slope = g / (2 * d);
        const inner = g > 0 ? slope : 0;
        out[0] = (least * g) / root;
        out[1] = (nx / root) * (-2 + 2 * inner - 8 * slope * ex * ex);
        out[2] = (ny / root) * (-2 + 2 * inner - 8 * slope * ey * ey);
        out[3] = (nz / root) * (-2 + 2 * inner - 8 * slope * ez * ez);
      },
      spread(x, y, z, radius, out) {
        const grown = radius + ROUNDING * (Math.abs(x) + Math.abs(y) + Math.abs(z));
        const [x0, y0, z0] = [nearest(x, grown) / rx, nearest(y, grown) / ry, nearest(z, grown) / rz];
        const [x1, y1, z1] = [
          (Math.abs(x) + grown) / rx,
          (Math.abs(y) + grown) / ry,
          (Math.abs(z) + grown) / rz,
        ];
        const far2 = x1 * x1 + y1 * y1 + z1 * z1;
        const least2 = x0 * x0 * ex * ex + y0 * y0 * ey * ey + z0 * z0 * ez * ez;
        const most2 = x1 * x1 * ex * ex + y1 * y1 * ey * ey + z1 * z1 * ez * ez;
        const low = 1 - far2 - ROUNDING * (1 + far2);
        const high = 1 - (x0 * x0 + y0 * y0 + z0 * z0) + ROUNDING * (1 + far2);
        // f rises with g; with |n|² it falls where g > 0 and rises where g < 0, where |n| ≥ |q| times the least of e
        const thin2 = Math.max(least2, far2 * flattest * flattest);
        const bottom = low > 0 ? 4 * most2 + low : 4 * thin2;
        const top = high > 0 ? 4 * least2 + high : 4 * most2;
        const rounding = ROUNDING * least;
        flatSpread(
          (least * low) / Math.sqrt(bottom) - rounding,
          (least * high) / Math.sqrt(top) + rounding,
          out,
        );
      },
      box: boxAbove(0),
      boxAbove,
    };
  },
};

/** The least |x| within `radius`. */
const nearest = (x: number, radius: number) => Math.max(Math.abs(x) - radius, 0);
