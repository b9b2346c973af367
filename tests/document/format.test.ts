/** docs/format.md: its examples are read, and its tables have every field, command and limit. */
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { makeBody } from '../../src/document/bodies.ts';
import { COMMAND_TYPES } from '../../src/document/command/index.ts';
import { bodiesOf } from '../../src/document/fieldParts.ts';
import { LIMITS } from '../../src/document/limits.ts';
import { parse, serialize } from '../../src/document/serialize.ts';
import { topology } from '../../src/mesh/check.ts';
import { meshesOf } from './files.ts';

const docs = readFileSync(new URL('../../docs/format.md', import.meta.url), 'utf8');
const schema = JSON.parse(readFileSync(new URL('../../docs/rotund.schema.json', import.meta.url), 'utf8'));
const examples = [...docs.matchAll(/```json\n([\s\S]*?)```/g)].map(([, text]) => text!);

interface Field {
  readonly minimum?: number;
  readonly maximum?: number;
  readonly maxLength?: number;
  readonly enum?: readonly string[];
  readonly anyOf?: readonly Field[];
  readonly prefixItems?: readonly Field[];
}

interface Variant {
  readonly properties: Readonly<
    Record<string, { readonly const?: string; readonly enum?: readonly string[] }>
  >;
}

/** The table whose first column is headed so, by field. */
function table(head: string): ReadonlyMap<string, string> {
  const rows = docs.split(`| ${head} | `)[1]?.split('\n\n')[0]?.split('\n').slice(2) ?? [];
  const named = rows.flatMap((row) =>
    [...row.split('|')[1]!.matchAll(/`([^`]+)`/g)].map(([, name]) => [name!, row] as const),
  );
  return new Map(named);
}

/** The numbers and words a field's row must give. */
function facts(field: Field): readonly string[] {
  const { minimum, maximum, maxLength, anyOf = [], prefixItems = [] } = field;
  const own = [minimum, maximum, maxLength, ...(field.enum ?? [])].filter((fact) => fact !== undefined);
  return [...own.map(String), ...[...anyOf, ...prefixItems].flatMap(facts)];
}

describe('docs/format.md', () => {
  it.each(examples.map((text, i) => [i + 1, text] as const))('example %i is sound', (_, text) => {
    const drawing = parse(text, 'example.rotund');
    expect(parse(serialize(drawing), 'example.rotund')).toEqual(drawing);
    for (const { node } of bodiesOf(drawing.document)) makeBody(node, 24);
    const meshes = meshesOf(drawing.document);
    expect(meshes.length).toBeGreaterThan(0);
    for (const mesh of meshes) expect(topology(mesh)).toMatchObject({ finite: true, watertight: true });
  });

  it('has documents, a bare list and a script with every command', () => {
    expect(examples).toHaveLength(6);
    const script = JSON.parse(examples[5]!) as { commands: { type: string }[] };
    expect([...new Set(script.commands.map(({ type }) => type))].sort()).toEqual([...COMMAND_TYPES].sort());
  });

  it('says what every command does', () => {
    const rows = table('command');
    expect([...rows.keys()].sort()).toEqual([...COMMAND_TYPES].sort());
    for (const { properties } of schema.$defs.command.oneOf) {
      const { type, ...fields } = properties;
      for (const key of Object.keys(fields)) expect(rows.get(type.const), key).toContain(`\`${key}\``);
    }
  });

  const sample = schema.$defs.stroke.properties.samples.items.anyOf[1];
  it.each([
    ['file', schema.$defs.documentFile],
    ['document', schema.$defs.document],
    ['surface', schema.$defs.surfacePart],
    ['draft', schema.$defs.draft],
    ['section', schema.$defs.section],
    ["section's stroke", schema.$defs.sectionStroke],
    ['bend', schema.$defs.bend],
    ['detail', schema.$defs.detail],
    ['body', schema.$defs.bodyPart],
    ['solid', schema.$defs.solidPart],
    ['component', schema.$defs.component],
    ['group', schema.$defs.group],
    ['shape of a group', schema.$defs.shape],
    ['skeleton', schema.$defs.skeleton],
    ['term', schema.$defs.term],
    ['warp', schema.$defs.term.properties.warp],
    ['brush', schema.$defs.brush],
    ['stroke', schema.$defs.stroke],
    ['sample', sample],
    ['plane', schema.$defs.plane],
    ['view', schema.$defs.view],
    ['placement', schema.$defs.placement],
    ['look', schema.$defs.look],
  ])('has every field of a %s, with its range', (head, { properties, required }) => {
    const rows = table(head);
    expect([...rows.keys()].sort()).toEqual(Object.keys(properties).sort());
    for (const [key, field] of Object.entries(properties)) {
      for (const fact of facts(field as Field)) expect(rows.get(key)).toContain(fact);
      expect(rows.get(key)!.includes('required'), key).toBe(required.includes(key));
    }
  });

  it.each([
    ['node of `type`', schema.$defs.node.oneOf],
    ['skel of `type`', schema.$defs.skel.oneOf],
    [
      'shape of `type`',
      schema.$defs.node.oneOf.find(({ properties }: Variant) => properties.shape).properties.shape.oneOf,
    ],
  ])('has every %s with its fields', (head, variants: readonly Variant[]) => {
    const rows = docs.split(`| ${head} | `)[1]!.split('\n\n')[0]!.split('\n').slice(2);
    const types = variants.flatMap(({ properties: { type } }) => type!.enum ?? [type!.const!]);
    const named = rows.flatMap((row) =>
      [...row.split('|')[1]!.matchAll(/`(\w+)`/g)].map(([, name]) => name!),
    );
    expect(named).toEqual(types);
    for (const { properties } of variants) {
      const { type, ...fields } = properties;
      const row = rows.find((text) => text.includes(`\`${type!.const ?? type!.enum![0]}\``));
      for (const key of Object.keys(fields)) expect(row, key).toContain(`\`${key}\``);
    }
  });

  it('names the limits', () => {
    const { text, depth, commands, strokes, samples, samplesInAll, sections, bends } = LIMITS;
    const limits = docs.split('## Limits')[1]!.split('##')[0]!;
    expect(limits).toContain(`| ${text / 1024 / 1024} MiB |`);
    for (const limit of [depth, commands, strokes, samples, samplesInAll, sections, bends])
      expect(limits).toContain(`| ${limit} |`);
  });
});
