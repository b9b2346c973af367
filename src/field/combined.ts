/**
 * Two fields under an operation: gradient by the chain rule, ∇f = ∂a ∇f_a + ∂b ∇f_b. Colours are mixed in the ratio of
 * ∂a and ∂b: on a hard union each part keeps its own, in a blend they flow into each other, a cut has the cutter's.
 */
import type { Box, FieldValue } from '../skeleton/skeleton.ts';
import { meet, unite } from './boxes.ts';
import { colourOf, combinedValue, evaluateOf, type Kind, Scratch, signsOf } from './fold.ts';
import type { Near, Tally } from './near.ts';
import { NearSet } from './nearSet.ts';
import type { Operation } from './operation.ts';
import type { TreeField } from './treeField.ts';

/** The first with the second, what comes of that with the third, and so on: a list, for drawings may have ten thousand parts. */
export function combined(parts: readonly TreeField[], operation: Operation, kind: Kind): TreeField {
  return parts.length === 1 ? parts[0]! : new Combined(parts, operation, kind);
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
    const node = tally.set();
    const parts = this.#parts.map((part) => part.near(tally));
    return new NearSet(parts, null, this.#operation, this.#kind, node);
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
