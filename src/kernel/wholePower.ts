/** ∫ (q + τ²)^(−n/2) over an infinite line, and over an infinite plane at squared distance q. */
import { exp } from '../math/exp.ts';
import { log } from '../math/log.ts';
import { PI } from '../math/trig.ts';
import { halfPower } from './halfPower.ts';

/** n > 1. */
export function wholeLineOfPower(q: number, n: number): number {
  return lineAtOne(n) * halfPower(q, n - 1);
}

/** Infinity for n ≤ 2. */
export function wholePlaneOfPower(q: number, n: number): number {
  if (n <= 2) return Infinity;
  return (2 * PI * exp((1 - 0.5 * n) * log(q))) / (n - 2);
}

/** √π Γ((n − 1)/2)/Γ(n/2): upwards by n/(n − 1) a step of two, where the asymptotic series of the quotient holds. */
function lineAtOne(n: number): number {
  let factor = 1;
  let m = n;
  for (; m < 60; m += 2) factor *= m / (m - 1);
  const i = 2 / (m - 1);
  const series =
    1 +
    i *
      (-1 / 8 +
        i * (1 / 128 + i * (5 / 1024 + i * (-21 / 32768 + i * (-399 / 262144 + i * (869 / 4194304))))));
  return (factor * Math.sqrt(PI * i)) / series;
}
