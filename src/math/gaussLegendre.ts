/**
 * Gauss–Legendre rules as typed arrays, for sums written out where a callback would cost more than what it calls (one
 * with eight points and a callback is in quadrature.ts). With n points polynomials up to degree 2n − 1 are exact.
 * Nodes and weights are the doubles nearest to roots of P_n that were found with 50 digits.
 */

export interface GaussRule {
  /** in (−1, 1), ascending */
  readonly nodes: Float64Array;
  /** sum 2 */
  readonly weights: Float64Array;
}

export type GaussPoints = 1 | 2 | 3 | 4 | 5 | 6 | 10 | 16;

/** The rule from its nodes ≥ 0, each with its weight: mirrored, so that odd polynomials vanish exactly. */
function table(half: readonly (readonly [node: number, weight: number])[]): GaussRule {
  const left = half.filter(([node]) => node > 0).map(([node, weight]) => [-node, weight] as const);
  const all = [...left.reverse(), ...half];
  return {
    nodes: Float64Array.from(all, ([node]) => node),
    weights: Float64Array.from(all, ([, weight]) => weight),
  };
}

export const GAUSS: Readonly<Record<GaussPoints, GaussRule>> = {
  1: table([[0, 2]]),
  2: table([[0.5773502691896257, 1]]),
  3: table([
    [0, 0.8888888888888888],
    [0.7745966692414834, 0.5555555555555556],
  ]),
  4: table([
    [0.33998104358485626, 0.6521451548625461],
    [0.8611363115940526, 0.34785484513745385],
  ]),
  5: table([
    [0, 0.5688888888888889],
    [0.5384693101056831, 0.47862867049936647],
    [0.906179845938664, 0.23692688505618908],
  ]),
  6: table([
    [0.2386191860831969, 0.46791393457269104],
    [0.6612093864662645, 0.3607615730481386],
    [0.932469514203152, 0.17132449237917036],
  ]),
  10: table([
    [0.14887433898163122, 0.29552422471475287],
    [0.4333953941292472, 0.26926671930999635],
    [0.6794095682990244, 0.21908636251598204],
    [0.8650633666889845, 0.1494513491505806],
    [0.9739065285171717, 0.06667134430868814],
  ]),
  16: table([
    [0.09501250983763744, 0.1894506104550685],
    [0.2816035507792589, 0.18260341504492358],
    [0.45801677765722737, 0.16915651939500254],
    [0.6178762444026438, 0.14959598881657674],
    [0.755404408355003, 0.12462897125553388],
    [0.8656312023878318, 0.09515851168249279],
    [0.9445750230732326, 0.062253523938647894],
    [0.9894009349916499, 0.027152459411754096],
  ]),
};
