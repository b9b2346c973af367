/**
 * Two fields under an operation: gradient by the chain rule, ∇f = ∂a ∇f_a + ∂b ∇f_b. Colours are mixed in the ratio of
 * ∂a and ∂b: on a hard union each part keeps its own, in a blend they flow into each other, a cut has the cutter's.
 */
import type { Box, FieldValue } from '../skeleton/skeleton.ts';
import { meet, unite } from './boxes.ts';
import type { Near, Tally } from './near.ts';
import { NearSet } from './nearSet.ts';
import type { Operation } from './operation.ts';
import type { TreeField } from './treeField.ts';

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

/** The first with the second, what comes of that with the third, and so on: a list, for drawings may have ten thousand parts. */
export function combined(parts: readonly TreeField[], operation: Operation, kind: Kind): TreeField {
  return parts.length === 1 ? parts[0]! : new Combined(parts, operation, kind);
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
type Part = Pick<TreeField, 'value' | 'evaluate' | 'colour'>;

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

class Combined implements TreeField {
  readonly #parts: readonly TreeField[];
  readonly #operation: Operation;
  readonly #kind: Kind;
  readonly #outer: number;
  /** of what comes second */
  readonly #sign: number;
  readonly #scratch = new Scratch();
  readonly #range = new Float64Array(2);
  readonly box: Box | null;

  constructor(parts: readonly TreeField[], operation: Operation, kind: Kind) {
    this.#parts = parts;
    this.#operation = operation;
    this.#kind = kind;
    [this.#outer, this.#sign] = signsOf(kind);
    this.box = this.boxAbove(0);
  }

  value(x: number, y: number, z: number): number {
    return combinedValue(this.#parts, this.#operation, this.#kind, x, y, z);
  }

  evaluate(x: number, y: number, z: number, out: FieldValue): void {
    evaluateOf(this.#parts, this.#operation, this.#kind, x, y, z, out, this.#scratch);
  }

  colour(x: number, y: number, z: number, out: Float64Array): number {
    return colourOf(this.#parts, this.#operation, this.#kind, x, y, z, out, this.#scratch);
  }

  range(x: number, y: number, z: number, half: number, out: Float64Array): void {
    const other = this.#range;
    const [first, ...rest] = this.#parts;
    first!.range(x, y, z, half, out);
    for (const part of rest) {
      part.range(x, y, z, half, other);
      signed(this.#outer, out);
      signed(this.#sign, other);
      this.#operation.range(out, other, out);
      signed(this.#outer, out);
    }
  }

  near(tally: Tally): Near {
    const parts = this.#parts.map((part) => part.near(tally));
    return new NearSet(parts, [], this.#operation, this.#kind);
  }

  boxAbove(level: number): Box | null {
    const [first, ...rest] = this.#parts;
    if (this.#kind === 'subtraction') return first!.boxAbove(level);
    if (this.#kind === 'intersection') {
      return rest.reduce((box, part) => meet(box, part.boxAbove(level)), first!.boxAbove(level));
    }
    let reached = level;
    // the last operation reaches least far
    const boxes = rest.toReversed().map((part) => {
      reached = -this.#operation.reach(reached);
      return part.boxAbove(reached);
    });
    return boxes.reduce(unite, first!.boxAbove(reached));
  }
}

/** An interval, turned where the sign is −1. */
function signed(sign: number, range: Float64Array): void {
  if (sign > 0) return;
  const low = range[0]!;
  range[0] = -range[1]!;
  range[1] = -low;
}
