/**
 * A file's text as data: no longer than a file may be, no deeper than anything we know, and JSON. Depth is counted before
 * the engine reads, because a text of brackets only would take all memory.
 */
import { FileError, shown } from './fileError.ts';
import { jsonFault } from './jsonFault.ts';
import { LIMITS } from './limits.ts';

const WANTED = 'a Rotund document or script';

/** The data in a JSON text, an object or a list; FileError for anything else. `wanted`: what messages say was expected. */
export function readJson(text: string, file: string, wanted = WANTED): object {
  if (text.length > LIMITS.text) throw tooLong(text.length, file);
  const json = text.startsWith('\ufeff') ? text.slice(1) : text;
  const start = /\S/.exec(json)?.index;
  if (start === undefined) throw new FileError(file, '', `the file is empty; expected ${wanted}`);
  if (json[start] !== '{' && json[start] !== '[') throw noRotund(json, start, file, wanted);
  const deep = tooDeep(json);
  if (deep !== null) {
    throw new FileError(
      file,
      lineOf(json, deep),
      `expected at most ${LIMITS.depth} brackets inside each other`,
    );
  }
  try {
    return JSON.parse(json);
  } catch {
    throw notJson(json, file, wanted);
  }
}

function tooLong(length: number, file: string): FileError {
  const [most, found] = [LIMITS.text, length].map((count) => `${Math.ceil(count / (1024 * 1024))} MiB`);
  return new FileError(file, '', `expected at most ${most} of text, found ${found}`);
}

function noRotund(json: string, start: number, file: string, wanted: string): FileError {
  const beginning = shown(json.slice(start, start + 12));
  return new FileError(
    file,
    '',
    `not a Rotund file: expected ${wanted}, which begins with { or [, found ${beginning}`,
  );
}

function notJson(json: string, file: string, wanted: string): FileError {
  const fault = jsonFault(json);
  if (!fault) return new FileError(file, '', `expected ${wanted}, found JSON that cannot be read here`);
  const { offset, expected } = fault;
  const cutOff = offset >= json.length;
  const found = cutOff ? 'the end: the file is cut off' : shown(json.slice(offset, offset + 12));
  return new FileError(file, lineOf(json, offset), `expected ${expected}, found ${found}`);
}

/** "line 3, column 14", both from 1. */
function lineOf(text: string, offset: number): string {
  const before = text.slice(0, offset);
  const line = before.match(/\r\n?|\n/g)?.length ?? 0;
  const start = Math.max(before.lastIndexOf('\n'), before.lastIndexOf('\r')) + 1;
  return `line ${line + 1}, column ${offset - start + 1}`;
}

/** Where brackets are nested deeper than any file of ours; null: nowhere. */
function tooDeep(text: string): number | null {
  let depth = 0;
  for (let i = 0; i < text.length; i++) {
    const character = text.charCodeAt(i);
    if (character === QUOTE) i = quoteAfter(text, i);
    else if (character === BRACE || character === BRACKET) {
      if (++depth > LIMITS.depth) return i;
    } else if (character === BRACE + 2 || character === BRACKET + 2) depth--;
  }
  return null;
}

const QUOTE = 34;
const BRACKET = 91;
const BRACE = 123;
const BACKSLASH = 92;

/** The end of the quoted text that begins at i. */
function quoteAfter(text: string, i: number): number {
  for (let k = i + 1; k < text.length; k++) {
    const character = text.charCodeAt(k);
    if (character === QUOTE) return k;
    if (character === BACKSLASH) k++;
  }
  return text.length;
}
