/**
 * What each unknown of a fit does at the places of an outline, and what moves of nodes do.
 *
 * By Gauss points along the links: the places are about a radius away, so that six points for three radii of length are right to .4 %, and
 * one look at the kernel serves both weights, their gradients and the moves of both ends. The exact integrals took ten times as long.
 */
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import { GAUSS } from '../../math/gaussLegendre.ts';
import { whole } from '../binding.ts';
import type { MedialGraph } from './axis.ts';
import type { Layout } from './skelsOf.ts';

/** Rows of places: of each unknown by itself with a relative weight of 1. */
export interface Basis {
  readonly unknowns: number;
  readonly value: Float64Array;
  readonly dx: Float64Array;
  readonly dy: Float64Array;
  readonly dz: Float64Array;
  /** what the field gains as each node moves by a radius, to the right and up; none without weights */
  readonly shifts: Float64Array | null;
}

/** radii of the thinner end that six points are for */
const PANEL = 3;
const MOST_PANELS = 6;
/** kernel units, squared: singular kernels see no less */
const NEAREST2 = 1e-12;

/** `places` are x, y, z in turn; `x` are relative weights, for what moves do. */
export function basisAt(
  graph: MedialGraph,
  layout: Layout,
  scales: readonly number[],
  places: Float64Array,
  kernel: Kernel,
  params: KernelParams,
  x: readonly number[] | null,
): Basis {
  const unknowns = layout.nodes.length;
  const count = places.length / 3;
  const basis = {
    unknowns,
    value: new Float64Array(count * unknowns),
    dx: new Float64Array(count * unknowns),
    dy: new Float64Array(count * unknowns),
    dz: new Float64Array(count * unknowns),
    shifts: x ? new Float64Array(count * 2 * graph.nodes.length) : null,
  };
  const size = graph.nodes.reduce((most, { radius }) => Math.max(most, radius), 0);
  const sight = new Sight(
    basis,
    graph,
    layout,
    scales,
    places,
    kernel,
    kernel.unit(params, size),
    params.n ?? 4,
  );
  for (const [a, b] of graph.links) sight.addLink(a, b, x);
  for (let point = graph.nodes.length; point < unknowns; point++) sight.addPoint(point, x);
  return basis;
}

class Sight {
  readonly #basis: Basis;
  readonly #graph: MedialGraph;
  readonly #layout: Layout;
  readonly #scales: readonly number[];
  readonly #places: Float64Array;
  readonly #kernel: Kernel;
  readonly #exponent: number;
  readonly #per2: number;
  readonly #whole: number;

  constructor(
    basis: Basis,
    graph: MedialGraph,
    layout: Layout,
    scales: readonly number[],
    places: Float64Array,
    kernel: Kernel,
    unit: number,
    exponent: number,
  ) {
    this.#basis = basis;
    this.#graph = graph;
    this.#layout = layout;
    this.#scales = scales;
    this.#places = places;
    this.#kernel = kernel;
    this.#exponent = exponent;
    this.#per2 = 1 / (unit * unit);
    this.#whole = whole(unit, kernel.homogeneity);
  }

  addPoint(unknown: number, x: readonly number[] | null): void {
    const { value, dx, dy, dz, shifts, unknowns } = this.#basis;
    const node = this.#layout.nodeOf[unknown]!;
    const { at, radius } = this.#graph.nodes[node]!;
    const scale = this.#scales[unknown]! * this.#whole;
    const gain = x ? -radius * x[unknown]! : 0;
    for (let place = 0; place < this.#places.length / 3; place++) {
      const gx = this.#places[3 * place]! - at[0];
      const gy = this.#places[3 * place + 1]! - at[1];
      const gz = this.#places[3 * place + 2]!;
      const r2 = Math.max((gx * gx + gy * gy + gz * gz) * this.#per2, NEAREST2);
      const own = place * unknowns + unknown;
      const slope = 2 * scale * this.#per2 * this.#kernel.slope(r2, this.#exponent);
      value[own] = scale * this.#kernel.value(r2, this.#exponent);
      dx[own] = slope * gx;
      dy[own] = slope * gy;
      dz[own] = slope * gz;
      if (!shifts) continue;
      const row = 2 * (place * this.#graph.nodes.length + node);
      shifts[row] = shifts[row]! + gain * slope * gx;
      shifts[row + 1] = shifts[row + 1]! + gain * slope * gy;
    }
  }

  addLink(a: number, b: number, x: readonly number[] | null): void {
    const { value, dx, dy, dz, shifts, unknowns } = this.#basis;
    const { nodes } = this.#graph;
    const [p, q] = [nodes[a]!, nodes[b]!];
    const [ex, ey] = [q.at[0] - p.at[0], q.at[1] - p.at[1]];
    const length = Math.sqrt(ex * ex + ey * ey);
    if (!(length > 0)) return;
    const { t, share } = pointsOn(length / Math.min(p.radius, q.radius));
    const [scaleA, scaleB] = [
      this.#scales[a]! * this.#whole * length,
      this.#scales[b]! * this.#whole * length,
    ];
    const [xa, xb] = x ? [x[a]! * scaleA, x[b]! * scaleB] : [0, 0];
    for (let place = 0; place < this.#places.length / 3; place++) {
      const px = this.#places[3 * place]! - p.at[0];
      const py = this.#places[3 * place + 1]! - p.at[1];
      const gz = this.#places[3 * place + 2]!;
      let [va, vb, ax, ay, az, bx, by, bz, mx, my, nx, ny] = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
      for (let i = 0; i < t.length; i++) {
        const at = t[i]!;
        const gx = px - at * ex;
        const gy = py - at * ey;
        const r2 = Math.max((gx * gx + gy * gy + gz * gz) * this.#per2, NEAREST2);
        const f = share[i]! * this.#kernel.value(r2, this.#exponent);
        const g = 2 * this.#per2 * share[i]! * this.#kernel.slope(r2, this.#exponent);
        const [ga, gb] = [(1 - at) * g, at * g];
        va += (1 - at) * f;
        vb += at * f;
        ax += ga * gx;
        ay += ga * gy;
        az += ga * gz;
        bx += gb * gx;
        by += gb * gy;
        bz += gb * gz;
        const weight = xa * (1 - at) + xb * at;
        mx += weight * ga * gx;
        my += weight * ga * gy;
        nx += weight * gb * gx;
        ny += weight * gb * gy;
      }
      const row = place * unknowns;
      value[row + a] = value[row + a]! + scaleA * va;
      value[row + b] = value[row + b]! + scaleB * vb;
      dx[row + a] = dx[row + a]! + scaleA * ax;
      dx[row + b] = dx[row + b]! + scaleB * bx;
      dy[row + a] = dy[row + a]! + scaleA * ay;
      dy[row + b] = dy[row + b]! + scaleB * by;
      dz[row + a] = dz[row + a]! + scaleA * az;
      dz[row + b] = dz[row + b]! + scaleB * bz;
      if (!shifts) continue;
      // the piece grows as its end moves outwards
      const grown = (xa * va + xb * vb) / (length * length);
      const [own, other] = [2 * (place * nodes.length + a), 2 * (place * nodes.length + b)];
      shifts[own] = shifts[own]! - p.radius * (mx + grown * ex);
      shifts[own + 1] = shifts[own + 1]! - p.radius * (my + grown * ey);
      shifts[other] = shifts[other]! - q.radius * (nx - grown * ex);
      shifts[other + 1] = shifts[other + 1]! - q.radius * (ny - grown * ey);
    }
  }
}

interface Points {
  /** 0–1 along a link, and shares of its length */
  readonly t: Float64Array;
  readonly share: Float64Array;
}

const PANELS: readonly Points[] = Array.from({ length: MOST_PANELS }, (_, i) => {
  const panels = Array.from({ length: i + 1 }, (_, k) => k);
  const { nodes, weights } = GAUSS[6];
  return {
    t: Float64Array.from(panels.flatMap((k) => Array.from(nodes, (z) => (k + 0.5 + 0.5 * z) / (i + 1)))),
    share: Float64Array.from(panels.flatMap(() => Array.from(weights, (w) => (0.5 * w) / (i + 1)))),
  };
});

function pointsOn(radii: number): Points {
  return PANELS[Math.min(Math.max(Math.ceil(radii / PANEL), 1), MOST_PANELS) - 1]!;
}
