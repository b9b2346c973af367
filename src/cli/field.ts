/** `rotund field`: fields held against reference vectors, a line of JSON for each family and kernel. */
import type { Args } from './args.ts';
import { FIELD } from './commands.ts';
import { cpuEvaluator, type Evaluator } from './evaluator.ts';
import { readText } from './input.ts';
import { Problem } from './problem.ts';
import { result } from './say.ts';
import { readVectors, type VectorCase } from './vectors.ts';

/** Exit status 1 when a tolerance is missed; files are all read before anything is printed. */
export async function field({ operands, values }: Args): Promise<void> {
  if (operands.length === 0) throw new Problem(`no input; expected ${FIELD.synopsis}`);
  if (operands.includes('')) throw new Problem('the name of the input is empty');
  const evaluator = await evaluatorNamed(values.backend);
  const cases: VectorCase[] = [];
  for (const path of operands) {
    const { text, name } = await readText(path, 'a file of reference vectors');
    cases.push(...readVectors(text, name));
  }
  const reports = await reportsOf(cases, evaluator);
  for (const report of reports) result(report);
  if (reports.some(({ pass }) => !pass)) process.exitCode = 1;
}

/** What belongs to the GPU is loaded only when it is asked for. */
async function evaluatorNamed(name = 'cpu'): Promise<Evaluator> {
  if (name === 'cpu') return cpuEvaluator;
  if (name !== 'gpu') throw new Problem(`--backend: expected cpu or gpu; found '${name}'`);
  const [{ gpuEvaluator }, { withWebGpu }] = await Promise.all([
    import('./gpuEvaluator.ts'),
    import('./webgpu.ts'),
  ]);
  return gpuEvaluator(withWebGpu);
}

export interface FieldReport {
  readonly family: VectorCase['family'];
  readonly kernel: string;
  readonly backend: string;
  readonly count: number;
  /** largest, relative to the scale; null when a field is no finite number */
  readonly valueError: number | null;
  readonly gradientError: number | null;
  /** the case that comes nearest to its tolerance, or misses it by most */
  readonly worst: Place;
  readonly pass: boolean;
}

interface Place {
  readonly file: string;
  readonly index: number;
  readonly tag: string;
}

/** In the order in which families and kernels first appear. */
export async function reportsOf(cases: readonly VectorCase[], evaluator: Evaluator): Promise<FieldReport[]> {
  const fields = await evaluator.evaluate(cases);
  const errors = cases.map((one, i) => errorOf(one, i, fields, evaluator));
  const groups = new Map<string, CaseError[]>();
  for (const error of errors) {
    const key = `${error.one.family} ${error.one.kernelName}`;
    groups.set(key, [...(groups.get(key) ?? []), error]);
  }
  return [...groups.values()].map((group) => reportOf(group, evaluator.backend));
}

interface CaseError {
  readonly one: VectorCase;
  /** relative to the scale */
  readonly value: number;
  readonly gradient: number;
  /** the larger of both in units of its tolerance */
  readonly strain: number;
}

function errorOf(one: VectorCase, i: number, fields: ArrayLike<number>, { tolerance }: Evaluator): CaseError {
  const { scale, gradient } = one;
  const found = (k: number) => fields[4 * i + k]!;
  const value = relative(Math.abs(found(0) - one.value), scale.value);
  const apart = Math.hypot(found(1) - gradient[0], found(2) - gradient[1], found(3) - gradient[2]);
  const steep = relative(apart, scale.gradient);
  const most = tolerance(one);
  return { one, value, gradient: steep, strain: Math.max(value / most.value, steep / most.gradient) };
}

/** What is no number is infinitely far off. */
function relative(error: number, scale: number): number {
  if (error === 0) return 0;
  return Number.isFinite(error) && scale > 0 ? error / scale : Infinity;
}

function reportOf(group: readonly CaseError[], backend: string): FieldReport {
  const worst = group.reduce((most, error) => (error.strain > most.strain ? error : most));
  const { family, kernelName, file, index, tag } = worst.one;
  const largest = (of: (error: CaseError) => number) => {
    const most = group.reduce((found, error) => Math.max(found, of(error)), 0);
    return most < Infinity ? most : null;
  };
  return {
    family,
    kernel: kernelName,
    backend,
    count: group.length,
    valueError: largest(({ value }) => value),
    gradientError: largest(({ gradient }) => gradient),
    worst: { file, index, tag },
    pass: worst.strain <= 1,
  };
}
