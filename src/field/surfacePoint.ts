/** Where the surface crosses an edge of a lattice, by regula falsi on the field itself, with its normal and colour. */
import type { Vec3 } from '../math/vec.ts';
import type { TreeField } from './treeField.ts';

/** values taken along an edge at most; smooth fields need two or three */
const STEPS = 16;
/** Every third halves what is left: beside an axis where the field is nearly infinite, secants come no nearer. */
const HALVES = 3;
/** parts of the edge: closer is as good as there */
const CLOSE = 1e-4;
/** Parts of the edge that are kept from its ends: edges that meet at a node must not put their vertices into one place. */
const ENDS = 1e-3;

/**
 * The part of the way from a to b, with values of opposite signs there, at which the field is 0. Illinois: the end that stays
 * counts half, or it would stay for ever beside the steep fields of singular kernels.
 */
export function crossing(field: TreeField, a: Vec3, b: Vec3, valueA: number, valueB: number): number {
  let [low, high, atLow, atHigh] = [0, 1, valueA, valueB];
  let t = 0.5;
  let stayed = 0;
  for (let i = 0; i < STEPS; i++) {
    const next = low + ((high - low) * atLow) / (atLow - atHigh);
    const before = t;
    t = i % HALVES !== HALVES - 1 && next > low && next < high ? next : 0.5 * (low + high);
    if (i > 0 && Math.abs(t - before) < CLOSE) break;
    const value = field.value(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]));
    if (value === 0) break;
    if (value > 0 === valueA > 0) {
      [low, atLow] = [t, value];
      if (stayed === 1) atHigh /= 2;
      stayed = 1;
    } else {
      [high, atHigh] = [t, value];
      if (stayed === -1) atLow /= 2;
      stayed = -1;
    }
  }
  return Math.min(Math.max(t, ENDS), 1 - ENDS);
}

const value = new Float64Array(4);

/** The unit normal, out of where the field is positive; null where it has no slope. */
export function normalAt(field: TreeField, [x, y, z]: Vec3): Vec3 | null {
  field.evaluate(x, y, z, value);
  const [, gx, gy, gz] = value as unknown as readonly [number, number, number, number];
  // squares of the slopes of singular kernels may overflow
  const most = Math.max(Math.abs(gx), Math.abs(gy), Math.abs(gz));
  if (!(most > 0 && most < Infinity)) return null;
  const [ux, uy, uz] = [gx / most, gy / most, gz / most];
  const length = Math.sqrt(ux * ux + uy * uy + uz * uz);
  return [-ux / length, -uy / length, -uz / length];
}
