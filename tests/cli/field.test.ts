/** `rotund field`: errors against reference vectors, and what it says of files that hold none. */
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe, expect, it } from 'vitest';
import { cpuEvaluator, type Evaluator } from '../../src/cli/evaluator.ts';
import { reportsOf } from '../../src/cli/field.ts';
import { readVectors } from '../../src/cli/vectors.ts';
import { FileError } from '../../src/document/serialize.ts';
import { useProgram } from './program.ts';

const VECTORS = resolve(import.meta.dirname, '../fixtures/vectors');
const textOf = (family: string) => readFileSync(resolve(VECTORS, `${family}.json`), 'utf8');
const point = {
  kernel: 'cauchy',
  params: { s: 1 },
  q: [0, 0, 0],
  weight: 2,
  p: [1, 0, 0],
  value: 0.5,
  gradient: [-1, 0, 0],
};
const fileOf = (family: string, ...cases: object[]) => JSON.stringify({ family, cases });

/** The reference with something added to a number of every case. */
const off = (k: number, by: number): Evaluator => ({
  ...cpuEvaluator,
  async evaluate(cases) {
    return Float64Array.from(await cpuEvaluator.evaluate(cases), (x, i) => (i % 4 === k ? x + by : x));
  },
});

describe('rotund field', () => {
  it.each(['point', 'segment', 'polygon'])(
    'the fields of the family %s are within 1e-12 of their scale',
    async (family) => {
      const reports = await reportsOf(readVectors(textOf(family), family), cpuEvaluator);
      expect(reports.reduce((sum, { count }) => sum + count, 0)).toBe(308);
      for (const { valueError, gradientError, pass } of reports) {
        expect(valueError).toBeLessThan(1e-12);
        expect(gradientError).toBeLessThan(1e-12);
        expect(pass).toBe(true);
      }
    },
  );

  it('finds errors of value and gradient, relative to the scale', async () => {
    const cases = readVectors(
      fileOf('point', point, {
        ...point,
        kernel: 'gaussian',
        value: 2 * Math.exp(-1),
        gradient: [-4 * Math.exp(-1), 0, 0],
        tag: 'bell',
      }),
      'v.json',
    );
    const right = await reportsOf(cases, cpuEvaluator);
    expect(right.map(({ kernel, count, pass }) => [kernel, count, pass])).toEqual([
      ['cauchy', 1, true],
      ['gaussian', 1, true],
    ]);
    const [value] = await reportsOf(cases, off(0, 3e-10));
    // of the weight 2, which is larger than the value
    expect(value!.valueError).toBeCloseTo(1.5e-10, 14);
    expect(value).toMatchObject({ family: 'point', backend: 'cpu', pass: false, gradientError: 0 });
    const [, gradient] = await reportsOf(cases, off(2, 1e-3));
    expect(gradient!.gradientError).toBeCloseTo(5e-4, 12);
    expect(gradient).toMatchObject({ pass: false, worst: { file: 'v.json', index: 1, tag: 'bell' } });
    const [nothing] = await reportsOf(cases, off(0, Number.NaN));
    expect(nothing).toMatchObject({ valueError: null, pass: false });
  });

  const WRONG: readonly (readonly [what: string, text: string, ...names: string[]])[] = [
    ['no object', '[]', 'v.json', 'family'],
    ['no JSON', '{"family": "point", ', 'v.json', 'line 1'],
    ['another family', fileOf('ring', point), 'family', 'point, segment or polygon', '"ring"'],
    ['no cases', fileOf('point'), 'cases', 'at least one'],
    ['a case of another family', fileOf('segment', point), 'cases[0].a', 'three numbers'],
    [
      'an unknown kernel',
      fileOf('point', point, { ...point, kernel: 'inverse4' }),
      'cases[1].kernel',
      '"inverse4"',
    ],
    ['two coordinates', fileOf('point', { ...point, p: [1, 2] }), 'cases[0].p', 'a number'],
    ['a text for a number', fileOf('point', { ...point, weight: '2' }), 'cases[0].weight', '"2"'],
    ['no value', fileOf('point', { ...point, value: undefined }), 'cases[0].value'],
  ];
  it.each(WRONG)('refuses a file with %s', (_, text, ...names) => {
    expect(() => readVectors(text, 'v.json')).toThrow(FileError);
    for (const name of names) expect(() => readVectors(text, 'v.json')).toThrow(name);
  });

  it('refuses a case that has no field, by its place', async () => {
    const cases = readVectors(fileOf('point', point, { ...point, params: { s: -1 } }), 'v.json');
    await expect(reportsOf(cases, cpuEvaluator)).rejects.toThrow(
      /v\.json, cases\[1\]: cauchy: s must be from/,
    );
  });
});

describe('the program', { timeout: 60_000 }, () => {
  const program = useProgram();

  it('prints a line for each family and kernel, and fails when one does', async () => {
    program.put('right.json', textOf('point'));
    program.put('wrong.json', fileOf('point', { ...point, value: 0.6 }));
    const good = await program.run(['field', 'right.json', resolve(VECTORS, 'segment.json')]);
    expect([good.status, good.stderr]).toEqual([0, '']);
    const lines = good.stdout.trimEnd().split('\n');
    expect(lines).toHaveLength(14);
    for (const line of lines) expect(JSON.parse(line)).toMatchObject({ backend: 'cpu', pass: true });
    const bad = await program.run(['field', '-', '--backend', 'cpu'], {
      stdin: fileOf('point', { ...point, value: 0.6 }),
    });
    expect(bad.status).toBe(1);
    expect(JSON.parse(bad.stdout)).toMatchObject({
      pass: false,
      worst: { file: 'standard input', index: 0 },
    });
    const both = await program.run(['field', 'right.json', 'wrong.json']);
    expect(both.status).toBe(1);
    expect(both.stdout.trimEnd().split('\n')).toHaveLength(7);
  });
});
