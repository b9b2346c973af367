/** A field at any place by the list of the brick there: a sign where that is known of all of a brick, below 0 beyond the lattice. */
import { type Bricks, INSIDE } from './bricks.ts';
import { BRICK } from './lattice.ts';

/** What is asked for its sign. */
export interface Sided {
  value(x: number, y: number, z: number): number;
}

export function localField({ lattice: { origin, step }, counts, grid, active }: Bricks): Sided {
  const [nx, ny, nz] = counts;
  const brickAt = (at: number, first: number) => Math.floor((at - first) / (BRICK * step));
  return {
    value: (x, y, z) => {
      const [i, j, k] = [brickAt(x, origin[0]), brickAt(y, origin[1]), brickAt(z, origin[2])];
      if (!(i >= 0 && j >= 0 && k >= 0 && i < nx && j < ny && k < nz)) return -1;
      const place = grid[i + nx * (j + ny * k)]!;
      return active[place]?.near.value(x, y, z) ?? (place === INSIDE ? 1 : -1);
    },
  };
}
