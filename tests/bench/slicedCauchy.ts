/** The Cauchy kernel over a triangle: slices along its longest side in closed form, Gauss points across. */
import { fastAtan2 } from '../../src/math/atan.ts';
import { GAUSS, type GaussPoints, type GaussRule } from '../../src/math/gaussLegendre.ts';
import type { BasedTriangle } from './basedTriangle.ts';
import type { Grid, Timed } from './timing.ts';

const POINTS: readonly GaussPoints[] = [3, 4, 5, 6, 10, 16];
/** the last resort: two panels of sixteen */
const RULES: readonly GaussRule[] = [...POINTS.map((points) => GAUSS[points]), twice(GAUSS[16])];

/** With the fewest points that come as near to `truth` as `allowed`, everywhere on the grid. */
export function fewestSlices(triangle: BasedTriangle, truth: Timed, grid: Grid, allowed: number): Timed {
  for (const rule of RULES) {
    const sliced = new SlicedTriangle(triangle, rule);
    if (isNear(sliced, truth, grid, allowed)) return sliced;
  }
  throw new Error('no rule integrates this triangle');
}

function isNear(some: Timed, other: Timed, { x, y, z }: Grid, allowed: number): boolean {
  for (const px of x)
    for (const py of y)
      for (const pz of z)
        if (!(Math.abs(some.value(px, py, pz) - other.value(px, py, pz)) <= allowed)) return false;
  return true;
}

class SlicedTriangle implements Timed {
  private readonly triangle: BasedTriangle;
  private readonly rule: GaussRule;

  constructor(triangle: BasedTriangle, rule: GaussRule) {
    this.triangle = triangle;
    this.rule = rule;
  }

  value(x: number, y: number, z: number): number {
    const { per, ax, ay, ux, uy, base, top, height, side } = this.triangle;
    const { nodes, weights } = this.rule;
    const vx = x * per - ax;
    const vy = y * per - ay;
    const vz = z * per;
    const px = vx * ux + vy * uy;
    const py = side * (vy * ux - vx * uy);
    let sum = 0;
    for (let i = 0; i < nodes.length; i++) {
      const part = 0.5 + 0.5 * nodes[i]!;
      const across = part * height - py;
      const m2 = 1 + vz * vz + across * across;
      const m = Math.sqrt(m2);
      const alpha = part * top - px;
      const length = base * (1 - part);
      const ends = alpha * (alpha + length);
      const re = m2 + ends;
      const im = length * m;
      const angle = fastAtan2(im, re) / m;
      sum += (weights[i]! * (angle + (length * (m2 - ends)) / (re * re + im * im))) / m2;
    }
    return (0.25 * height * sum) / (per * per);
  }
}

function twice({ nodes, weights }: GaussRule): GaussRule {
  const half = (shift: number) => [...nodes].map((node) => 0.5 * (node + shift));
  return {
    nodes: Float64Array.from([...half(-1), ...half(1)]),
    weights: Float64Array.from([...weights, ...weights], (weight) => 0.5 * weight),
  };
}
