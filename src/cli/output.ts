/**
 * Output files: each whole or not at all. What can be known to fail is refused before the work; everything is written beside its
 * place first, and moved there by a rename, which is one step.
 */
import { randomBytes } from 'node:crypto';
import { lstatSync, realpathSync, renameSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { basename, dirname, extname, join, resolve } from 'node:path';
import { fileProblem, Problem } from './problem.ts';

export interface Output {
  /** as written on the command line */
  readonly path: string;
  readonly bytes: Uint8Array;
}

/** The path after -o; `example` shows what is expected. */
export function outputOf(path: string | undefined, example: string): string {
  if (path === undefined) throw new Problem(`no output; expected ${example}`);
  if (path === '-')
    throw new Problem('-o -: standard output carries the result; expected the name of a file');
  return path;
}

/** Refuses an output that could not be written, or must not be. */
export function checkOutput(path: string, input: string): void {
  const folder = dirname(path);
  const stats = lookedUp(folder);
  if (!stats) throw new Problem(`${path}: the folder ${folder} does not exist`);
  if (!stats.isDirectory()) throw new Problem(`${path}: ${folder} is not a folder`);
  const there = lookedUp(path);
  if (there?.isDirectory()) throw new Problem(`${path}: expected the name of a file, found a folder`);
  if (there?.isSymbolicLink()) throw new Problem(`${path}: is a link to a file that does not exist`);
  if (there && !there.isFile())
    throw new Problem(`${path}: expected a file or a new name, found a device or pipe`);
  if (input !== '-' && real(path) === real(input))
    throw new Problem(`${path}: output and input are the same file`);
}

/** The path of a file beside another. */
export function beside(path: string, name: string): string {
  return join(dirname(path), name);
}

/** The name of a file without folder and extension. */
export function stemOf(path: string): string {
  return basename(path, extname(path));
}

/** Writes all of them, and only then moves them into their places: what others refer to first, the one asked for last. */
export function writeOutputs(outputs: readonly Output[]): void {
  const waiting: { readonly path: string; readonly from: string }[] = [];
  let path = outputs[0]?.path ?? '';
  try {
    for (const output of outputs) {
      path = output.path;
      const to = real(path);
      const from = join(dirname(to), `.rotund-${process.pid}-${randomBytes(6).toString('hex')}.part`);
      waiting.push({ path: to, from });
      writeFileSync(from, output.bytes, { flag: 'wx' });
    }
    for (const { path: to, from } of [...waiting].reverse()) {
      path = to;
      renameSync(from, to);
    }
  } catch (error) {
    throw fileProblem(path, 'written', error);
  } finally {
    for (const { from } of waiting) rmSync(from, { force: true });
  }
}

function lookedUp(path: string) {
  try {
    return statSync(path, { throwIfNoEntry: false }) ?? lstatSync(path, { throwIfNoEntry: false });
  } catch (error) {
    throw fileProblem(path, 'written', error);
  }
}

/** Through links: a rename would replace the link itself. */
function real(path: string): string {
  try {
    return realpathSync(path);
  } catch {
    return resolve(path);
  }
}
