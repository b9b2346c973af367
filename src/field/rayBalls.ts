/**
 * Balls in a brick that surely hold no surface, about the middles of its cells: what looks of a few rays have said is there for
 * all others, from wherever they come. Each is made when a ray first comes by.
 */
import type { Brick, Bricks } from './bricks.ts';
import { BRICK, type Lattice } from './lattice.ts';
import type { Ray } from './near.ts';

/** along a brick; with 8 there are more looks for balls than they save */
const SIDE = 4;
/** of radii, for rounding */
const ROUNDED = 1 - 1e-9;
const TOWARDS: Ray = [1, 0, 0];

/** Those of all active bricks. */
export class BrickBalls {
  readonly #bricks: Bricks;
  readonly #made: (RayBalls | undefined)[];

  constructor(bricks: Bricks) {
    this.#bricks = bricks;
    this.#made = new Array(bricks.active.length).fill(undefined);
  }

  /** `place`: of the brick in `active`. */
  of(place: number): RayBalls {
    const { active, lattice } = this.#bricks;
    const made = this.#made[place] ?? new RayBalls(active[place]!, lattice);
    this.#made[place] = made;
    return made;
  }
}

const kept = new WeakMap<Bricks, BrickBalls>();

/** The same for all casters of the same bricks. */
export function ballsIn(bricks: Bricks): BrickBalls {
  const balls = kept.get(bricks) ?? new BrickBalls(bricks);
  kept.set(bricks, balls);
  return balls;
}

export class RayBalls {
  readonly #brick: Brick;
  readonly #x: number;
  readonly #y: number;
  readonly #z: number;
  /** mm between middles */
  readonly apart: number;
  /** mm; below 0 inside the body; NaN: not made */
  readonly #radii = new Float64Array(SIDE * SIDE * SIDE).fill(NaN);

  constructor(brick: Brick, { origin, step }: Lattice) {
    this.#brick = brick;
    this.#x = origin[0] + BRICK * step * brick.i;
    this.#y = origin[1] + BRICK * step * brick.j;
    this.#z = origin[2] + BRICK * step * brick.k;
    this.apart = (BRICK * step) / SIDE;
  }

  /** How far a ray from (x, y, z) on stays in a ball on that side of the surface and `beside` mm off its border, mm. */
  clear(ray: Ray, x: number, y: number, z: number, isInside: boolean, beside: number): number {
    const apart = this.apart;
    const i = placeOf((x - this.#x) / apart);
    const j = placeOf((y - this.#y) / apart);
    const k = placeOf((z - this.#z) / apart);
    const at = i + SIDE * (j + SIDE * k);
    const mx = this.#x + (i + 0.5) * apart;
    const my = this.#y + (j + 0.5) * apart;
    const mz = this.#z + (k + 0.5) * apart;
    let radius = this.#radii[at]!;
    if (Number.isNaN(radius)) {
      radius = this.#made(mx, my, mz);
      this.#radii[at] = radius;
    }
    if (radius < 0 !== isInside) return 0;
    const reach = Math.abs(radius) - beside;
    const [dx, dy, dz] = [mx - x, my - y, mz - z];
    const left = reach > 0 ? reach * reach - (dx * dx + dy * dy + dz * dz) : 0;
    if (!(left > 0)) return 0;
    const along = dx * ray[0] + dy * ray[1] + dz * ray[2];
    return along + Math.sqrt(left + along * along);
  }

  #made(x: number, y: number, z: number): number {
    const { near } = this.#brick;
    const value = near.look(TOWARDS, x, y, z, this.apart * SIDE);
    // bounds of the list hold in the brick only, and the ball is left where the brick is
    const radius = near.around() * ROUNDED;
    return value > 0 ? -radius : radius;
  }
}

const placeOf = (at: number): number => (at < 0 ? 0 : at >= SIDE ? SIDE - 1 : Math.floor(at));
