/** Skels that several benchmarks take. */
import type { Skel } from '../../src/skeleton/skels.ts';

/** Jin & Tai's scene. */
export const CROSS: readonly Skel[] = [
  { type: 'segment', a: [-4, 0, 0], b: [4, 0, 0], weights: [0.4, 0.3, -0.02, 0.001] },
  { type: 'segment', a: [0, -4, 0], b: [0, 4, 0], weights: [0.4, 0.3, -0.02, 0.001] },
];

export const LINEAR: Skel = { type: 'segment', a: [-2, -3, 1], b: [3, 2, -1], weights: [1, 0.1] };
