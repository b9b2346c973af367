/** The writer of bytes: chunks are joined without a seam. */
import { describe, expect, it } from 'vitest';
import { ByteWriter, reserve } from '../../src/export/bytes.ts';
import { ExportError } from '../../src/export/error.ts';
import { asText } from './readers.ts';

describe('bytes', () => {
  it('joins what is longer than its chunks', () => {
    const out = new ByteWriter();
    const expected: string[] = [];
    for (let i = 0; i < 200_000; i++) {
      out.ascii('v ');
      out.whole(i);
      out.text(' é\n');
      expected.push(`v ${i} é\n`);
    }
    expect(asText(out.bytes())).toBe(expected.join(''));
  });

  it('takes a text longer than a chunk', () => {
    const out = new ByteWriter();
    const long = 'ü'.repeat(2_000_000);
    out.ascii('a');
    out.text(long);
    out.ascii('z');
    expect(asText(out.bytes())).toBe(`a${long}z`);
  });

  it('writes whole numbers up to the largest exact one', () => {
    for (const value of [0, 9, 10, 99, 100, 4294967295, Number.MAX_SAFE_INTEGER]) {
      const out = new ByteWriter();
      out.whole(value);
      expect(asText(out.bytes())).toBe(String(value));
    }
  });

  it('says how large a file would be that does not fit', () => {
    expect(() => reserve(1e16)).toThrow(ExportError);
    expect(() => reserve(1e16)).toThrow(/10000000\.0 GB/);
  });
});
