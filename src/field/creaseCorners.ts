/** Corners of a mesh, where three or more sides meet, by those sides: cubes around one find it again. */
import type { Vec3 } from '../math/vec.ts';
import type { Fan } from './creaseFans.ts';

interface Corner {
  readonly at: Vec3;
  readonly fan: Fan;
}

export class CreaseCorners {
  readonly #known = new Map<string, Corner[]>();

  add(branches: readonly number[], at: Vec3, fan: Fan | null): void {
    if (!fan) return;
    const key = branches.join(' ');
    this.#known.set(key, [...(this.#known.get(key) ?? []), { at, fan }]);
  }

  /** `apart`: mm along each axis at most. */
  near(branches: readonly number[], at: Vec3, apart: number): Fan | null {
    const known = this.#known.get(branches.join(' ')) ?? [];
    const found = known.find((corner) => corner.at.every((x, axis) => Math.abs(x - at[axis]!) <= apart));
    return found?.fan ?? null;
  }
}
