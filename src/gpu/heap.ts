/** The one buffer that holds all records of a field, one after the other; each begins at a multiple of 16 bytes. */
import type { Members, RecordLayout, RecordValue } from '../math/record.ts';

/** bytes */
const GRAIN = 16;

export class Heap {
  #bytes = new ArrayBuffer(1 << 12);
  #end = 0;

  /** Where the next record will be. */
  get next(): number {
    return this.#end / GRAIN;
  }

  /** Where the record begins, in units of 16 bytes. */
  add<M extends Members>(layout: RecordLayout<M>, value: RecordValue<M>): number {
    const at = this.next;
    this.#grow(layout.stride);
    this.put(layout, at, value);
    return at;
  }

  /** Writes over the record at `at`. */
  put<M extends Members>(layout: RecordLayout<M>, at: number, value: RecordValue<M>): void {
    layout.write(new DataView(this.#bytes, GRAIN * at, layout.stride), 0, value);
  }

  /** All that was added. */
  bytes(): ArrayBuffer {
    return this.#bytes.slice(0, this.#end);
  }

  #grow(by: number): void {
    this.#end += by;
    if (this.#end <= this.#bytes.byteLength) return;
    const larger = new ArrayBuffer(Math.max(this.#end, 2 * this.#bytes.byteLength));
    new Uint8Array(larger).set(new Uint8Array(this.#bytes));
    this.#bytes = larger;
  }
}
