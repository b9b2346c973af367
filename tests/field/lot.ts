/** Choices drawn by lot, the same in every engine; sizes near `unit` mm. */
import type { Colour } from '../../src/field/node.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { random } from '../fixtures/random.ts';

export class Lot {
  readonly #next: () => number;
  readonly unit: number;

  constructor(seed: number, unit = 1) {
    this.#next = random(seed);
    this.unit = unit;
  }

  between(low: number, high: number): number {
    return low + (high - low) * this.#next();
  }
  one<T>(list: readonly T[]): T {
    return list[Math.floor(this.#next() * list.length)]!;
  }
  many<T>(count: number, make: (i: number) => T): T[] {
    return Array.from({ length: count }, (_, i) => make(i));
  }
  is(chance: number): boolean {
    return this.#next() < chance;
  }
  length(): number {
    return this.unit * this.between(0.5, 2);
  }
  direction(): Vec3 {
    return [this.between(-1, 1), this.between(-1, 1), this.between(-1, 1)];
  }
  place(): Vec3 {
    const [x, y, z] = this.direction();
    return [3 * this.unit * x, 3 * this.unit * y, 3 * this.unit * z];
  }
  colour(): Colour {
    return [this.between(0, 1), this.between(0, 1), this.between(0, 1)];
  }
}
