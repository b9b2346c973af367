/**
 * Fields under an operation as they are within a cube: each part as it is there. Of a hard union (and of what is one inside out) only
 * those are left that may be the largest somewhere in the cube, and what parts neglect stays what it is; other
 * operations stretch errors, so that their parts may leave out what is exactly nothing only.
 */
import type { Kind } from './combined.ts';
import { hardUnion } from './hardUnion.ts';
import type { Near } from './near.ts';
import type { Operation } from './operation.ts';

export class NearSet implements Near {
  readonly low: number;
  readonly high: number;
  readonly error: number;
  readonly asked: number;
  readonly #first: Near;
  readonly #rest: readonly Near[];
  readonly #operation: Operation;
  readonly #kind: Kind;

  constructor(parts: readonly Near[], operation: Operation, kind: Kind) {
    const [first, ...rest] = parts;
    this.#first = first!;
    this.#rest = rest;
    this.#operation = operation;
    this.#kind = kind;
    this.error = parts.reduce((most, { error }) => Math.max(most, error), 0);
    this.asked = parts.reduce((sum, { asked }) => sum + asked, 0);
    const range = this.#range();
    this.low = range[0]!;
    this.high = range[1]!;
  }

  value(x: number, y: number, z: number): number {
    const [outer, sign] = signsOf(this.#kind);
    let value = this.#first.value(x, y, z);
    for (const part of this.#rest) {
      value = outer * this.#operation.value(outer * value, sign * part.value(x, y, z));
    }
    return value;
  }

  within(x: number, y: number, z: number, half: number, share: number): Near {
    const isHard = this.#operation === hardUnion;
    const parts = [this.#first, ...this.#rest].map((part) => part.within(x, y, z, half, isHard ? share : 0));
    const kept = isHard ? largestOf(parts, this.#kind) : parts;
    return new NearSet(kept, this.#operation, this.#kind);
  }

  #range(): Float64Array {
    const [outer, sign] = signsOf(this.#kind);
    const range = turned(this.#first, outer);
    for (const part of this.#rest) this.#operation.range(range, turned(part, sign), range);
    return turned({ low: range[0]!, high: range[1]! }, outer);
  }
}

/** Of what comes first, and of what comes after: −(±a ∪ ±b). */
const signsOf = (kind: Kind): readonly [outer: number, sign: number] => [
  kind === 'union' ? 1 : -1,
  kind === 'intersection' ? -1 : 1,
];

type Range = Pick<Near, 'low' | 'high'>;

function turned({ low, high }: Range, sign: number): Float64Array {
  return sign > 0 ? Float64Array.of(low, high) : Float64Array.of(-high, -low);
}

/** The parts that may be the largest, their signs counted. The first of a subtraction stays: it is the only one of its sign. */
function largestOf(parts: readonly Near[], kind: Kind): readonly Near[] {
  const [outer, sign] = signsOf(kind);
  const ranges = parts.map((part, i) => turned(part, i === 0 ? outer : sign));
  const least = ranges.reduce((most, [low]) => Math.max(most, low!), -Infinity);
  const kept = parts.filter((_, i) => ranges[i]![1]! >= least || (i === 0 && kind === 'subtraction'));
  return kept.length > 0 ? kept : parts;
}
