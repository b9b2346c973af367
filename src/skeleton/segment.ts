/**
 * A straight segment with a polynomial weight of degree 0–3 (Jin & Tai 2002).
 *
 * FIELD-NOTES §2: the perpendicular from the nearer end, made orthogonal twice, and the stored length between alpha and beta;
 * d² − h² never, because it loses all digits beyond an end. A segment of no length has no field (an integral over nothing);
 * a lump is a point skel.
 */
import { type Kernel, type KernelParams, LineFrame } from '../kernel/kernel.ts';
import { checkedParams, checkFinite, reach, whole } from './binding.ts';
import { boxOf } from './boxOf.ts';
import { FieldError, type FieldValue, type Skeleton, type SkelField } from './skeleton.ts';
import type { SegmentSkel } from './skels.ts';

export const segment: Skeleton<SegmentSkel> = { name: 'segment', bind };

function bind({ a, b, weights }: SegmentSkel, kernel: Kernel, params: KernelParams): SkelField {
  const checked = checkedParams(kernel, params);
  checkFinite('the ends and weights of a segment', [...a, ...b, ...weights]);
  if (weights.length < 1 || weights.length > 4) {
    throw new FieldError(`a segment has 1 to 4 weights (degree 0 to 3), found ${weights.length}`);
  }
  const [dx, dy, dz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const mm = lengthOf(dx, dy, dz);
  if (!(mm < Infinity)) throw new FieldError('a segment must be shorter than 1e154 mm');
  const box = boxOf([a, b]);
  if (mm === 0) return { box, offset: () => 0, value: () => 0, add: () => {} };
  const unit = kernel.unit(checked, mm);
  const per = 1 / unit;
  const frame = new LineFrame();
  const length = mm * per;
  frame.length = length;
  frame.exponent = checked.n ?? frame.exponent;
  frame.floor2 = kernel.floor2.line;
  weights.forEach((weight, k) => {
    frame.weights[k] = weight * whole(unit, k + 1 + kernel.homogeneity);
    if (weight !== 0) frame.degree = k;
  });
  const [ux, uy, uz] = [dx / mm, dy / mm, dz / mm];
  const [ax, ay, az] = a;
  const [bx, by, bz] = b;
  const [mx, my, mz] = [ax + 0.5 * dx, ay + 0.5 * dy, az + 0.5 * dz];
  const { support } = kernel;
  const support2 = support * support;
  const integral = new Float64Array(3);
  const most = largest(frame);
  const bound = (r2: number) => {
    const at = Math.max(r2, frame.floor2);
    const line = kernel.wholeLine?.(at, frame.exponent) ?? Infinity;
    return most * Math.min(line, length * kernel.value(at, frame.exponent));
  };
  // the perpendicular from the line to the point
  const perp = new Float64Array(3);

  /** Fills the frame; false where the point is beyond the support. */
  const place = (x: number, y: number, z: number): boolean => {
    const nearB = (x - mx) * ux + (y - my) * uy + (z - mz) * uz > 0;
    const vx = (nearB ? x - bx : x - ax) * per;
    const vy = (nearB ? y - by : y - ay) * per;
    const vz = (nearB ? z - bz : z - az) * per;
    const t = vx * ux + vy * uy + vz * uz;
    const qx = vx - t * ux;
    const qy = vy - t * uy;
    const qz = vz - t * uz;
    const again = qx * ux + qy * uy + qz * uz;
    const px = qx - again * ux;
    const py = qy - again * uy;
    const pz = qz - again * uz;
    perp[0] = px;
    perp[1] = py;
    perp[2] = pz;
    const rho2 = px * px + py * py + pz * pz;
    const alpha = nearB ? -t - length : -t;
    const beta = nearB ? -t : length - t;
    frame.rho2 = rho2;
    frame.alpha = alpha;
    frame.beta = beta;
    return rho2 < support2 && alpha < support && beta > -support;
  };

  return {
    box,
    offset: (threshold) => (most === 0 ? 0 : unit * reach(bound, threshold, support)),
    value(x, y, z) {
      if (!place(x, y, z)) return 0;
      frame.slopes = false;
      kernel.line(frame, integral);
      return integral[0]!;
    },
    add(x: number, y: number, z: number, factor: number, out: FieldValue): void {
      if (!place(x, y, z)) return;
      frame.slopes = true;
      kernel.line(frame, integral);
      const across = 2 * factor * per * integral[1]!;
      const along = factor * per * integral[2]!;
      out[0] = out[0]! + factor * integral[0]!;
      out[1] = out[1]! + across * perp[0]! + along * ux;
      out[2] = out[2]! + across * perp[1]! + along * uy;
      out[3] = out[3]! + across * perp[2]! + along * uz;
    },
  };
}

/** A bound on |w| along the segment. */
function largest({ weights: w, length: l }: LineFrame): number {
  return Math.abs(w[0]!) + l * (Math.abs(w[1]!) + l * (Math.abs(w[2]!) + l * Math.abs(w[3]!)));
}

/** Without overflow of the squares. */
function lengthOf(x: number, y: number, z: number): number {
  const most = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
  if (most === 0) return 0;
  const [i, j, k] = [x / most, y / most, z / most];
  return most * Math.sqrt(i * i + j * j + k * k);
}
