/**
 * Which half of a section drawn across is the full one. In thesis fig. 5.12 it lies below a chord that runs from left to right, and
 * "right-hand side from q_l to q_r" says the same where q_l is the left one as one looks. Sides here are named by the way along the first
 * stroke (align.ts), so that q_l is on the person's right when sides were drawn downwards: then full is the left-hand side, and lies
 * below all the same. Where chords stand nearly upright (lying forms) nothing is below, and the right-hand side counts.
 */
import { distance2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';

/** places the mean is taken of */
const LOOKS = 32;
/** of their length: what is less to the left is upright, or goes round in a ring */
const UPRIGHT = 0.1;

/** The two sides at one u, on the plane. */
export type Chord = (u: number) => { readonly left: Vec2; readonly right: Vec2 };

/** Chords run from q_l to q_r to the left, in the mean. Mirrored forms answer alike. */
export function runsLeft(chord: Chord): boolean {
  let x = 0;
  let length = 0;
  for (let i = 0; i < LOOKS; i++) {
    const { left, right } = chord((i + 0.5) / LOOKS);
    x += right[0] - left[0];
    length += distance2(left, right);
  }
  return x < -UPRIGHT * length;
}
