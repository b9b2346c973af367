/**
 * Data from outside, checked: what comes out has the type it claims, and is a copy. Pages hand such data to the element;
 * files come through `serialize.ts`. FileError names what was given (`command`), the place in it, and what was expected.
 */
import * as v from 'valibot';
import type { Stroke } from '../stroke/stroke.ts';
import { missedBy } from './aims.ts';
import { itemsOf } from './command/changeParts.ts';
import { apply, type Command } from './command/index.ts';
import { command as commandSchema, idsOf } from './commandSchema.ts';
import { type Document, isSolid, type Joins } from './document.ts';
import type { Drawing } from './drawing.ts';
import { documentThen } from './earlier.ts';
import { FileError, placeOf, shown } from './fileError.ts';
import { commands as commandsSchema, drawing as drawingSchema } from './fileSchema.ts';
import { REFUSED } from './rules.ts';
import { document as documentSchema, stroke as strokeSchema } from './schema.ts';
import { GROWING, isTooLarge, SIZE } from './size.ts';

/** Where the data lies in what a person knows: the file's name, and keys. */
export interface Whereabouts {
  readonly file: string;
  readonly path?: readonly PropertyKey[];
}

/** The value as the schema reads it. */
export function checked<S extends v.GenericSchema>(
  schema: S,
  value: unknown,
  { file, path = [] }: Whereabouts,
): v.InferOutput<S> {
  const result = parsed(schema, value, { file, path });
  if (result.success) return result.output;
  const issue = result.issues[0];
  const steps = issue.path ?? [];
  const keys = steps.map(({ key }) => key as PropertyKey);
  // a field that nobody knows is found in its object
  if (issue.expected === 'never' && issue.type === 'strict_object') {
    throw expected(file, [...path, ...keys.slice(0, -1)], issue.message, keys.at(-1));
  }
  if (issue.received === REFUSED) throw new FileError(file, placeOf([...path, ...keys]), issue.message);
  const found = steps.length ? steps.at(-1)?.value : value;
  throw expected(file, [...path, ...keys], issue.message, found);
}

function parsed<S extends v.GenericSchema>(schema: S, value: unknown, { file, path = [] }: Whereabouts) {
  try {
    return v.safeParse(schema, value, { abortEarly: true });
  } catch (error) {
    // trees in trees, without end perhaps
    if (!(error instanceof RangeError)) throw error;
    throw expected(file, path, 'data that this machine has room for', value);
  }
}

function expected(file: string, path: readonly PropertyKey[], what: string, found: unknown): FileError {
  return new FileError(file, placeOf(path), `expected ${what}, found ${shown(found)}`);
}

export const checkStroke = (value: unknown): Stroke => checked(strokeSchema, value, { file: 'stroke' });

export const checkDocument = (value: unknown): Document =>
  checked(documentSchema, value, { file: 'document' });

/** As in memory or as in a `.rotund` file. */
export function checkDrawing(value: unknown): Drawing {
  const { name, view, look, version, document } = checked(drawingSchema, value, { file: 'drawing' });
  return { name, view, look, document: documentThen(document, version) };
}

/** With `document` also whether the parts it names are there, and whether the document could take it. */
export function checkCommand(value: unknown, document?: Document): Command {
  const command = checked(commandSchema, value, { file: 'command' });
  if (document) applyChecked(document, command, { file: 'command' });
  return command;
}

/** The same for several, one after the other; none of them is good when one of them is not. */
export function checkCommands(value: unknown, document?: Document): readonly Command[] {
  const found = checked(commandsSchema, value, { file: 'commands' });
  if (document) {
    found.reduce((before, each, i) => applyChecked(before, each, { file: 'commands', path: [i] }), document);
  }
  return found;
}

/** The document after the command, which is sound in itself; FileError when the two do not fit together. */
export function applyChecked(
  document: Document,
  command: Command,
  { file, path = [] }: Whereabouts,
): Document {
  const ids = idsOf(command);
  const known = new Set(ids.length ? itemsOf(document).map(({ id }) => id) : []);
  const missing = ids.findIndex((id) => !known.has(id));
  if (missing >= 0) {
    const place = 'ids' in command ? ['ids', missing] : ['id' in command ? 'id' : 'part'];
    throw expected(file, [...path, ...place], 'the id of a part that is there by then', ids[missing]);
  }
  const { joins, place: at } = joinsOf(command);
  if (joins && !isThere(document, joins)) {
    throw expected(file, [...path, at], 'a solid, and a component of it, that are there by then', joins);
  }
  const fault = missedBy(document, command);
  if (fault) throw expected(file, [...path, ...fault.path], fault.expected, valueAt(command, fault.path));
  const after = apply(document, command);
  const grows = GROWING.includes(command.type) && isTooLarge(after);
  if (grows) {
    throw expected(file, [...path, 'type'], `a document of ${SIZE} after this`, command.type);
  }
  return after;
}

const valueAt = (value: unknown, path: readonly PropertyKey[]): unknown =>
  path.reduce<unknown>((of, key) => (of as Readonly<Record<PropertyKey, unknown>>)[key], value);

/** Where a command says that groups go. */
function joinsOf(command: Command): { readonly joins: Joins | null; readonly place: string } {
  if (command.type === 'moveGroups') return { joins: command.to, place: 'to' };
  return { joins: ('joins' in command && command.joins) || null, place: 'joins' };
}

const isThere = ({ parts }: Document, { solid, component }: Joins): boolean =>
  parts
    .filter(isSolid)
    .some(
      ({ id, components }) =>
        id === solid && (component === null || components.some((of) => of.id === component)),
    );
