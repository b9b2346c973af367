/**
 * The quartic kernel over a triangle, exact. Along the longest side its primitive is P(X) = X (g⁴ − ⅔ g² X² + X⁴/5), |X| ≤ g,
 * g² = R² − z² − Y²; across, the primitive at either of the other sides is a polynomial of degree 5 in Y where the side lies
 * inside the disc (three Gauss points), and ±8/15 g⁵ where it lies outside, whose integral has an arc tangent.
 */
import { fastAtan2 } from '../../src/math/atan.ts';
import { GAUSS } from '../../src/math/gaussLegendre.ts';
import type { BasedTriangle } from './basedTriangle.ts';
import type { Timed } from './timing.ts';

const { nodes: NODES, weights: WEIGHTS } = GAUSS[3];

export const clippedQuartic = (triangle: BasedTriangle): Timed => new ClippedTriangle(triangle);

class ClippedTriangle implements Timed {
  private readonly triangle: BasedTriangle;

  constructor(triangle: BasedTriangle) {
    this.triangle = triangle;
  }

  value(x: number, y: number, z: number): number {
    const { per, ax, ay, ux, uy, base, top, height, side } = this.triangle;
    const r2 = 1 - z * per * (z * per);
    if (r2 <= 0) return 0;
    const r = Math.sqrt(r2);
    const vx = x * per - ax;
    const vy = y * per - ay;
    const px = vx * ux + vy * uy;
    const py = side * (vy * ux - vx * uy);
    const low = clamped(-py, r);
    const high = clamped(height - py, r);
    if (low >= high || px > base + r || px < -r) return 0;
    // X = at + steep Y
    const left = top / height;
    const right = (top - base) / height;
    const atRight = base - px + right * py;
    const atLeft = -px + left * py;
    return (alongSide(atRight, right, low, high, r2) - alongSide(atLeft, left, low, high, r2)) / (per * per);
  }
}

/** ∫ P(at + steep Y) dY over low…high, X clamped to the disc. */
function alongSide(at: number, steep: number, low: number, high: number, r2: number): number {
  const k = 1 + steep * steep;
  const discriminant = r2 * k - at * at;
  if (discriminant <= 0) return outside(at, low, high, r2);
  const root = Math.sqrt(discriminant);
  const from = between((-at * steep - root) / k, low, high);
  const to = between((-at * steep + root) / k, low, high);
  const half = 0.5 * (to - from);
  let sum = 0;
  for (let i = 0; i < 3; i++) {
    const y = from + half + half * NODES[i]!;
    const x = at + steep * y;
    const g2 = r2 - y * y;
    const x2 = x * x;
    sum += WEIGHTS[i]! * x * (g2 * g2 + x2 * (0.2 * x2 - (2 / 3) * g2));
  }
  const before = from > low ? outside(at + steep * low, low, from, r2) : 0;
  const after = to < high ? outside(at + steep * high, to, high, r2) : 0;
  return half * sum + before + after;
}

/** ±8/15 ∫ g⁵, with the sign of x. */
function outside(x: number, low: number, high: number, r2: number): number {
  const whole = (8 / 15) * (fifth(high, r2) - fifth(low, r2));
  return x < 0 ? -whole : whole;
}

/** a primitive of g⁵ */
function fifth(y: number, r2: number): number {
  const rest = r2 - y * y;
  const g2 = rest > 0 ? rest : 0;
  const g = Math.sqrt(g2);
  const angle = fastAtan2(y, g);
  return (y * g * (g2 * g2 + 1.25 * r2 * g2 + 1.875 * r2 * r2) + 1.875 * r2 * r2 * r2 * angle) / 6;
}

const clamped = (x: number, limit: number): number => (x < -limit ? -limit : x > limit ? limit : x);
const between = (x: number, low: number, high: number): number => (x < low ? low : x > high ? high : x);
