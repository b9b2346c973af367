/**
 * ∫ f of a piecewise smooth f, at every u after a few evaluations.
 *
 * Theory: on a cell the ten values at Gauss nodes are a Legendre series, ∫P_k = (P_{k+1} − P_{k−1})/(2k + 1), so the integral up
 * to any u of the cell costs no evaluation more. Cells are halved until the whole agrees with its halves at the middle
 * and at the end. Gauss weights alone would be blind to errors inside a cell, and quadrature for each u asked for costs ten
 * evaluations, which multiply where spines are bent one on another.
 */
import { GAUSS } from '../math/gaussLegendre.ts';

export interface ArcTable {
  /** ∫ f from the first break to u; u between the first and the last break */
  upTo(u: number): number;
  readonly whole: number;
  /** the integral at its least and greatest, at ends of cells */
  readonly least: number;
  readonly most: number;
}

interface Cell {
  readonly from: number;
  readonly to: number;
  /** of the Legendre series of f times half the cell's width */
  readonly series: Float64Array;
}

const RULE = GAUSS[10];
const N = RULE.nodes.length;
/** cells of the whole to start with, halved at least once */
const CELLS = 12;
/** … and this often at most */
const DEEPEST = 4;
/** part of the whole by which halves may differ: what is kept of them is ten (at kinks) to 2¹⁹ times nearer */
const TOLERANCE = 1e-9;

/** `breaks` ascending: f is smooth between them and never asked for at them. */
export function arcTable(f: (u: number) => number, breaks: readonly number[]): ArcTable {
  const span = breaks[breaks.length - 1]! - breaks[0]!;
  const first = breaks.slice(1).flatMap((to, i) => {
    const from = breaks[i]!;
    const count = Math.max(Math.ceil((CELLS * (to - from)) / span), 1);
    return Array.from({ length: count }, (_, k) =>
      cellOf(f, from + ((to - from) * k) / count, from + ((to - from) * (k + 1)) / count),
    );
  });
  const size = first.reduce((sum, { series }) => sum + 2 * Math.abs(series[0]!), 0);
  const cells = first.flatMap((cell) => halved(f, cell, TOLERANCE * size, 1));
  const sums = new Float64Array(cells.length + 1);
  cells.forEach((cell, i) => {
    sums[i + 1] = sums[i]! + 2 * cell.series[0]!;
  });
  return {
    upTo: (u) => {
      const i = indexOf(cells, u);
      return sums[i]! + partOf(cells[i]!, u);
    },
    whole: sums[cells.length]!,
    least: sums.reduce((a, b) => Math.min(a, b)),
    most: sums.reduce((a, b) => Math.max(a, b)),
  };
}

function cellOf(f: (u: number) => number, from: number, to: number): Cell {
  const half = 0.5 * (to - from);
  const series = new Float64Array(N);
  for (let i = 0; i < N; i++) {
    const x = RULE.nodes[i]!;
    const value = half * RULE.weights[i]! * f(from + half * (1 + x));
    let [before, here] = [0, 1];
    for (let k = 0; k < N; k++) {
      series[k] = series[k]! + (k + 0.5) * value * here;
      [before, here] = [here, ((2 * k + 1) * x * here - k * before) / (k + 1)];
    }
  }
  return { from, to, series };
}

function halved(f: (u: number) => number, cell: Cell, tolerance: number, depth: number): Cell[] {
  const middle = 0.5 * (cell.from + cell.to);
  const halves = [cellOf(f, cell.from, middle), cellOf(f, middle, cell.to)];
  const [left, right] = halves.map(({ series }) => 2 * series[0]!);
  const agree =
    Math.abs(partOf(cell, middle) - left!) <= tolerance &&
    Math.abs(2 * cell.series[0]! - left! - right!) <= tolerance;
  if (agree || depth === DEEPEST) return halves;
  return halves.flatMap((half) => halved(f, half, tolerance, depth + 1));
}

/** The integral from the start of the cell to u. */
function partOf({ from, to, series }: Cell, u: number): number {
  const x = to > from ? Math.min(Math.max((2 * (u - from)) / (to - from) - 1, -1), 1) : 1;
  let sum = series[0]! * (1 + x);
  let [before, here] = [1, x];
  for (let k = 1; k < N; k++) {
    const next = ((2 * k + 1) * x * here - k * before) / (k + 1);
    sum += (series[k]! * (next - before)) / (2 * k + 1);
    [before, here] = [here, next];
  }
  return sum;
}

/** The last cell that starts at or before u. */
function indexOf(cells: readonly Cell[], u: number): number {
  let low = 0;
  let high = cells.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (cells[middle]!.from <= u) low = middle;
    else high = middle - 1;
  }
  return low;
}
