/**
 * Bytes being written: text and numbers go straight into chunks, so that a file of hundreds of megabytes needs no string
 * that long and no array that is copied again and again.
 */
import { digitsOf, POWERS } from './decimal.ts';
import { ExportError } from './error.ts';

const CHUNK = 1 << 20;
/** the longest number: sign, digits, point, zeros before it, exponent */
const LONGEST_NUMBER = 40;
const MINUS = 45;
const POINT = 46;
const ZERO = 48;

export class ByteWriter {
  readonly #full: Uint8Array[] = [];
  readonly #encoder = new TextEncoder();
  #chunk = new Uint8Array(CHUNK);
  #at = 0;

  text(text: string): void {
    const bytes = this.#encoder.encode(text);
    this.#room(bytes.length);
    this.#chunk.set(bytes, this.#at);
    this.#at += bytes.length;
  }

  /** Characters of ASCII: for what is written millions of times, because an encoder costs more than they do. */
  ascii(text: string): void {
    this.#room(text.length);
    for (let i = 0; i < text.length; i++) this.#chunk[this.#at++] = text.charCodeAt(i);
  }

  /** A whole number from 0 to 2^53. */
  whole(value: number): void {
    this.#room(LONGEST_NUMBER);
    this.#digits(value, 1);
  }

  /** A float32 with the digits it needs to be read back to the bit; −0 is written as 0. */
  float(value: number): void {
    const { digits, places, exponent } = digitsOf(Math.abs(value));
    this.#room(LONGEST_NUMBER);
    if (value < 0) this.#chunk[this.#at++] = MINUS;
    const whole = Math.floor(digits / POWERS[places]!);
    this.#digits(whole, 1);
    if (places > 0) {
      this.#chunk[this.#at++] = POINT;
      this.#digits(digits - whole * POWERS[places]!, places);
    }
    if (exponent !== 0) this.ascii(`e${exponent}`);
  }

  bytes(): Uint8Array<ArrayBuffer> {
    const last = this.#chunk.subarray(0, this.#at);
    const all = reserve([...this.#full, last].reduce((sum, { length }) => sum + length, 0));
    let at = 0;
    for (const chunk of [...this.#full, last]) {
      all.set(chunk, at);
      at += chunk.length;
    }
    return all;
  }

  #digits(value: number, atLeast: number): void {
    let count = atLeast;
    while (count < POWERS.length && value >= POWERS[count]!) count++;
    let rest = value;
    for (let at = this.#at + count - 1; at >= this.#at; at--) {
      const tenth = Math.floor(rest / 10);
      this.#chunk[at] = ZERO + (rest - 10 * tenth);
      rest = tenth;
    }
    this.#at += count;
  }

  #room(bytes: number): void {
    if (this.#at + bytes <= this.#chunk.length) return;
    this.#full.push(this.#chunk.subarray(0, this.#at));
    this.#chunk = new Uint8Array(Math.max(CHUNK, bytes));
    this.#at = 0;
  }
}

/** Room for a whole file; ExportError when there is none of that size. */
export function reserve(bytes: number): Uint8Array<ArrayBuffer> {
  try {
    return new Uint8Array(bytes);
  } catch {
    throw new ExportError(`the file would be ${(bytes / 1e9).toFixed(1)} GB, more than fits into memory`);
  }
}
