/**
 * A smooth ascending map through given places: cubic Hermite pieces with slopes that keep every piece ascending (Fritsch and
 * Carlson 1980: the harmonic mean of the two sides, at ends the side itself).
 */

export interface Ascending {
  at(x: number): number;
  slope(x: number): number;
}

/** Through (xs[i], ys[i]), both strictly ascending, at least two; beyond them it goes on straight. */
export function ascending(xs: readonly number[], ys: readonly number[]): Ascending {
  const sides = xs.slice(1).map((x, i) => (ys[i + 1]! - ys[i]!) / (x - xs[i]!));
  const slopes = xs.map((_, i) => {
    const before = sides[i - 1] ?? sides[i]!;
    const after = sides[i] ?? before;
    return (2 * before * after) / (before + after);
  });
  const last = xs.length - 1;
  const piece = (x: number) => {
    let i = 0;
    while (i + 2 < xs.length && x >= xs[i + 1]!) i++;
    const width = xs[i + 1]! - xs[i]!;
    return { i, width, t: (x - xs[i]!) / width };
  };
  return {
    at: (x) => {
      if (x <= xs[0]!) return ys[0]! + slopes[0]! * (x - xs[0]!);
      if (x >= xs[last]!) return ys[last]! + slopes[last]! * (x - xs[last]!);
      const { i, width, t } = piece(x);
      // evenly spaced places stay even to the last bit
      if (slopes[i] === sides[i] && slopes[i + 1] === sides[i]) return ys[i]! * (1 - t) + ys[i + 1]! * t;
      const s = 1 - t;
      const bump = slopes[i]! * s - slopes[i + 1]! * t;
      return ys[i]! * s * s * (1 + 2 * t) + ys[i + 1]! * t * t * (3 - 2 * t) + width * bump * s * t;
    },
    slope: (x) => {
      if (x <= xs[0]!) return slopes[0]!;
      if (x >= xs[last]!) return slopes[last]!;
      const { i, t } = piece(x);
      const s = 1 - t;
      return 6 * sides[i]! * s * t + slopes[i]! * s * (1 - 3 * t) + slopes[i + 1]! * t * (1 - 3 * s);
    },
  };
}
