/**
 * A sum along a ray from a point on: value and slope there, what its polynomial adds exactly, and what its skels may add at most
 * (skeleton/ahead.ts). From these comes how far it surely keeps its sign: towards a surface those are Newton's steps that never go
 * beyond it, past one they are as long as a square root.
 */
import { type Ahead, known, looseness } from '../skeleton/ahead.ts';

/** how often the distance is bettered; each is some additions and a power */
const ROUNDS = 3;
/** of what is surely clear: how far beyond 0 is looked for */
const SEEN = 4;

export class RayAhead {
  value = 0.5;
  /** a millimetre along the ray */
  slope = 0.5;
  /** half the second derivative of what is known exactly */
  curve = 0.5;
  /** mm along the ray: nothing is known beyond */
  reach = 0.5;
  /** of the sum, for millimetres of its own frame */
  readonly ahead: Ahead;
  /** of these for a millimetre along the ray */
  stretch = 1;
  /** of values */
  scale = 1;

  constructor(ahead: Ahead) {
    this.ahead = ahead;
  }

  /** mm along the ray from the point on over which the bounds hold; 0 where nothing is known. */
  get known(): number {
    return Math.min(this.reach, known(this.ahead) / this.stretch);
  }

  /** Writes [low, high] of the values up to t ≤ `known`. */
  range(t: number, out: Float64Array): void {
    const swing = this.slope * t;
    const curve = this.curve * t * t;
    const loose = this.#loose(t) * t * t;
    out[0] = this.value + Math.min(swing, 0) + Math.min(curve, 0) - loose;
    out[1] = this.value + Math.max(swing, 0) + Math.max(curve, 0) + loose;
  }

  /** mm along the ray over which the value surely is on this side of 0. */
  clear(): number {
    // towards 0 is positive
    const side = this.value > 0 ? -1 : 1;
    return this.#until(Math.abs(this.value), side * this.slope, side * this.curve);
  }

  /** The least t at which slope and bend might come to `depth`. */
  #until(depth: number, slope: number, curve: number): number {
    let high = this.known;
    let low = Math.min(root(depth, slope, curve + this.#loose(high)), high);
    for (let i = 0; i < ROUNDS && low < high; i++) {
      const middle = Math.sqrt(low * high);
      const reached = root(depth, slope, curve + this.#loose(middle));
      if (reached >= middle) low = middle;
      else {
        high = middle;
        low = Math.max(low, reached);
      }
    }
    return low;
  }

  /** mm along the ray up to which 0 surely is reached; Infinity where that is not known. `clear`: what `clear` said. */
  reached(clear: number): number {
    const within = Math.min(this.known, SEEN * clear);
    const side = this.value > 0 ? -1 : 1;
    const slope = side * this.slope;
    const found = root(Math.abs(this.value), slope, side * this.curve - this.#loose(within));
    return found <= within ? found : Infinity;
  }

  /** mm to all sides within which the value surely is on this side of 0; `slope`, `curve`: bounds on those to any side. */
  around(slope: number, curve: number): number {
    return this.#until(Math.abs(this.value), slope, curve);
  }

  #loose(t: number): number {
    const { stretch, scale } = this;
    return scale * stretch * stretch * looseness(this.ahead, t * stretch);
  }
}

/** The least t > 0 with slope t + bend t² = depth, which is reached nowhere before; Infinity for none. */
function root(depth: number, slope: number, bend: number): number {
  const under = slope * slope + 4 * bend * depth;
  if (!(under >= 0)) return Infinity;
  const sum = slope + Math.sqrt(under);
  return sum > 0 ? (2 * depth) / sum : Infinity;
}
