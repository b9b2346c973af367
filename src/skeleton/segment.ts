/**
 * A straight segment with a polynomial weight of degree 0–3 (Jin & Tai 2002).
 *
 * From the point: the perpendicular from the nearer end, made orthogonal twice, and the stored length between alpha and beta;
 * d² − h² never, because it loses all digits beyond an end. A segment of no length has no field (an integral over nothing);
 * a lump is a point skel.
 */
import { type Kernel, type KernelParams, type LineField, LineFrame } from '../kernel/kernel.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Ahead } from './ahead.ts';
import type { Ball } from './ball.ts';
import { checkedParams, checkNumbers, checkPlaces, reach, SHORTEST, whole } from './binding.ts';
import { boxOf } from './boxOf.ts';
import { segmentSpreader } from './segmentSpread.ts';
import {
  type Box,
  FieldError,
  type FieldValue,
  type Skeleton,
  type SkelField,
  type Spread,
} from './skeleton.ts';
import type { SegmentSkel } from './skels.ts';
import type { Spreader } from './spread.ts';
import type { Taylor } from './taylor.ts';

export const segment: Skeleton<SegmentSkel> = { name: 'segment', bind };

function bind({ a, b, weights }: SegmentSkel, kernel: Kernel, params: KernelParams): SkelField {
  const checked = checkedParams(kernel, params);
  checkPlaces('the ends of a segment', [...a, ...b]);
  checkNumbers('the weights of a segment', weights);
  if (weights.length < 1 || weights.length > 4) {
    throw new FieldError(`a segment has 1 to 4 weights (degree 0 to 3), found ${weights.length}`);
  }
  const [dx, dy, dz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const mm = lengthOf(dx, dy, dz);
  const box = boxOf([a, b]);
  if (mm < SHORTEST) return { box, offset: () => 0, isCubic: true, ...NOTHING };
  const field = new SegmentField(box, [a, b], mm, weights, kernel, checked);
  return field.quick() ?? field;
}

/** of a segment of no length */
const NOTHING = {
  value: () => 0,
  add: () => {},
  spread: () => {},
  missed: () => 0,
  standIn: () => 0,
  ahead: () => {},
  apart: () => Infinity,
} as const;

/** What a kernel leaves, and the perpendicular from the line to the point: made once, filled again for each evaluation. */
const integral = new Float64Array(3);
const perp = new Float64Array(3);

/**
 * A class, and its numbers in typed arrays, because engines then know where everything lies: closures over numbers, which
 * each segment brings along in a box of its own, took a tenth to a fifth longer.
 */
class SegmentField implements SkelField {
  readonly box: Box;
  readonly isCubic: boolean;
  readonly #kernel: Kernel;
  readonly #line: Kernel['line'];
  readonly #frame = new LineFrame();
  readonly #spreader: Spreader;
  readonly #unit: number;
  readonly #per: number;
  readonly #support2: number;
  /** the ends and the middle, mm; the direction from a to b */
  readonly #a: Float64Array;
  readonly #b: Float64Array;
  readonly #middle: Float64Array;
  readonly #u: Float64Array;

  constructor(
    box: Box,
    [a, b]: readonly [Vec3, Vec3],
    mm: number,
    weights: readonly number[],
    kernel: Kernel,
    params: KernelParams,
  ) {
    this.box = box;
    this.#kernel = kernel;
    this.#line = kernel.line;
    this.#unit = kernel.unit(params, mm);
    this.#per = 1 / this.#unit;
    this.#support2 = kernel.support * kernel.support;
    this.#a = Float64Array.from(a);
    this.#b = Float64Array.from(b);
    this.#middle = Float64Array.from(a, (x, i) => x + 0.5 * (b[i]! - x));
    this.#u = Float64Array.from(a, (x, i) => (b[i]! - x) / mm);
    const frame = this.#frame;
    frame.length = mm * this.#per;
    frame.exponent = params.n ?? frame.exponent;
    frame.floor2 = kernel.floor2.line;
    weights.forEach((weight, k) => {
      frame.weights[k] = weight * whole(this.#unit, k + 1 + kernel.homogeneity);
      if (weight !== 0) frame.degree = k;
    });
    this.isCubic = kernel.change.type === 'relative';
    this.#spreader = segmentSpreader(kernel, frame, this.#a, this.#u, this.#per);
  }

  /** This field by what the kernel has for linear weights, if anything. */
  quick(): SkelField | null {
    const { weights, length, degree } = this.#frame;
    if (degree > 1) return null;
    const line = { a: this.#a, u: this.#u, per: this.#per, length, w0: weights[0]!, w1: weights[1]! };
    const quick = this.#kernel.linear?.(line);
    if (!quick) return null;
    // names that the quick form does not have itself
    const own = { box: this.box, isCubic: this.isCubic, source: this, spreader: this.#spreader };
    return Object.assign(quick, QUICK, own);
  }

  offset(threshold: number): number {
    const spreader = this.#spreader;
    const reached = () => reach((r2) => spreader.most(r2), threshold, this.#kernel.support);
    return spreader.most(0) === 0 ? 0 : this.#unit * reached();
  }

  missed(ball: Ball, most: number): number {
    return this.#spreader.missed(ball, most);
  }

  /** Of places that are as far along, and of their weights times the length. */
  apart(other: SkelField, ball: Ball): number {
    const found = other instanceof SegmentField ? other : (other as Partial<Quick>).source;
    if (!found || found.#kernel !== this.#kernel || found.#per !== this.#per) return Infinity;
    if (found.#frame.exponent !== this.#frame.exponent) return Infinity;
    const shift = this.#per * Math.max(between(this.#a, found.#a), between(this.#b, found.#b));
    let mass = 0;
    let [own, theirs] = [1, 1];
    for (let k = 0; k < 4; k++) {
      own *= this.#frame.length;
      theirs *= found.#frame.length;
      mass += Math.abs(this.#frame.weights[k]! * own - found.#frame.weights[k]! * theirs);
    }
    return this.#spreader.apart(ball, shift, mass);
  }

  standIn(ball: Ball, factor: number, out: Taylor): number {
    return this.#spreader.standIn(this, ball, factor, out);
  }

  ahead(ball: Ball, factor: number, out: Ahead): void {
    this.#spreader.ahead(this, ball, factor, out);
  }

  spread(ball: Ball, factor: number, out: Spread): void {
    this.#spreader.add(this, ball, factor, out);
  }

  value(x: number, y: number, z: number): number {
    if (!this.#see(x, y, z)) return 0;
    const line = this.#line;
    this.#frame.slopes = false;
    line(this.#frame, integral);
    return integral[0]!;
  }

  add(x: number, y: number, z: number, factor: number, out: FieldValue): void {
    if (!this.#see(x, y, z)) return;
    const line = this.#line;
    this.#frame.slopes = true;
    line(this.#frame, integral);
    const u = this.#u;
    const steep = factor * this.#per;
    const across = 2 * steep * integral[1]!;
    const along = steep * integral[2]!;
    out[0] = out[0]! + factor * integral[0]!;
    out[1] = out[1]! + across * perp[0]! + along * u[0]!;
    out[2] = out[2]! + across * perp[1]! + along * u[1]!;
    out[3] = out[3]! + across * perp[2]! + along * u[2]!;
  }

  /** Fills the frame and the perpendicular; false where the point is beyond the support. */
  #see(x: number, y: number, z: number): boolean {
    const frame = this.#frame;
    const u = this.#u;
    const middle = this.#middle;
    const per = this.#per;
    const support2 = this.#support2;
    const { length } = frame;
    const ux = u[0]!;
    const uy = u[1]!;
    const uz = u[2]!;
    const isNearB = (x - middle[0]!) * ux + (y - middle[1]!) * uy + (z - middle[2]!) * uz > 0;
    const end = isNearB ? this.#b : this.#a;
    const vx = (x - end[0]!) * per;
    const vy = (y - end[1]!) * per;
    const vz = (z - end[2]!) * per;
    const t = vx * ux + vy * uy + vz * uz;
    const qx = vx - t * ux;
    const qy = vy - t * uy;
    const qz = vz - t * uz;
    const again = qx * ux + qy * uy + qz * uz;
    const px = qx - again * ux;
    const py = qy - again * uy;
    const pz = qz - again * uz;
    const rho2 = px * px + py * py + pz * pz;
    perp[0] = px;
    perp[1] = py;
    perp[2] = pz;
    frame.rho2 = rho2;
    frame.alpha = isNearB ? -t - length : -t;
    frame.beta = isNearB ? -t : length - t;
    return rho2 < support2;
  }
}

/** What a quick form knows of where it is from. */
interface Quick extends LineField {
  readonly source: SegmentField;
  readonly spreader: Spreader;
}

/** The same functions for all: those that each would bring along for itself are called at twice the price. */
const QUICK = {
  missed(this: Quick, ball: Ball, most: number): number {
    return this.spreader.missed(ball, most);
  },
  ahead(this: Quick, ball: Ball, factor: number, out: Ahead): void {
    this.spreader.ahead(this, ball, factor, out);
  },
  standIn(this: Quick, ball: Ball, factor: number, out: Taylor): number {
    return this.spreader.standIn(this, ball, factor, out);
  },
  spread(this: Quick, ball: Ball, factor: number, out: Spread): void {
    this.spreader.add(this, ball, factor, out);
  },
  apart(this: Quick, other: SkelField, ball: Ball): number {
    return this.source.apart(other, ball);
  },
  offset(this: Quick, threshold: number): number {
    return this.source.offset(threshold);
  },
};

const between = (a: Float64Array, b: Float64Array) => lengthOf(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);

/** Without overflow of the squares. */
function lengthOf(x: number, y: number, z: number): number {
  const most = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
  if (most === 0) return 0;
  const [i, j, k] = [x / most, y / most, z / most];
  return most * Math.sqrt(i * i + j * j + k * k);
}
