/** The larger of the two (Ricci): exact for distances outside, with an edge where both are equal; there a's gradient. */
import { monotone, type Operation } from './operation.ts';

export const hardUnion: Operation = {
  value: (a, b) => Math.max(a, b),
  evaluate(a, b, out) {
    out[0] = Math.max(a, b);
    out[1] = a >= b ? 1 : 0;
    out[2] = a >= b ? 0 : 1;
  },
  stretch: 1,
  isExtreme: true,
  range: monotone(Math.max),
  reach: (level) => -level,
};
