/**
 * Files: a drawing or a script as text, and back. Everything from outside is checked here, once; inside, types are
 * trusted. A script is carried out command by command, so that a command that does not fit is named. The format is
 * described in `docs/format.md`.
 */
import type { FieldNode } from '../field/node.ts';
import { partsOf } from '../field/numbered.ts';
import { applyChecked, checked } from './check.ts';
import { apply, type Command } from './command/index.ts';
import {
  type Brush,
  type Document,
  type Draft,
  EMPTY_DOCUMENT,
  formOfDraft,
  isBody,
  isSolid,
  isSurface,
} from './document.ts';
import type { Drawing } from './drawing.ts';
import { FRONT_VIEW } from './drawing.ts';
import { commandThen, documentThen, SOLIDS } from './earlier.ts';
import { FileError, shown } from './fileError.ts';
import {
  commands as commandsSchema,
  DOCUMENT_FORMAT,
  documentFile,
  SCRIPT_FORMAT,
  scriptFile,
  VERSIONS,
  type Version,
} from './fileSchema.ts';
import { isPlainFinish } from './finish.ts';
import { readJson } from './json.ts';
import { layout } from './layout.ts';
import { LIMITS } from './limits.ts';
import { DEFAULT_LOOK } from './look.ts';
import { groupsOf } from './solid.ts';
import { isPlain } from './surfacePart.ts';
import { writtenCommand, writtenDocument, writtenLook, writtenView } from './written.ts';

export { checkCommand, checkCommands, checkDocument, checkDrawing, checkStroke } from './check.ts';
export { FileError } from './fileError.ts';

/** Reads a document or a script; `file` is what messages call it. Throws FileError. */
export function parse(text: string, file: string): Drawing {
  try {
    return read(readJson(text, file), file);
  } catch (error) {
    // What no stack and no memory is enough for; anything else is a mistake of ours.
    if (!(error instanceof RangeError)) throw error;
    throw new FileError(
      file,
      '',
      `expected a file that this machine has room for, found ${shown(String(error))}`,
    );
  }
}

function read(data: object, file: string): Drawing {
  const ownName = nameOf(file);
  if (Array.isArray(data)) {
    const commands = checked(commandsSchema, data, { file, path: ['commands'] });
    return { name: ownName, view: FRONT_VIEW, look: DEFAULT_LOOK, document: carriedOut(commands, file) };
  }
  const format = formatOf(data as { format?: unknown; version?: unknown }, file);
  if (format === SCRIPT_FORMAT) {
    const { name = ownName, view, look, version, commands } = checked(scriptFile, data, { file });
    checkVersion(version, Math.max(1, ...new Set(commands.map(neededBy))) as Version, file);
    const then = commands.map((command) => commandThen(command, version));
    return { name, view, look, document: carriedOut(then, file) };
  }
  const { name = ownName, view, look, version, document } = checked(documentFile, data, { file });
  checkVersion(version, neededFor(document), file);
  return { name, view, look, document: documentThen(document, version) };
}

/** Version first: what else a newer file has is not for us to judge. */
function formatOf({ format, version }: { format?: unknown; version?: unknown }, file: string): string {
  if (format !== DOCUMENT_FORMAT && format !== SCRIPT_FORMAT) {
    const expected = `expected "${DOCUMENT_FORMAT}" or "${SCRIPT_FORMAT}", found ${shown(format)}`;
    throw new FileError(file, 'format', `not a Rotund file: ${expected}`);
  }
  const highest = VERSIONS.at(-1)!;
  if (Number.isInteger(version) && (version as number) > highest) {
    const message = `is version ${version}; this program reads up to ${highest}.`;
    throw new FileError(file, 'version', message, `${file} ${message}`);
  }
  return format;
}

/** What came with a version. */
const NEWS: Partial<Record<Version, string>> = { 2: 'bodies', 4: 'solids', 5: 'sections, bends or finishes' };

/** A program of that version would lose the bodies, so that nothing wrote such a file. */
function checkVersion(version: Version, needed: Version, file: string): void {
  if (version >= needed) return;
  throw new FileError(
    file,
    'version',
    `expected ${needed}, because there are ${NEWS[needed]} in it, found ${version}`,
  );
}

function carriedOut(commands: readonly Command[], file: string): Document {
  return commands.reduce(
    (document, command, i) => applyChecked(document, command, { file, path: ['commands', i] }),
    EMPTY_DOCUMENT,
  );
}

/** Without folders and ending. */
export const nameOf = (file: string): string =>
  [...file.replace(/^.*[\\/]|(\.script)?\.(rotund|json)$/gs, '')].slice(0, LIMITS.drawingName).join('');

/** Whether a text is a list of commands, bare or with a head; it may be no drawing at all. */
export function isScript(text: string): boolean {
  try {
    const data = readJson(text, '');
    return Array.isArray(data) || (data as { format?: unknown }).format === SCRIPT_FORMAT;
  } catch {
    return false;
  }
}

/** The text of a `.rotund` file. */
export function serialize(drawing: Drawing): string {
  const { document } = drawing;
  return layout({
    ...head(DOCUMENT_FORMAT, versionOf(document), drawing),
    document: writtenDocument(document),
  });
}

/** The text of a script: commands that make the document from an empty one. */
export function serializeScript(commands: readonly Command[], drawing: Drawing): string {
  const version = Math.max(1, ...new Set(commands.map(versionOfCommand))) as Version;
  return layout({
    ...head(SCRIPT_FORMAT, version, drawing),
    commands: commands.map(writtenCommand),
  });
}

/** The lowest that holds what there is, and that is read as it is. */
const versionOf = (document: Document): Version =>
  documentThen(document, 1) === document
    ? neededFor(document)
    : (Math.max(SOLIDS, neededFor(document)) as Version);

/** The lowest that knows the fields there are. Earlier ones read closed strokes otherwise (earlier.ts). */
function neededFor(document: Document): Version {
  const { parts, draft } = document;
  if (!brushesOf(document).every(({ finish }) => isPlainFinish(finish))) return SECTIONS;
  if (!parts.filter(isSurface).every(isPlain)) return SECTIONS;
  if (draft && (draft.recreates || isLatest(draft) || !isPlain(formOfDraft(draft)))) return SECTIONS;
  if (parts.some(isSolid) || draft?.form || draft?.joins || draft?.carves) return SOLIDS;
  const bodies = parts.filter(isBody);
  if (bodies.some(({ node }) => hasWidths(node))) return SOLIDS;
  return bodies.length > 0 ? 2 : 1;
}

/** The first version that has sections, bends and what goes with them. */
const SECTIONS: Version = 5;

/** Forms that came with them. */
const isLatest = ({ form }: { readonly form?: Draft['form'] | null }): boolean =>
  form === 'crossSection' || form === 'bspline';

function brushesOf({ brush, draft, parts }: Document): readonly Brush[] {
  const own = parts.flatMap((part) => {
    if (isSolid(part)) return groupsOf(part).map((group) => group.brush);
    return isSurface(part) ? [part.brush] : [];
  });
  return [brush, ...(draft?.recreates ? [draft.recreates.brush] : []), ...own];
}

/** Terms with a width of the kernel of their own came with solids. */
const hasWidths = (node: FieldNode): boolean =>
  node.type === 'skels' ? node.skels.some(({ params }) => params) : partsOf(node).some(hasWidths);

/** Commands that came with solids, or say what only solids know. */
const LATE: readonly Command['type'][] = [
  'scaleParts',
  'mirrorParts',
  'setForm',
  'setGroups',
  'setComponents',
  'moveGroups',
  'editSkeleton',
];

const LATEST: readonly Command['type'][] = [
  'addSection',
  'removeSection',
  'redrawSection',
  'setStroke',
  'setSurface',
  'bend',
  'setBend',
  'recreate',
];

function versionOfCommand(command: Command): Version {
  if (command.type === 'load') return versionOf(command.document);
  const isClosed = command.type === 'addStroke' && command.stroke.closed;
  return isClosed ? SOLIDS : neededBy(command);
}

function neededBy(command: Command): Version {
  if (command.type === 'load') return neededFor(command.document);
  if (LATEST.includes(command.type)) return SECTIONS;
  if ('change' in command && command.change && 'finish' in command.change) return SECTIONS;
  if (command.type === 'paste')
    return Math.max(SOLIDS, neededFor({ ...EMPTY_DOCUMENT, parts: command.parts })) as Version;
  if ((command.type === 'setForm' || command.type === 'addStroke') && isLatest(command)) return SECTIONS;
  if (LATE.includes(command.type) || 'mirror' in command) return SOLIDS;
  if (command.type === 'addStroke') return command.form || command.joins || command.carves ? SOLIDS : 1;
  if (command.type !== 'addBody' && command.type !== 'setBody') return 1;
  return hasWidths(command.node) ? SOLIDS : 2;
}

function head(format: string, needed: Version, { name, view, look }: Drawing) {
  const version = Math.max(look.mode === 'exact' ? 3 : 1, needed) as Version;
  return { format, version, unit: 'mm', name, view: writtenView(view), look: writtenLook(look) };
}

export function replay(commands: readonly Command[], from: Document = EMPTY_DOCUMENT): Document {
  return commands.reduce(apply, from);
}
