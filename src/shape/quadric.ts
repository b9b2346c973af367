/**
 * Where g = pᵀA p + b·p + c is positive: paraboloids, cones, hyperboloids, slanted ellipsoids. No distance:
 * f = g / √(|∇g|² + k|g|), k = √Σ A_ij², has |∇f| = 1 on the surface (Taubin's first-order distance) and the second
 * term keeps it finite where ∇g = 0 inside. At the tip of a cone value and gradient are 0.
 */
import { type Box, FieldError } from '../skeleton/skeleton.ts';
import { flatSpread, ROUNDING, type ShapeKind } from './shape.ts';

export interface Quadric {
  readonly type: 'quadric';
  /** of x², y², z²; 1/mm if g is in mm, but any unit will do */
  readonly squares: readonly [xx: number, yy: number, zz: number];
  /** of yz, zx, xy */
  readonly products: readonly [yz: number, zx: number, xy: number];
  /** of x, y, z */
  readonly linear: readonly [x: number, y: number, z: number];
  readonly constant: number;
}

export const quadric: ShapeKind<Quadric> = {
  name: 'quadric',
  label: 'Quadric',
  exact: false,
  examples: [
    { type: 'quadric', squares: [-1, 0, -1], products: [0, 0, 0], linear: [0, 10, 0], constant: 0 },
    { type: 'quadric', squares: [-1, 1, -1], products: [0, 0, 0], linear: [0, 0, 0], constant: 0 },
    { type: 'quadric', squares: [-1, 1, -1], products: [0, 0, 0], linear: [0, 0, 0], constant: 4 },
    { type: 'quadric', squares: [-2, -1, -3], products: [1, -1, 0.5], linear: [3, -2, 1], constant: 20 },
    {
      type: 'quadric',
      squares: [-1e12, -2e12, -1e12],
      products: [0, 0, 1e12],
      linear: [0, 0, 0],
      constant: 1,
    },
    {
      type: 'quadric',
      squares: [-1e-12, -2e-12, -1e-12],
      products: [0, 0, 1e-12],
      linear: [0, 0, 0],
      constant: 1,
    },
  ],
  takes: ['vec3f', 'vec3f', 'vec3f', 'f32'],
  numbers: ({ squares, products, linear, constant }) => [...squares, ...products, ...linear, constant],
  bind(shape) {
    const numbers = quadric.numbers(shape);
    const wrong = numbers.find((value) => !Number.isFinite(value));
    if (wrong !== undefined) throw new FieldError(`coefficients must be numbers, got ${wrong}`);
    if (numbers.slice(0, 9).every((value) => value === 0))
      throw new FieldError('all coefficients of x, y, z are 0');
    const [xx, yy, zz] = shape.squares;
    const [yz, zx, xy] = shape.products;
    const [bx, by, bz] = shape.linear;
    const c = shape.constant;
    const k = Math.sqrt(xx * xx + yy * yy + zz * zz + 0.5 * (yz * yz + zx * zx + xy * xy));
    const size = Math.sqrt(bx * bx + by * by + bz * bz);
    const boxAbove = (level: number) => ellipsoidBox(shape, k, level);
    return {
      value(x, y, z) {
        const gx = 2 * xx * x + zx * z + xy * y + bx;
        const gy = 2 * yy * y + yz * z + xy * x + by;
        const gz = 2 * zz * z + yz * y + zx * x + bz;
        const g = 0.5 * (x * (gx + bx) + y * (gy + by) + z * (gz + bz)) + c;
        const d = gx * gx + gy * gy + gz * gz + k * Math.abs(g);
        return d > 0 ? g * (1 / Math.sqrt(d)) : 0;
      },
      evaluate(x, y, z, out) {
        const gx = 2 * xx * x + zx * z + xy * y + bx;
        const gy = 2 * yy * y + yz * z + xy * x + by;
        const gz = 2 * zz * z + yz * y + zx * x + bz;
        const g = 0.5 * (x * (gx + bx) + y * (gy + by) + z * (gz + bz)) + c;
        const d = gx * gx + gy * gy + gz * gz + k * Math.abs(g);
        const inverse = d > 0 ? 1 / Math.sqrt(d) : 0;
        // ∇f = ∇g d^−½ − ½ g d^−3/2 ∇d, ∇d = 2 H ∇g + k sign(g) ∇g, H the second derivatives of g
        const share = g * inverse * inverse;
        const own = 1 - 0.5 * k * Math.abs(share);
        out[0] = g * inverse;
        out[1] = inverse * (own * gx - share * (2 * xx * gx + xy * gy + zx * gz));
        out[2] = inverse * (own * gy - share * (xy * gx + 2 * yy * gy + yz * gz));
        out[3] = inverse * (own * gz - share * (zx * gx + yz * gy + 2 * zz * gz));
      },
      spread(x, y, z, radius, out) {
        const gx = 2 * xx * x + zx * z + xy * y + bx;
        const gy = 2 * yy * y + yz * z + xy * x + by;
        const gz = 2 * zz * z + yz * y + zx * x + bz;
        const g = 0.5 * (x * (gx + bx) + y * (gy + by) + z * (gz + bz)) + c;
        const slope = Math.sqrt(gx * gx + gy * gy + gz * gz);
        const p = Math.sqrt(x * x + y * y + z * z) + radius;
        const rounding = ROUNDING * (k * p + size);
        const move = radius * (slope + k * radius) + rounding * p + ROUNDING * Math.abs(c);
        // 2k bounds the second derivatives; f rises with g, and |f| falls with |∇g|
        const least = Math.max(slope - 2 * k * radius - rounding, 0);
        const most = slope + 2 * k * radius + rounding;
        const low = taubin(g - move, g - move > 0 ? most : least, k);
        const high = taubin(g + move, g + move > 0 ? least : most, k);
        flatSpread(low - ROUNDING * Math.abs(low), high + ROUNDING * Math.abs(high), out);
      },
      box: boxAbove(0),
      boxAbove,
    };
  },
};

/** f of g and |∇g|. */
function taubin(g: number, slope: number, k: number): number {
  const d = slope * slope + k * Math.abs(g);
  return d > 0 ? g / Math.sqrt(d) : 0;
}

/**
 * Of g > 0 when −A is positive definite, else null: centre m = −A⁻¹b/2, half sizes √(g(m) (−A⁻¹)_ii). Grown for a lower
 * level as the ellipsoid is: |f| ≥ h (q − 1/q), h = √(g(m)/(4 λ + k)), λ ≤ the trace of −A.
 */
function ellipsoidBox(shape: Quadric, k: number, level: number): Box | null {
  const [a, b, c] = shape.squares.map((v) => -v) as [number, number, number];
  const [f, e, d] = shape.products.map((v) => -0.5 * v) as [number, number, number];
  const [ca, cb, cc] = [b * c - f * f, a * c - e * e, a * b - d * d];
  const det = a * ca - d * (d * c - e * f) + e * (d * f - b * e);
  if (!(a > 0 && cc > 0 && det > 0)) return null;
  const [cd, ce, cf] = [e * f - d * c, d * f - b * e, d * e - a * f];
  const [lx, ly, lz] = shape.linear;
  const mx = (ca * lx + cd * ly + ce * lz) / (2 * det);
  const my = (cd * lx + cb * ly + cf * lz) / (2 * det);
  const mz = (ce * lx + cf * ly + cc * lz) / (2 * det);
  const top = shape.constant + 0.5 * (mx * lx + my * ly + mz * lz);
  if (!(top > 0)) throw new FieldError('the quadric has no inside');
  const h = -level / (2 * Math.sqrt(top / (4 * (a + b + c) + k)));
  const q = h + Math.sqrt(1 + h * h);
  const [hx, hy, hz] = [ca, cb, cc].map((minor) => q * Math.sqrt((top * minor) / det)) as [
    number,
    number,
    number,
  ];
  return { min: [mx - hx, my - hy, mz - hz], max: [mx + hx, my + hy, mz + hz] };
}
