/** The published JSON Schema, the schemas that read files, and the commands there are say the same. */
import { readFileSync } from 'node:fs';
import * as v from 'valibot';
import { describe, expect, it } from 'vitest';
import { COMMAND_TYPES } from '../../src/document/command/index.ts';
import { commands, documentFile, scriptFile } from '../../src/document/fileSchema.ts';
import { jsonSchema } from './jsonSchema.ts';
import { accepts } from './jsonSchemaCheck.ts';
import { mutant, soundTexts } from './mutate.ts';

const FILE = new URL('../../docs/rotund.schema.json', import.meta.url);
const published = JSON.parse(readFileSync(FILE, 'utf8')) as Record<string, unknown>;

/** By the shape of each field alone: rules that look at several places are no matter of a JSON Schema. */
function isSoundByField(data: unknown): boolean {
  return [documentFile, scriptFile, commands].some((schema) => {
    const { issues = [] } = v.safeParse(schema, data);
    return issues.every(({ type }) => type === 'raw_check');
  });
}

describe('docs/rotund.schema.json', () => {
  it('is what `node scripts/schema.mjs` makes', () => {
    expect(published).toEqual(JSON.parse(JSON.stringify(jsonSchema())));
  });

  it('has every command', () => {
    const { command } = published.$defs as {
      command: { oneOf: { properties: { type: { const: string } } }[] };
    };
    const types = command.oneOf.map(({ properties }) => properties.type.const);
    expect(types.sort()).toEqual([...COMMAND_TYPES].sort());
  });

  it('accepts sound files', () => {
    for (const text of soundTexts()) expect(accepts(published, JSON.parse(text))).toBe(true);
  });

  const blocks = Array.from({ length: 5 }, (_, i) => [200 * i, 200 * i + 199] as const);
  it.each(blocks)(
    'accepts and refuses what the program does, field by field (mutants %i to %i)',
    {
      timeout: 60_000,
    },
    (from, to) => {
      let refused = 0;
      for (let seed = from; seed <= to; seed++) {
        const { kind, text } = mutant(seed);
        // a million things, or what is not JSON, says nothing about fields
        const data = text.length > 200_000 ? undefined : dataOf(text);
        if (data === undefined) continue;
        const sound = isSoundByField(data);
        expect(accepts(published, data), `${seed}: ${kind}`).toBe(sound);
        if (!sound) refused++;
      }
      expect(refused).toBeGreaterThan(60);
    },
  );
});

function dataOf(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}
