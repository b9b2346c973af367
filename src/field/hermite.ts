/**
 * Values of a brick's 125 corners from value and gradient at its 27 nodes, every second corner: the Hermite interpolant of each
 * cell of eight nodes, at its edges' middles, its faces' middles and its own.
 *
 * Theory: with e the distance of nodes, edge (f₀ + f₁)/2 + e/8 (f₀′ − f₁′), face and cell the mean of their corners plus e/16 and e/32
 * of the sum of −s·∇f, s the corner's signs: exact for cubics. The same stencils over nodes twice as far apart say how far they are off
 * there, 2⁴ times as much where fields are smooth enough.
 */

/** corners along a brick, and nodes */
export const SIDE = 5;
export const CORNERS = SIDE * SIDE * SIDE;
export const NODES = 27;
/** value, gradient */
export const STRIDE = 4;

/** Of what the coarse stencils are off by: 1/16 if fields were smooth. With 1/4 two of 50,000 signs were wrong about a tree. */
const SAFE = 1;
/** Of what values in a brick differ by: fields with creases may be off by that where no node tells. */
const ROUGH = 0.01;

const corner = (i: number, j: number, k: number) => i + SIDE * (j + SIDE * k);
const node = (i: number, j: number, k: number) => i + 3 * (j + 3 * k);

/** One interpolated place: the nodes around, and for each the signs of the gradient's parts. */
interface Stencil {
  readonly target: number;
  readonly nodes: readonly number[];
  /** three for each node: −s, 0 along axes on which the place has the node's coordinate */
  readonly signs: readonly number[];
}

/** All of some stencils in one row each: a place brings along as many nodes as it has. */
interface Stencils {
  readonly targets: Uint8Array;
  readonly counts: Uint8Array;
  readonly nodes: Uint8Array;
  readonly signs: Int8Array;
}

/** Nodes at even places that are `apart` from each other; `target` numbers the place in between. */
function stencilsOf(apart: 1 | 2, target: (i: number, j: number, k: number) => number): Stencil[] {
  const stencils: Stencil[] = [];
  const places = apart === 1 ? SIDE : 3;
  for (let k = 0; k < places; k++) {
    for (let j = 0; j < places; j++) {
      for (let i = 0; i < places; i++) {
        const axes = [i, j, k].map((at) => (at % 2 === 0 ? [0] : [-1, 1]));
        if (axes.every(({ length }) => length === 1)) continue;
        const around = axes[2]!.flatMap((dk) =>
          axes[1]!.flatMap((dj) => axes[0]!.map((di) => [di, dj, dk] as const)),
        );
        const scale = apart === 1 ? 0.5 : 1;
        stencils.push({
          target: target(i, j, k),
          nodes: around.map(([di, dj, dk]) => node(scale * (i + di), scale * (j + dj), scale * (k + dk))),
          signs: around.flat().map((s) => -s),
        });
      }
    }
  }
  return stencils;
}

const inRows = (stencils: readonly Stencil[]): Stencils => ({
  targets: Uint8Array.from(stencils, ({ target }) => target),
  counts: Uint8Array.from(stencils, ({ nodes }) => nodes.length),
  nodes: Uint8Array.from(stencils.flatMap(({ nodes }) => nodes)),
  signs: Int8Array.from(stencils.flatMap(({ signs }) => signs)),
});

const FINE = inRows(stencilsOf(1, corner));
const COARSE = inRows(stencilsOf(2, node));
/** of a place between two, four or eight nodes */
const FLOPS_OF: Readonly<Record<number, number>> = { 2: 6, 4: 16, 8: 40 };
const flopsOf = ({ counts }: Stencils) => counts.reduce((sum, count) => sum + FLOPS_OF[count]!, 0);
/** additions and products of one brick */
export const INTERPOLATION_FLOPS = flopsOf(FINE) + flopsOf(COARSE);

/** Writes 125 values; `nodes`: value and gradient of 27; `step`: between corners, mm. */
export function interpolate(nodes: Float64Array, step: number, out: Float64Array): void {
  for (let k = 0; k < 3; k++) {
    for (let j = 0; j < 3; j++) {
      for (let i = 0; i < 3; i++) out[corner(2 * i, 2 * j, 2 * k)] = nodes[STRIDE * node(i, j, k)]!;
    }
  }
  between(FINE, nodes, 2 * step, out);
}

/** By how much interpolated values may be off: nothing where the field is a cubic. */
export function interpolationError(nodes: Float64Array, step: number): number {
  let most = ROUGH * swingOf(nodes);
  between(COARSE, nodes, 4 * step, coarse);
  const { targets } = COARSE;
  for (let i = 0; i < targets.length; i++) {
    const target = targets[i]!;
    const off = Math.abs(coarse[target]! - nodes[STRIDE * target]!);
    if (!(off <= most)) most = off;
  }
  return SAFE * most;
}

const coarse = new Float64Array(NODES);

function swingOf(nodes: Float64Array): number {
  let low = Infinity;
  let high = -Infinity;
  for (let at = 0; at < nodes.length; at += STRIDE) {
    if (nodes[at]! < low) low = nodes[at]!;
    if (nodes[at]! > high) high = nodes[at]!;
  }
  return high - low;
}

/** Writes what stencils say of their places; `apart`: between nodes. */
function between(
  { targets, counts, nodes: around, signs }: Stencils,
  nodes: Float64Array,
  apart: number,
  out: Float64Array,
): void {
  let n = 0;
  for (let i = 0; i < targets.length; i++) {
    const count = counts[i]!;
    let sum = 0;
    let slope = 0;
    for (const end = n + count; n < end; n++) {
      const at = STRIDE * around[n]!;
      sum += nodes[at]!;
      slope +=
        signs[3 * n]! * nodes[at + 1]! +
        signs[3 * n + 1]! * nodes[at + 2]! +
        signs[3 * n + 2]! * nodes[at + 3]!;
    }
    out[targets[i]!] = (sum + 0.25 * apart * slope) / count;
  }
}
