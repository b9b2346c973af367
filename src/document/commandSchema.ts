/** What a command in a script may look like: one line a command, and the compiler holds the list to the commands. */
import * as v from 'valibot';
import type { Command } from './command/index.ts';
import { fields, flag, list, number, oneOf, text, whole } from './fields.ts';
import { LIMITS, RANGES } from './limits.ts';
import { node } from './nodeSchema.ts';
import {
  bend,
  bendChange,
  brushChange,
  colour,
  componentChange,
  document,
  form,
  groupChange,
  intent,
  joins,
  name,
  placement,
  point,
  redrawnStroke,
  sectionStroke,
  skeleton,
  stroke,
  surfaceChange,
  u,
  unitVector,
  wholePart,
} from './schema.ts';

/** Without it the unfinished form is meant. */
const whose = { part: v.exactOptional(name) };
const index = whole({ min: 0, max: LIMITS.strokes });
const ids = list(name, LIMITS.strokes, 'ids');

const mirrorFields = { about: point, normal: unitVector };
const mirror = fields(mirrorFields);

const kind = <const T extends Command['type'], const E extends v.ObjectEntries>(type: T, data: E) =>
  fields({ type: v.literal(type, `"${type}"`), ...data });

const kinds = [
  kind('addStroke', { stroke, ...intent }),
  kind('addBody', {
    node,
    name: v.exactOptional(v.string('a text')),
    colour: v.exactOptional(colour),
  }),
  kind('setBody', { id: name, node }),
  kind('keep', {}),
  kind('drop', {}),
  kind('setBrush', { change: brushChange }),
  kind('setTubesOnly', { on: flag }),
  kind('removeLast', {}),
  kind('removeAll', {}),
  kind('removeParts', { ids }),
  // the command itself cuts what is too long
  kind('renamePart', { id: name, name: v.string('a text') }),
  kind('setPartBrush', { ids, change: brushChange }),
  kind('showParts', { ids, visible: flag }),
  kind('moveParts', { ids, by: placement }),
  kind('duplicateParts', { ids, offset: point, mirror: v.exactOptional(mirror) }),
  kind('scaleParts', { ids, factor: number(RANGES.factor), about: point }),
  kind('mirrorParts', { ids, ...mirrorFields }),
  kind('paste', { parts: list(wholePart, LIMITS.strokes, 'parts'), offset: point }),
  kind('setForm', {
    form: v.exactOptional(v.nullable(form)),
    joins: v.exactOptional(v.nullable(joins)),
    carves: v.exactOptional(flag),
  }),
  kind('setGroups', { ids, change: groupChange }),
  kind('setComponents', { ids, change: componentChange }),
  kind('moveGroups', { ids, to: v.nullable(joins) }),
  kind('editSkeleton', { id: name, skeleton: v.nullable(skeleton) }),
  kind('addSection', { ...whose, u, drawn: sectionStroke, side: v.exactOptional(oneOf(['front', 'back'])) }),
  kind('removeSection', {
    ...whose,
    index,
    only: v.exactOptional(oneOf(['back', 'redraw'])),
    redraw: v.exactOptional(v.pipe(index, v.description('beside "only": "redraw" alone'))),
  }),
  kind('redrawSection', {
    ...whose,
    u,
    drawn: redrawnStroke,
    local: v.exactOptional(v.literal(true, 'true')),
  }),
  kind('setStroke', { ...whose, index, stroke: v.nullable(stroke) }),
  kind('setSurface', { ids: v.exactOptional(ids), change: surfaceChange }),
  kind('bend', { id: name, bend }),
  kind('setBend', { id: name, index, change: v.nullable(bendChange) }),
  kind('recreate', { id: name }),
  kind('load', { document, name: v.optional(text(0, LIMITS.drawingName), '') }),
] as const;

type Read = v.InferOutput<(typeof kinds)[number]>;
/** A command without a line above is an error here. */
const types: readonly (Command['type'] extends Read['type'] ? string : never)[] = kinds.map(
  ({ entries }) => entries.type.literal,
);

export const command = v.variant('type', kinds, `one of ${types.join(', ')}`) satisfies v.GenericSchema<
  unknown,
  Command
>;

/** Parts that a command names. */
export function idsOf(command: Command): readonly string[] {
  if ('ids' in command) return command.ids ?? [];
  if ('part' in command) return command.part === undefined ? [] : [command.part];
  return 'id' in command ? [command.id] : [];
}
