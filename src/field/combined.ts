/**
 * Two fields under an operation: gradient by the chain rule, ∇f = ∂a ∇f_a + ∂b ∇f_b. Colours are mixed in the ratio of
 * ∂a and ∂b: on a hard union each part keeps its own, in a blend they flow into each other, a cut has the cutter's.
 */
import type { Box, FieldValue } from '../skeleton/skeleton.ts';
import { meet, unite } from './boxes.ts';
import type { Operation } from './operation.ts';
import type { TreeField } from './treeField.ts';

/** How a union becomes the other operations: −(±a ∪ ±b). */
export type Kind = 'union' | 'intersection' | 'subtraction';

export function combined(a: TreeField, b: TreeField, operation: Operation, kind: Kind): TreeField {
  return new Combined(a, b, operation, kind);
}

class Combined implements TreeField {
  readonly #a: TreeField;
  readonly #b: TreeField;
  readonly #operation: Operation;
  readonly #kind: Kind;
  readonly #outer: number;
  readonly #signA: number;
  readonly #signB: number;
  readonly #partials = new Float64Array(3);
  readonly #scratch = new Float64Array(4);
  readonly box: Box | null;

  constructor(a: TreeField, b: TreeField, operation: Operation, kind: Kind) {
    this.#a = a;
    this.#b = b;
    this.#operation = operation;
    this.#kind = kind;
    this.#outer = kind === 'union' ? 1 : -1;
    this.#signA = this.#outer;
    this.#signB = kind === 'intersection' ? -1 : 1;
    this.box = this.boxAbove(0);
  }

  value(x: number, y: number, z: number): number {
    const a = this.#a.value(x, y, z);
    const b = this.#b.value(x, y, z);
    return this.#outer * this.#operation.value(this.#signA * a, this.#signB * b);
  }

  evaluate(x: number, y: number, z: number, out: FieldValue): void {
    const other = this.#scratch;
    this.#a.evaluate(x, y, z, out);
    this.#b.evaluate(x, y, z, other);
    const partials = this.#partials;
    this.#operation.evaluate(this.#signA * out[0]!, this.#signB * other[0]!, partials);
    const toA = this.#outer * this.#signA * partials[1]!;
    const toB = this.#outer * this.#signB * partials[2]!;
    out[0] = this.#outer * partials[0]!;
    for (let i = 1; i < 4; i++) out[i] = toA * out[i]! + toB * other[i]!;
  }

  colour(x: number, y: number, z: number, out: Float64Array): number {
    const other = this.#scratch;
    const a = this.#a.colour(x, y, z, out);
    const b = this.#b.colour(x, y, z, other);
    const partials = this.#partials;
    this.#operation.evaluate(this.#signA * a, this.#signB * b, partials);
    const toA = Math.max(partials[1]!, 0);
    const toB = Math.max(partials[2]!, 0);
    const share = toA + toB > 0 ? toB / (toA + toB) : 0.5;
    for (let i = 0; i < 3; i++) out[i]! += share * (other[i]! - out[i]!);
    return this.#outer * partials[0]!;
  }

  boxAbove(level: number): Box | null {
    if (this.#kind === 'subtraction') return this.#a.boxAbove(level);
    if (this.#kind === 'intersection') return meet(this.#a.boxAbove(level), this.#b.boxAbove(level));
    const reach = -this.#operation.reach(level);
    return unite(this.#a.boxAbove(reach), this.#b.boxAbove(reach));
  }
}
