/** What sampling all of a lattice would ask. */
import type { Lattice } from '../../src/field/lattice.ts';

export const nodeCount = ({ counts }: Lattice): number => counts[0] * counts[1] * counts[2];
