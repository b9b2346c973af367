/**
 * Metamorphosis (Kravtsov et al. §1.2): (1 − t) a + t b, the operands themselves at the ends. Fields with alike values (two
 * bodies, two distances) turn into each other evenly; a mixed pair is led by the one with the larger values.
 */
import { FieldError } from '../skeleton/skeleton.ts';
import { monotone, type Operation } from './operation.ts';

export function morph(t: number): Operation {
  if (!(t >= 0 && t <= 1)) throw new FieldError(`t must be from 0 to 1, got ${t}`);
  const value = (a: number, b: number) => (1 - t) * a + t * b;
  return {
    value,
    stretch: 1,
    isExtreme: false,
    range: monotone(value),
    evaluate(a, b, out) {
      out[0] = (1 - t) * a + t * b;
      out[1] = 1 - t;
      out[2] = t;
    },
    reach: (level) => -level,
  };
}
