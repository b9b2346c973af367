/** Vertices by the number of their edge: open addressing over whole numbers, for a Map of as many takes several times as long. */

const FREE = -1;
/** Fibonacci hashing: 2³² over the golden ratio */
const SPREADING = 0x9e3779b1;

export class EdgeTable {
  #bits = 10;
  #keys = new Int32Array(1 << this.#bits).fill(FREE);
  #vertices = new Int32Array(1 << this.#bits);
  #count = 0;

  /** −1 where there is none. `edge`: 0 … 2³¹ − 1. */
  get(edge: number): number {
    const at = this.#placeOf(edge);
    return this.#keys[at] === edge ? this.#vertices[at]! : -1;
  }

  set(edge: number, vertex: number): void {
    const at = this.#placeOf(edge);
    if (this.#keys[at] === FREE) this.#count++;
    this.#keys[at] = edge;
    this.#vertices[at] = vertex;
    if (2 * this.#count > this.#keys.length) this.#grow();
  }

  /** Where it is, or may be put. */
  #placeOf(edge: number): number {
    const keys = this.#keys;
    const last = keys.length - 1;
    let at = Math.imul(edge, SPREADING) >>> (32 - this.#bits);
    while (keys[at] !== edge && keys[at] !== FREE) at = (at + 1) & last;
    return at;
  }

  #grow(): void {
    const [keys, vertices] = [this.#keys, this.#vertices];
    this.#bits++;
    this.#keys = new Int32Array(1 << this.#bits).fill(FREE);
    this.#vertices = new Int32Array(1 << this.#bits);
    for (let i = 0; i < keys.length; i++) {
      if (keys[i] === FREE) continue;
      const at = this.#placeOf(keys[i]!);
      this.#keys[at] = keys[i]!;
      this.#vertices[at] = vertices[i]!;
    }
  }
}
