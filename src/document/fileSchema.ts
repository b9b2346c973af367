/** The two kinds of files, as a whole. */
import * as v from 'valibot';
import { command } from './commandSchema.ts';
import { fields, list, text } from './fields.ts';
import { LIMITS } from './limits.ts';
import { document, look, view } from './schema.ts';

/** The versions this program reads: the second has bodies, the third exact surfaces in the look, the fourth solids of strokes, the fifth sections and bends of surfaces. It writes the lowest that holds what there is. */
export const VERSIONS = [1, 2, 3, 4, 5] as const;
export type Version = (typeof VERSIONS)[number];

export const DOCUMENT_FORMAT = 'rotund';
export const SCRIPT_FORMAT = 'rotund-script';

const version = v.picklist(VERSIONS, `version ${VERSIONS.slice(0, -1).join(', ')} or ${VERSIONS.at(-1)}`);
const format = <const F extends string>(name: F) => v.literal(name, `"${name}"`);

/** What both kinds of files may have beside the drawing itself. */
const frame = {
  /** for editors */
  $schema: v.optional(v.string('a text')),
  unit: v.optional(v.literal('mm', '"mm"'), 'mm'),
  name: v.optional(text(0, LIMITS.drawingName)),
  view: v.optional(view, {}),
  look: v.optional(look, {}),
};

export const documentFile = fields({ format: format(DOCUMENT_FORMAT), version, ...frame, document });

export const commands = list(command, LIMITS.commands, 'commands');

export const scriptFile = fields({ format: format(SCRIPT_FORMAT), version, ...frame, commands });

/** A drawing in hand: as in a file, and what says that it is a file may be missing. */
export const drawing = fields({
  format: v.optional(format(DOCUMENT_FORMAT), DOCUMENT_FORMAT),
  version: v.optional(version, 5),
  ...frame,
  name: v.optional(text(0, LIMITS.drawingName), ''),
  document,
});
