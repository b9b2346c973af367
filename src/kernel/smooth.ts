/**
 * How fast a power kernel k = (1 + r²)^(−n/2) and its slope along a line change anywhere, in parts of its value there: so for what
 * is made of such kernels, by ∫|w| k.
 *
 * Theory: with M² = 1 + r² and y ≤ r what is along the line of the way to the source, k′ = −n y k/M² and
 * k″ = (n (n + 2) y²/M² − n) k/M². So |k′| ≤ n/2 k, at r = 1, and k″ is largest for y = r, of which it is a polynomial in q = r²/M². Taylor's
 * remainder from one point (change.ts) takes n (n + 1) k/M² and more ahead: five times as much at the source of Cauchy's kernel.
 */

/** In parts of the value; Infinity where the kernel has no bound. */
export interface Smooth {
  readonly first: number;
  readonly second: number;
}

const ROUGH: Smooth = { first: Infinity, second: Infinity };

export function smoothness(core: number, n: number): Smooth {
  if (core !== 1) return ROUGH;
  // the largest of (n (n + 2) q − n)(1 − q) is at q = ½ + 1/2(n + 2); the least, at 0, is −n
  const q = 0.5 + 0.5 / (n + 2);
  return { first: n / 2, second: Math.max(n, (n * (n + 2) * q - n) * (1 - q)) };
}
