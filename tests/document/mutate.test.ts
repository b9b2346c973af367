/** Files gone wrong are read or refused with a sentence, and nothing else happens. `npm run test:full` tries ten times as many. */
import { isDeepStrictEqual } from 'node:util';
import { afterEach, describe, expect, it } from 'vitest';
import { FileError, parse, serialize } from '../../src/document/serialize.ts';
import { topology } from '../../src/mesh/check.ts';
import { COARSE, meshesOf } from './files.ts';
import { type Mutant, mutant, soundTexts } from './mutate.ts';

const BLOCK = 50;
const BLOCKS = process.env.ROTUND_FULL ? 100 : 10;
const FILE = 'Pear.rotund';

/** True when it was read; what came out must then make finite meshes and survive another round. */
function tried({ kind, text }: Mutant): boolean {
  try {
    const drawing = parse(text, FILE);
    for (const mesh of meshesOf(drawing.document, COARSE)) expect(topology(mesh).finite, kind).toBe(true);
    const again = parse(serialize(drawing), 'x');
    // the same question asked of thousands of samples, three times as fast; the slow way says where
    if (!isDeepStrictEqual(again, drawing)) expect(again, kind).toEqual(drawing);
    return true;
  } catch (error) {
    if (!(error instanceof FileError)) throw error;
    expectSentence(error, kind);
    return false;
  }
}

function expectSentence({ message, file, place }: FileError, kind: string): void {
  expect(file, kind).toBe(FILE);
  expect(message.startsWith(FILE), message).toBe(true);
  expect(message, kind).toMatch(
    /expected .+, found .+|makes no field: .+|^Pear.rotund is version .+ reads up to 5\.$|brackets inside each other|the file is empty/,
  );
  expect(message, kind).not.toMatch(/[\p{Cc}\p{Cf}\p{Cs}]|machine has room/u);
  expect(message.length, message).toBeLessThan(500);
  if (!message.includes('is version'))
    expect(message.startsWith(place ? `${FILE}, ${place}: ` : `${FILE}: `)).toBe(true);
}

describe('mutated documents and scripts', { timeout: 120_000 }, () => {
  afterEach(() => {
    expect(Object.keys(Object.prototype)).toEqual([]);
    expect(({} as { polluted?: unknown }).polluted).toBeUndefined();
  });

  it('are made from sound ones', () => {
    for (const text of soundTexts()) expect(tried({ kind: 'none', text })).toBe(true);
  });

  const blocks = Array.from({ length: BLOCKS }, (_, i) => [i * BLOCK, (i + 1) * BLOCK - 1] as const);
  it.each(blocks)('seeds %i to %i', (from, to) => {
    const read = Array.from({ length: to - from + 1 }, (_, i) => tried(mutant(from + i))).filter(Boolean);
    // else the changes were too harsh or too tame to say anything
    expect(read.length).toBeGreaterThan(0);
    expect(read.length).toBeLessThan(BLOCK / 2);
  });
});
