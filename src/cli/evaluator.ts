/** What a backend of `rotund field` is: it evaluates cases, and says how close it must come. */
import { FileError, placeOf } from '../document/fileError.ts';
import { bindSkel } from '../skeleton/index.ts';
import { FieldError, type SkelField } from '../skeleton/skeleton.ts';
import type { Scale, VectorCase } from './vectors.ts';

export interface Evaluator {
  readonly backend: 'cpu' | 'gpu';
  /** Value and gradient, four numbers a case. */
  evaluate(cases: readonly VectorCase[]): Promise<ArrayLike<number>>;
  /** Largest errors allowed, relative to the case's scale. */
  tolerance(one: VectorCase): Scale;
}

/** The reference: float64. */
export const cpuEvaluator: Evaluator = {
  backend: 'cpu',
  async evaluate(cases) {
    const all = new Float64Array(4 * cases.length);
    cases.forEach((one, i) => {
      fieldOf(one).add(...one.p, 1, all.subarray(4 * i, 4 * i + 4));
    });
    return all;
  },
  tolerance: () => ({ value: 1e-10, gradient: 1e-10 }),
};

/** FileError where a case has no field. */
export function fieldOf({ skel, kernel, params, file, index }: VectorCase): SkelField {
  try {
    return bindSkel(skel, kernel, params);
  } catch (error) {
    if (!(error instanceof FieldError)) throw error;
    throw new FileError(file, placeOf(['cases', index]), error.message);
  }
}
