/**
 * Two fields under an operation: gradient by the chain rule, ∇f = ∂a ∇f_a + ∂b ∇f_b. Colours are mixed in the ratio of
 * ∂a and ∂b: on a hard union each part keeps its own, in a blend they flow into each other, a cut has the cutter's.
 */
import type { Box, FieldValue } from '../skeleton/skeleton.ts';
import { meet, unite } from './boxes.ts';
import { type Near, nearOf } from './near.ts';
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
  const [first, ...rest] = parts;
  return rest.length === 0 ? first! : new Combined(first!, rest, operation, kind);
}

class Combined implements TreeField {
  readonly #first: TreeField;
  readonly #rest: readonly TreeField[];
  readonly #operation: Operation;
  readonly #kind: Kind;
  readonly #outer: number;
  /** of what comes second */
  readonly #sign: number;
  readonly #partials = new Float64Array(3);
  readonly #scratch = new Float64Array(4);
  readonly #range = new Float64Array(2);
  readonly box: Box | null;

  constructor(first: TreeField, rest: readonly TreeField[], operation: Operation, kind: Kind) {
    this.#first = first;
    this.#rest = rest;
    this.#operation = operation;
    this.#kind = kind;
    this.#outer = kind === 'union' ? 1 : -1;
    this.#sign = kind === 'intersection' ? -1 : 1;
    this.box = this.boxAbove(0);
  }

  value(x: number, y: number, z: number): number {
    let value = this.#first.value(x, y, z);
    for (const part of this.#rest) {
      value = this.#outer * this.#operation.value(this.#outer * value, this.#sign * part.value(x, y, z));
      value = Math.min(Math.max(value, -MOST), MOST);
    }
    return value;
  }

  evaluate(x: number, y: number, z: number, out: FieldValue): void {
    const other = this.#scratch;
    const partials = this.#partials;
    const outer = this.#outer;
    const sign = this.#sign;
    this.#first.evaluate(x, y, z, out);
    for (const part of this.#rest) {
      part.evaluate(x, y, z, other);
      this.#operation.evaluate(outer * out[0]!, sign * other[0]!, partials);
      out[0] = outer * partials[0]!;
      // what was turned inside out is turned back
      const toFirst = partials[1]!;
      const toOther = outer * sign * partials[2]!;
      for (let i = 1; i < 4; i++) out[i] = toFirst * out[i]! + toOther * other[i]!;
      if (!(Math.abs(out[0]!) <= MOST)) saturate(out);
    }
  }

  colour(x: number, y: number, z: number, out: Float64Array): number {
    const other = this.#scratch;
    const partials = this.#partials;
    let value = this.#first.colour(x, y, z, out);
    for (const part of this.#rest) {
      const next = part.colour(x, y, z, other);
      this.#operation.evaluate(this.#outer * value, this.#sign * next, partials);
      value = Math.min(Math.max(this.#outer * partials[0]!, -MOST), MOST);
      const toFirst = Math.max(partials[1]!, 0);
      const toOther = Math.max(partials[2]!, 0);
      const share = toFirst + toOther > 0 ? toOther / (toFirst + toOther) : 0.5;
      for (let i = 0; i < 3; i++) out[i]! += share * (other[i]! - out[i]!);
    }
    return value;
  }

  range(x: number, y: number, z: number, half: number, out: Float64Array): void {
    const other = this.#range;
    this.#first.range(x, y, z, half, out);
    for (const part of this.#rest) {
      part.range(x, y, z, half, other);
      signed(this.#outer, out);
      signed(this.#sign, other);
      this.#operation.range(out, other, out);
      signed(this.#outer, out);
    }
  }

  near(): Near {
    return new NearSet([this.#first, ...this.#rest].map(nearOf), this.#operation, this.#kind);
  }

  boxAbove(level: number): Box | null {
    if (this.#kind === 'subtraction') return this.#first.boxAbove(level);
    if (this.#kind === 'intersection') {
      return this.#rest.reduce((box, part) => meet(box, part.boxAbove(level)), this.#first.boxAbove(level));
    }
    let reached = level;
    // the last operation reaches least far
    const boxes = this.#rest.toReversed().map((part) => {
      reached = -this.#operation.reach(reached);
      return part.boxAbove(reached);
    });
    return boxes.reduce(unite, this.#first.boxAbove(reached));
  }
}

/** An interval, turned where the sign is −1. */
function signed(sign: number, range: Float64Array): void {
  if (sign > 0) return;
  const low = range[0]!;
  range[0] = -range[1]!;
  range[1] = -low;
}
