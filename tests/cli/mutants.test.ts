/** Files gone wrong, to the command line: a mesh, or a sentence, status 2 and nothing written. `npm run test:full` tries more. */
import { existsSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { mutant } from '../document/mutate.ts';
import { useProgram } from './program.ts';

const BLOCK = 4;
const BLOCKS = process.env.ROTUND_FULL ? 120 : 6;

/** Whether there is a mesh at all shows in any. */
const COARSE = ['--surface-resolution', '8', '--resolution', '8'];

const { put, run, list, folder } = useProgram();

/** True when a mesh was written. */
async function tried(seed: number): Promise<boolean> {
  const { kind, text } = mutant(seed);
  const input = put(`${seed}.rotund`, text);
  const output = `${seed}.stl`;
  const { status, stdout, stderr } = await run(['mesh', input, '-o', output, ...COARSE]);
  const said = `seed ${seed}, ${kind}: ${stderr}`;
  expect(stderr, said).not.toContain('mistake in the program');
  expect(existsSync(join(folder, output)), said).toBe(status === 0);
  if (status === 0) expect(JSON.parse(stdout).fieldEvaluations, said).toBeGreaterThanOrEqual(0);
  else
    expect([status, stdout, stderr.split('\n').at(-2)?.startsWith(`rotund: ${input}`)], said).toEqual([
      2,
      '',
      true,
    ]);
  for (const name of [input, output]) rmSync(join(folder, name), { force: true });
  return status === 0;
}

describe('mutated documents and scripts', { timeout: 240_000 }, () => {
  const blocks = Array.from({ length: BLOCKS }, (_, i) => [i * BLOCK, (i + 1) * BLOCK - 1] as const);
  it.each(blocks)('seeds %i to %i', async (from, to) => {
    for (let seed = from; seed <= to; seed++) await tried(seed);
    expect(list()).toEqual([]);
  });
});
