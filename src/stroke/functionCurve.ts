/** Shapes known in closed form as curves by arc length: chords in a table, corrected to the fourth order of their length. */
import { length2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { place, unit } from './bezierCurve.ts';
import type { Curve } from './curve.ts';

/** number of chords in the table of functionCurve: a circle's arc length is then good to 1e-9 of its whole */
const TABLE = 4096;

/** A smooth function of t in [0, 1] as a curve, for tests and for shapes known in closed form. Pressure 0.5. */
export function functionCurve(f: (t: number) => Vec2, closed: boolean): Curve {
  const lengths = chordTable(f);
  const length = lengths[TABLE]!;
  const parameter = (u: number): number => {
    const s = place(u, closed) * length;
    const i = Math.min(upperBound(lengths, s), TABLE) - 1;
    const chord = lengths[i + 1]! - lengths[i]!;
    return (i + (chord > 0 ? (s - lengths[i]!) / chord : 0)) / TABLE;
  };
  return {
    closed,
    length,
    corners: [],
    point: (u) => f(parameter(u)),
    tangent: (u) => unit(difference(f, parameter(u), closed)) ?? [1, 0],
    pressure: () => 0.5,
  };
}

/** Arc length up to each table entry: chords, with the h² error of a chord removed by comparing with half chords. */
function chordTable(f: (t: number) => Vec2): Float64Array {
  const lengths = new Float64Array(TABLE + 1);
  let before = f(0);
  for (let i = 0; i < TABLE; i++) {
    const middle = f((i + 0.5) / TABLE);
    const after = f((i + 1) / TABLE);
    const halves = length2(sub2(middle, before)) + length2(sub2(after, middle));
    lengths[i + 1] = lengths[i]! + (4 * halves - length2(sub2(after, before))) / 3;
    before = after;
  }
  return lengths;
}

/** f′ up to scale: central difference, one-sided of second order at open ends (both err by h² ≈ 1e-10). */
function difference(f: (t: number) => Vec2, t: number, closed: boolean): Vec2 {
  const h = 1e-5;
  if (t < h && !closed) return oneSided(f(t), f(t + h), f(t + 2 * h), 1);
  if (t > 1 - h && !closed) return oneSided(f(t), f(t - h), f(t - 2 * h), -1);
  const wrap = (x: number) => (closed ? x - Math.floor(x) : x);
  return sub2(f(wrap(t + h)), f(wrap(t - h)));
}

function oneSided(a: Vec2, b: Vec2, c: Vec2, sign: 1 | -1): Vec2 {
  return [sign * (4 * b[0] - 3 * a[0] - c[0]), sign * (4 * b[1] - 3 * a[1] - c[1])];
}

/** The first index whose value exceeds x. */
function upperBound(values: Float64Array, x: number): number {
  let low = 1;
  let high = values.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle]! > x) high = middle;
    else low = middle + 1;
  }
  return low;
}
