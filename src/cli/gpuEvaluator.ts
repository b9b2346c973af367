/** `rotund field --backend gpu`: WGSL in float32, on whatever adapter there is. */
import { evaluateAlone } from '../gpu/evaluate.ts';
import { type Evaluator, fieldOf } from './evaluator.ts';
import { Problem } from './problem.ts';
import { say } from './say.ts';
import type { Scale, VectorCase } from './vectors.ts';

/** Lends WebGPU for the time of `use`. */
export type OpenGpu = <T>(use: (gpu: GPU) => Promise<T>) => Promise<T>;

export function gpuEvaluator(open: OpenGpu): Evaluator {
  return {
    backend: 'gpu',
    async evaluate(cases) {
      // What has no field is refused in the words of its file.
      cases.forEach(fieldOf);
      const points = Float32Array.from(cases.flatMap(({ p }) => p));
      const evaluated = await open((gpu) => evaluateAlone(gpu, cases, points));
      if ('reason' in evaluated) throw new Problem(`--backend gpu: ${evaluated.reason}`, 1);
      say(`evaluated on ${evaluated.adapter}`);
      return evaluated.values;
    },
    tolerance,
  };
}

/** What float32 leaves, by 20,000 places a kernel; of singular kernels the axis is only known to 1e-7 of the length. */
function tolerance({ skel, kernel, p }: VectorCase): Scale {
  if (skel.type !== 'segment' || kernel.homogeneity === 0) return { value: 2e-6, gradient: 1e-5 };
  const { a, b } = skel;
  const along = [b[0] - a[0], b[1] - a[1], b[2] - a[2]] as const;
  const from = [p[0] - a[0], p[1] - a[1], p[2] - a[2]] as const;
  const squared = along[0] ** 2 + along[1] ** 2 + along[2] ** 2;
  const product = from[0] * along[0] + from[1] * along[1] + from[2] * along[2];
  const t = squared > 0 ? Math.min(1, Math.max(0, product / squared)) : 0;
  const distance = Math.hypot(from[0] - t * along[0], from[1] - t * along[1], from[2] - t * along[2]);
  const relative = 2 * (5e-6 + (1e-6 * Math.sqrt(squared)) / distance);
  return { value: relative, gradient: relative };
}
