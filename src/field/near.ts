/** A field as it is within a cube: what its values may be there, and an evaluator that asks only what matters there. */
import type { TreeField } from './treeField.ts';

export interface Near {
  /** all values in the cube lie between them */
  readonly low: number;
  readonly high: number;
  /** by how much `value` may be off in the cube */
  readonly error: number;
  /** skels that a value asks */
  readonly asked: number;
  value(x: number, y: number, z: number): number;
  /** In a cube within this one, about (x, y, z) with edges of 2 `half`; `share` of T may be neglected. */
  within(x: number, y: number, z: number, half: number, share: number): Near;
}

/** Of any field: where it knows no better it is asked as a whole. */
export function nearOf(field: TreeField): Near {
  return field.near?.() ?? new Whole(field, -Infinity, Infinity);
}

class Whole implements Near {
  readonly low: number;
  readonly high: number;
  readonly error = 0;
  readonly asked = 1;
  readonly #field: TreeField;

  constructor(field: TreeField, low: number, high: number) {
    this.#field = field;
    this.low = low;
    this.high = high;
  }

  value(x: number, y: number, z: number): number {
    return this.#field.value(x, y, z);
  }

  within(x: number, y: number, z: number, half: number): Near {
    const range = new Float64Array(2);
    this.#field.range(x, y, z, half, range);
    return new Whole(this.#field, range[0]!, range[1]!);
  }
}
