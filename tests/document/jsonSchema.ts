/** `docs/rotund.schema.json`, made from the schemas that read files. */
import { toJsonSchema } from '@valibot/to-json-schema';
import type { GenericSchema } from 'valibot';
import * as v from 'valibot';
import { command } from '../../src/document/commandSchema.ts';
import { commands, documentFile, scriptFile } from '../../src/document/fileSchema.ts';
import { tree } from '../../src/document/nodeSchema.ts';
import * as schemas from '../../src/document/schema.ts';
import { skel, term } from '../../src/document/skelSchema.ts';

const {
  bodyPart,
  surfacePart,
  brush,
  bend,
  brushChange,
  detail,
  document,
  draft,
  look,
  part,
  placement,
  plane,
  section,
  sectionStroke,
  redrawnStroke,
  shape,
  skeleton,
  solidPart,
  stroke,
  sumOfGroups,
  group,
  groupChange,
  joins,
  view,
} = schemas;

/** What has a name of its own in the schema. */
const definitions: Readonly<Record<string, GenericSchema>> = {
  documentFile,
  scriptFile,
  commands,
  command,
  document,
  part,
  surfacePart,
  bodyPart,
  solidPart,
  component: sumOfGroups,
  group,
  shape,
  groupChange,
  skeleton,
  joins,
  node: tree,
  term,
  skel,
  draft,
  stroke,
  section,
  sectionStroke,
  redrawnStroke,
  bend,
  detail,
  brush,
  brushChange,
  placement,
  plane,
  view,
  look,
};

/** What a JSON Schema cannot say, or says by metadata beside it. */
const IGNORED = ['check', 'finite', 'raw_check', 'raw_transform', 'transform'];

export function jsonSchema(): object {
  const { $schema, $defs, ...whole } = toJsonSchema(v.union([documentFile, scriptFile, commands]), {
    target: 'draft-2020-12',
    typeMode: 'input',
    ignoreActions: IGNORED,
    definitions: definitions as never,
  });
  return {
    $schema,
    title: 'Rotund document or script, version 1, 2, 3, 4 or 5',
    description: 'Lengths in millimetres, right-handed, y up. See format.md for what a schema cannot say.',
    ...whole,
    $defs,
  };
}
