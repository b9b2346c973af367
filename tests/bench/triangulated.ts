/**
 * Zhu et al.'s other two strategies, on the triangles of a polygon. CIT: our sum over edges, a triangle at a time. DIT: a double
 * integral over each triangle, which the papers do not give; here slices along the longest side, each in the kernel's closed form
 * of constant weight, and Gauss points across them, clipped to what the kernel reaches. It gets the fewest points that
 * are right to 1e-6 of the whole plate (polygon.time.ts checks it), and skips triangles beyond a support, which ours does not.
 */
import earcut, { deviation, flatten } from 'earcut';
import type { Kernel } from '../../src/kernel/kernel.ts';
import { fastAtan2 } from '../../src/math/atan.ts';
import { GAUSS, type GaussPoints, type GaussRule } from '../../src/math/gaussLegendre.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import type { PolygonSkel } from '../../src/skeleton/skels.ts';
import { bound, paramsOf, type Timed } from './timing.ts';

type Triangle = readonly [Vec2, Vec2, Vec2];

/** Throws for an outline that crosses itself: its triangles cover something else. */
export function trianglesOf({ loops }: PolygonSkel): readonly Triangle[] {
  const { vertices, holes, dimensions } = flatten(loops.map((loop) => loop.map(([x, y]) => [x, y])));
  const indices = earcut(vertices, holes, dimensions);
  if (deviation(vertices, holes, dimensions, indices) > 1e-12) throw new Error('the outline crosses itself');
  const corner = (i: number): Vec2 => [vertices[2 * indices[i]!]!, vertices[2 * indices[i]! + 1]!];
  return Array.from({ length: indices.length / 3 }, (_, i) => [
    corner(3 * i),
    corner(3 * i + 1),
    corner(3 * i + 2),
  ]);
}

/** CIT: the sum over edges of every triangle. */
export function edgesOfTriangles(skel: PolygonSkel, kernel: Kernel): readonly Timed[] {
  return trianglesOf(skel).map((triangle) => bound({ ...skel, loops: [triangle] }, kernel));
}

/** ∫ f over alpha…beta of a line at squared distance rho2, kernel units. */
type Slice = (rho2: number, alpha: number, beta: number) => number;

const SLICES: Readonly<Record<string, Slice>> = {
  quartic(rho2, alpha, beta) {
    const g2 = 1 - rho2;
    const g = Math.sqrt(g2 > 0 ? g2 : 0);
    const low = alpha < -g ? -g : alpha > g ? g : alpha;
    const high = beta > g ? g : beta < -g ? -g : beta;
    return primitive(g2, high) - primitive(g2, low);
  },
  cauchy(rho2, alpha, beta) {
    const m2 = 1 + rho2;
    const m = Math.sqrt(m2);
    const length = beta - alpha;
    const x = m2 + alpha * beta;
    const y = length * m;
    return (fastAtan2(y, x) / m + (length * (m2 - alpha * beta)) / (x * x + y * y)) / (2 * m2);
  },
};

/** of (g² − τ²)² */
const primitive = (g2: number, t: number): number => t * (g2 * g2 + t * t * ((-2 / 3) * g2 + 0.2 * t * t));

/** DIT: a double integral over every triangle. The polygon lies in the plane z = 0. */
export function slicesOfTriangles(skel: PolygonSkel, kernel: Kernel, points: GaussPoints): readonly Timed[] {
  const per = 1 / kernel.unit(paramsOf(kernel), 1);
  const slice = SLICES[kernel.name]!;
  const scaled = ([x, y]: Vec2): Vec2 => [x * per, y * per];
  return trianglesOf(skel).map(
    ([a, b, c]) =>
      new SlicedTriangle([scaled(a), scaled(b), scaled(c)], slice, GAUSS[points], per, kernel.support),
  );
}

class SlicedTriangle implements Timed {
  private readonly ax: number;
  private readonly ay: number;
  /** along the longest side */
  private readonly ux: number;
  private readonly uy: number;
  private readonly base: number;
  /** the corner opposite to it */
  private readonly top: number;
  private readonly height: number;
  /** 1 where it lies on the left */
  private readonly side: number;
  private readonly slice: Slice;
  private readonly rule: GaussRule;
  private readonly per: number;
  private readonly support: number;

  constructor(corners: Triangle, slice: Slice, rule: GaussRule, per: number, support: number) {
    this.slice = slice;
    this.rule = rule;
    this.per = per;
    this.support = support;
    const sides = corners.map((corner, i) => distance(corner, corners[(i + 1) % 3]!));
    const longest = sides.indexOf(Math.max(...sides));
    const [a, b, c] = [0, 1, 2].map((i) => corners[(longest + i) % 3]!) as [Vec2, Vec2, Vec2];
    [this.ax, this.ay] = a;
    this.base = sides[longest]!;
    this.ux = (b[0] - a[0]) / this.base;
    this.uy = (b[1] - a[1]) / this.base;
    this.top = (c[0] - a[0]) * this.ux + (c[1] - a[1]) * this.uy;
    const height = (c[1] - a[1]) * this.ux - (c[0] - a[0]) * this.uy;
    this.height = Math.abs(height);
    this.side = Math.sign(height);
  }

  value(x: number, y: number, z: number): number {
    const { per, ux, uy, base, top, height, support, slice } = this;
    const vx = x * per - this.ax;
    const vy = y * per - this.ay;
    const vz = z * per;
    const px = vx * ux + vy * uy;
    const py = this.side * (vy * ux - vx * uy);
    const reach2 = support * support - vz * vz;
    if (reach2 <= 0 || px > base + support || px < -support) return 0;
    const reach = Math.sqrt(reach2);
    const low = py - reach > 0 ? py - reach : 0;
    const high = py + reach < height ? py + reach : height;
    if (low >= high) return 0;
    const { nodes, weights } = this.rule;
    const half = 0.5 * (high - low);
    const middle = low + half;
    let sum = 0;
    for (let i = 0; i < nodes.length; i++) {
      const h = middle + half * nodes[i]!;
      const left = (top * h) / height;
      const right = base - ((base - top) * h) / height;
      sum += weights[i]! * slice(vz * vz + (h - py) * (h - py), left - px, right - px);
    }
    return (half * sum) / (per * per);
  }
}

const distance = (a: Vec2, b: Vec2): number => Math.hypot(a[0] - b[0], a[1] - b[1]);
