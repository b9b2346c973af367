/**
 * The rows of subdivision and reverse subdivision, as rational data.
 *
 * Theory: the thesis, equation 4.1 (reverse Chaikin) and the cubic filter below it; its reference for the boundary is not
 * reprinted there, so all end rows are derived: subdivision is midpoint knot insertion on clamped uniform knots, and the
 * reverse rows are left inverses of it with the ends pinned, of near-least noise for their width.
 * Departure: the last cubic weight is printed as 23/96; both the sum of weights and "reverse undoes subdivision" need
 * 23/196. Cubic strokes of four to six points use the rows of the pseudo-inverse with pinned ends.
 * Proven in exact rational arithmetic by the tests: reverse(subdivide(c)) = c for every row here.
 */
import type { Degree } from './bspline.ts';

/** numerator, denominator */
export type Ratio = readonly [number, number];

/** Weights of the points from … from + weights.length − 1 (indices wrap on closed curves). */
export interface Row {
  readonly from: number;
  readonly weights: readonly Ratio[];
}

const ZERO: Ratio = [0, 1];
const ONE: Ratio = [1, 1];
const HALF: Ratio = [1, 2];
const QUARTER: Ratio = [1, 4];
const THREE_QUARTERS: Ratio = [3, 4];
const EIGHTH: Ratio = [1, 8];

/** The row that makes fine point i of `count` control points. */
export function subdivisionRow(degree: Degree, closed: boolean, count: number, i: number): Row {
  if (closed) return degree === 2 ? closedChaikin(i) : closedCubic(i);
  return degree === 2 ? openChaikin(count, i) : openCubic(count, i);
}

/** The row that makes control point j of `count` from their fine points. */
export function reverseRow(degree: Degree, closed: boolean, count: number, j: number): Row {
  if (degree === 2) {
    if (closed) return { from: 2 * j - 2, weights: REVERSE_CHAIKIN };
    return mirroredPast(count, 2 * count - 2, j, (k) => reverseOpenChaikin(count, k));
  }
  if (closed) return { from: 2 * j - 3, weights: REVERSE_CUBIC };
  return mirroredPast(count, 2 * count - 3, j, (k) => reverseOpenCubic(count, k));
}

function closedChaikin(i: number): Row {
  return { from: i >> 1, weights: i % 2 === 0 ? [THREE_QUARTERS, QUARTER] : [QUARTER, THREE_QUARTERS] };
}

function closedCubic(i: number): Row {
  if (i % 2 === 1) return { from: i >> 1, weights: [HALF, HALF] };
  return { from: (i >> 1) - 1, weights: [EIGHTH, THREE_QUARTERS, EIGHTH] };
}

function openChaikin(count: number, i: number): Row {
  const fine = 2 * count - 2;
  if (i === 0) return { from: 0, weights: [ONE] };
  if (i === fine - 1) return { from: count - 1, weights: [ONE] };
  if (i === 1) return { from: 0, weights: [HALF, HALF] };
  if (i === fine - 2) return { from: count - 2, weights: [HALF, HALF] };
  return { from: i >> 1, weights: i % 2 === 0 ? [THREE_QUARTERS, QUARTER] : [QUARTER, THREE_QUARTERS] };
}

/** the row next to the inner knot, from the end inwards */
const CUBIC_THIRD: readonly Ratio[] = [
  [3, 16],
  [11, 16],
  [1, 8],
];

function openCubic(count: number, i: number): Row {
  const fine = 2 * count - 3;
  const rest = fine - 1 - i;
  if (rest < i) return mirror(openCubic(count, rest), count);
  if (i === 0) return { from: 0, weights: [ONE] };
  if (i === 1) return { from: 0, weights: [HALF, HALF] };
  if (count === 4) return { from: 1, weights: [HALF, HALF] };
  if (i === 2) return { from: 1, weights: [THREE_QUARTERS, QUARTER] };
  if (i === 3 && count > 5) return { from: 1, weights: CUBIC_THIRD };
  if (i === 3)
    return {
      from: 1,
      weights: [
        [3, 16],
        [5, 8],
        [3, 16],
      ],
    };
  if (i % 2 === 0) return { from: i >> 1, weights: [HALF, HALF] };
  return { from: i >> 1, weights: [EIGHTH, THREE_QUARTERS, EIGHTH] };
}

/** the thesis, equation 4.1 */
const REVERSE_CHAIKIN: readonly Ratio[] = [
  [-1, 4],
  [3, 4],
  [3, 4],
  [-1, 4],
];
const REVERSE_CHAIKIN_SECOND: readonly Ratio[] = [[-1, 2], ONE, [3, 4], [-1, 4]];
/** three control points: the middle one sees both ends */
const REVERSE_CHAIKIN_ONLY: readonly Ratio[] = [[-1, 2], ONE, ONE, [-1, 2]];

function reverseOpenChaikin(count: number, j: number): Row {
  if (j === 0) return { from: 0, weights: [ONE] };
  if (count === 3) return { from: 0, weights: REVERSE_CHAIKIN_ONLY };
  if (j === 1) return { from: 0, weights: REVERSE_CHAIKIN_SECOND };
  return { from: 2 * j - 2, weights: REVERSE_CHAIKIN };
}

const REVERSE_CUBIC: readonly Ratio[] = [
  [23, 196],
  [-23, 49],
  [9, 28],
  [52, 49],
  [9, 28],
  [-23, 49],
  [23, 196],
];
const REVERSE_CUBIC_SECOND: readonly Ratio[] = [[-1, 3], [2, 3], ONE, [-4, 9], [1, 9]];
const REVERSE_CUBIC_THIRD: readonly Ratio[] = [[2, 9], [-4, 9], ZERO, [32, 27], [29, 54], [-2, 3], [1, 6]];

/** pseudo-inverse rows 1 … of four, five and six control points; the rest by symmetry */
const REVERSE_CUBIC_FEW: Readonly<Record<number, readonly (readonly Ratio[])[]>> = {
  4: [
    [
      [-2, 3],
      [4, 3],
      [2, 3],
      [-2, 3],
      [1, 3],
    ],
  ],
  5: [
    [
      [-235, 598],
      [235, 299],
      [268, 299],
      [-8, 23],
      [-8, 299],
      [51, 299],
      [-51, 598],
    ],
    [
      [13, 46],
      [-13, 23],
      [-2, 69],
      [112, 69],
      [-2, 69],
      [-13, 23],
      [13, 46],
    ],
  ],
  6: [
    over(227263, [-83452, 166904, 204510, -51048, -41934, 39480, 822, -16038, 8019]),
    over(227263, [45846, -91692, -9074, 280808, 104594, -126568, -1530, 49758, -24879]),
  ],
};

function reverseOpenCubic(count: number, j: number): Row {
  if (j === 0) return { from: 0, weights: [ONE] };
  const few = REVERSE_CUBIC_FEW[count]?.[j - 1];
  if (few) return { from: 0, weights: few };
  if (j === 1) return { from: 0, weights: REVERSE_CUBIC_SECOND };
  if (j === 2) return { from: 0, weights: REVERSE_CUBIC_THIRD };
  return { from: 2 * j - 4, weights: REVERSE_CUBIC };
}

/** Rows past the middle are those before it, read from the other end. */
function mirroredPast(count: number, fine: number, j: number, row: (j: number) => Row): Row {
  const rest = count - 1 - j;
  return rest < j ? mirror(row(rest), fine) : row(j);
}

/** The row read from the other end of a line of `points`. */
function mirror(row: Row, points: number): Row {
  return { from: points - row.from - row.weights.length, weights: [...row.weights].reverse() };
}

function over(denominator: number, numerators: readonly number[]): readonly Ratio[] {
  return numerators.map((n): Ratio => [n, denominator]);
}
