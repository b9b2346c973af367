/**
 * Values of several fields under an operation, from the first to the last: gradients by the chain rule, ∇f = ∂a ∇f_a + ∂b ∇f_b;
 * colours in the ratio of ∂a and ∂b.
 */
import type { FieldValue } from '../skeleton/skeleton.ts';
import type { Operation } from './operation.ts';

/** How a union becomes the other operations: −(±a ∪ ±b). */
export type Kind = 'union' | 'intersection' | 'subtraction';

/** Inside of many bodies smooth unions double the value with each: beyond this it stays, or float32 would overflow. */
const MOST = 1e30;

function saturate(out: FieldValue): void {
  out[0] = out[0]! < 0 ? -MOST : MOST;
  out[1] = 0;
  out[2] = 0;
  out[3] = 0;
}

/** Of what comes first, and of what comes after: −(±a ∪ ±b). */
export const signsOf = (kind: Kind): readonly [outer: number, sign: number] => [
  kind === 'union' ? 1 : -1,
  kind === 'intersection' ? -1 : 1,
];

/** Results on the way, one for each set: sets are within each other. */
export class Scratch {
  readonly other = new Float64Array(4);
  readonly partials = new Float64Array(3);
}

/** What values are taken of. */
interface Part {
  value(x: number, y: number, z: number): number;
  evaluate(x: number, y: number, z: number, out: FieldValue): void;
  colour(x: number, y: number, z: number, out: Float64Array): number;
}

export function combinedValue(
  parts: readonly Part[],
  operation: Operation,
  kind: Kind,
  x: number,
  y: number,
  z: number,
): number {
  const [outer, sign] = signsOf(kind);
  let value = parts[0]!.value(x, y, z);
  for (let i = 1; i < parts.length; i++) {
    value = outer * operation.value(outer * value, sign * parts[i]!.value(x, y, z));
    value = Math.min(Math.max(value, -MOST), MOST);
  }
  return value;
}

/** Writes value and gradient. */
export function evaluateOf(
  parts: readonly Part[],
  operation: Operation,
  kind: Kind,
  x: number,
  y: number,
  z: number,
  out: FieldValue,
  { other, partials }: Scratch,
): void {
  const [outer, sign] = signsOf(kind);
  parts[0]!.evaluate(x, y, z, out);
  for (let k = 1; k < parts.length; k++) {
    parts[k]!.evaluate(x, y, z, other);
    operation.evaluate(outer * out[0]!, sign * other[0]!, partials);
    out[0] = outer * partials[0]!;
    // what was turned inside out is turned back
    const toFirst = partials[1]!;
    const toOther = outer * sign * partials[2]!;
    for (let i = 1; i < 4; i++) out[i] = toFirst * out[i]! + toOther * other[i]!;
    if (!(Math.abs(out[0]!) <= MOST)) saturate(out);
  }
}

/** Writes red, green, blue and returns the value. */
export function colourOf(
  parts: readonly Part[],
  operation: Operation,
  kind: Kind,
  x: number,
  y: number,
  z: number,
  out: Float64Array,
  { other, partials }: Scratch,
): number {
  const [outer, sign] = signsOf(kind);
  let value = parts[0]!.colour(x, y, z, out);
  for (let k = 1; k < parts.length; k++) {
    const next = parts[k]!.colour(x, y, z, other);
    operation.evaluate(outer * value, sign * next, partials);
    value = Math.min(Math.max(outer * partials[0]!, -MOST), MOST);
    const toFirst = Math.max(partials[1]!, 0);
    const toOther = Math.max(partials[2]!, 0);
    const share = toFirst + toOther > 0 ? toOther / (toFirst + toOther) : 0.5;
    for (let i = 0; i < 3; i++) out[i]! += share * (other[i]! - out[i]!);
  }
  return value;
}
