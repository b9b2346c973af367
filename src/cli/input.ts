/** The input: a file or standard input, as text, as a drawing. */
import { readFileSync, statSync } from 'node:fs';
import type { Drawing } from '../document/drawing.ts';
import { LIMITS } from '../document/limits.ts';
import { parse } from '../document/serialize.ts';
import { fileProblem, Problem } from './problem.ts';

export interface Input {
  readonly drawing: Drawing;
  /** what messages call it */
  readonly name: string;
}

/** Throws Problem, or FileError for what is in the file. */
export async function readInput(path: string): Promise<Input> {
  const { text, name } = await readText(path, 'a drawing or a script');
  return { drawing: parse(text, name), name };
}

/** `what`: what messages say was expected. */
export async function readText(
  path: string,
  what: string,
): Promise<{ readonly text: string; readonly name: string }> {
  const name = path === '-' ? 'standard input' : path;
  const bytes = path === '-' ? await standardInput(what) : fileBytes(path, what);
  return { text: textOf(bytes, name), name };
}

function fileBytes(path: string, what: string): Uint8Array {
  try {
    const stats = statSync(path);
    if (stats.isDirectory()) throw new Problem(`${path}: expected ${what}, found a folder`);
    if (stats.size > LIMITS.bytes) throw tooLarge(path, what);
    return readFileSync(path);
  } catch (error) {
    throw error instanceof Problem ? error : fileProblem(path, 'read', error);
  }
}

async function standardInput(what: string): Promise<Uint8Array> {
  const chunks: Buffer[] = [];
  let length = 0;
  for await (const chunk of process.stdin) {
    length += chunk.length;
    if (length > LIMITS.bytes) throw tooLarge('standard input', what);
    chunks.push(chunk);
  }
  return Buffer.concat(chunks);
}

const tooLarge = (name: string, what: string): Problem =>
  new Problem(`${name}: expected ${what} of at most ${LIMITS.bytes / 2 ** 20} MiB, found more`);

function textOf(bytes: Uint8Array, name: string): string {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    throw new Problem(`${name}: expected text in UTF-8, found other bytes`);
  }
}
