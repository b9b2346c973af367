/** q^(−n/2): whole n by roots and products, other n by e^(n/2 log 1/q), which 1e-14 is good for here. */
import { exp } from '../math/exp.ts';
import { log } from '../math/log.ts';

export const halfPower = (q: number, n: number): number => rootPower(1 / q, n);

/** i^(n/2): that of the Cauchy kernel in so few words that engines put it in place of the call. */
export const rootPower = (i: number, n: number): number => (n === 4 ? i * i : otherPower(i, n));

function otherPower(i: number, n: number): number {
  switch (n) {
    case 1:
      return Math.sqrt(i);
    case 2:
      return i;
    case 3:
      return i * Math.sqrt(i);
    case 5:
      return i * i * Math.sqrt(i);
    case 6:
      return i * i * i;
    case 7:
      return i * i * i * Math.sqrt(i);
    case 8:
      return i * i * (i * i);
    default:
      return exp(0.5 * n * log(i));
  }
}
