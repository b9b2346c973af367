/** Output files: whole or not at all. */
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { checkOutput, stemOf, writeOutputs } from '../../src/cli/output.ts';

let folder = '';
beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'rotund-output-'));
});
afterEach(() => rmSync(folder, { recursive: true, force: true }));

const at = (name: string) => join(folder, name);
const bytes = (text: string) => new TextEncoder().encode(text);

describe('output', () => {
  it('writes all files', () => {
    writeOutputs([
      { path: at('a.obj'), bytes: bytes('a') },
      { path: at('a.mtl'), bytes: bytes('b') },
    ]);
    expect(readdirSync(folder).sort()).toEqual(['a.mtl', 'a.obj']);
    expect(readFileSync(at('a.obj'), 'utf8')).toBe('a');
  });

  it('writes none when one cannot be written, and names it', () => {
    writeFileSync(at('a.obj'), 'old');
    const outputs = [
      { path: at('a.obj'), bytes: bytes('a') },
      { path: at('nowhere/a.mtl'), bytes: bytes('b') },
    ];
    expect(() => writeOutputs(outputs)).toThrow(/nowhere.a\.mtl: cannot be written/);
    expect(readdirSync(folder)).toEqual(['a.obj']);
    expect(readFileSync(at('a.obj'), 'utf8')).toBe('old');
  });

  it('leaves the first as it was when another cannot be put in its place', () => {
    writeFileSync(at('a.obj'), 'old');
    mkdirSync(at('a.mtl'));
    const outputs = [
      { path: at('a.obj'), bytes: bytes('a') },
      { path: at('a.mtl'), bytes: bytes('b') },
    ];
    expect(() => writeOutputs(outputs)).toThrow(/cannot be written/);
    expect(readFileSync(at('a.obj'), 'utf8')).toBe('old');
    expect(readdirSync(folder).sort()).toEqual(['a.mtl', 'a.obj']);
  });

  it('refuses the input itself, folders, and what is no file', () => {
    writeFileSync(at('in.rotund'), '');
    expect(() => checkOutput(at('in.rotund'), `${folder}/./in.rotund`)).toThrow('same file');
    expect(() => checkOutput(folder, '-')).toThrow('found a folder');
    if (existsSync('/dev/null')) expect(() => checkOutput('/dev/null', '-')).toThrow('device');
    expect(() => checkOutput(at('new.obj'), at('in.rotund'))).not.toThrow();
    expect(() => checkOutput(at('in.rotund/x/out.obj'), '-')).toThrow('a part of the path is a file');
    expect(() => checkOutput(at(`${'long'.repeat(100)}/out.obj`), '-')).toThrow('the name is too long');
  });

  it('knows the name without folder and extension', () => {
    expect(stemOf('out/my pear.v2.obj')).toBe('my pear.v2');
  });
});
