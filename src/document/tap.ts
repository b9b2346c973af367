/** A tap of the pen, too short to be a line: the place where it rested. */
import type { Curve } from '../stroke/curve.ts';
import type { Stroke } from '../stroke/stroke.ts';

export function tapOf({ samples, closed }: Stroke): Curve {
  const mean = (of: (sample: Stroke['samples'][number]) => number): number =>
    samples.reduce((sum, sample) => sum + of(sample) / samples.length, 0);
  const at = [mean(({ x }) => x), mean(({ y }) => y)] as const;
  const pressure = mean((sample) => sample.pressure);
  return { closed, length: 0, corners: [], point: () => at, tangent: () => [1, 0], pressure: () => pressure };
}
