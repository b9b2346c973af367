/** The station of a section after a bend (bendMap.ts), so that bends stack: what is asked for is worked out once. */
import { add2, add3, cross3, length3, scale3, sub2 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import { gainOf, inverse, type Matrix, type Move, times } from './bendMap.ts';
import type { Station } from './sheet.ts';
import type { Side2 } from './sideView.ts';

const transposed = ([[a, b], [c, d]]: Matrix): Matrix => [
  [a, c],
  [b, d],
];
const flat = (v: Vec3): Vec2 => [v[0], v[1]];
const deep = (v: Vec2, z: number): Vec3 => [v[0], v[1], z];

/** Where a point of the section goes, in the coordinates of the sheet; of whole rows in bentRow.ts. */
function moved(move: Move, view: Side2, p: Vec3): Vec3 {
  const at = view.point(p);
  const away = sub2(at, move.from());
  const still = away[0] === 0 && away[1] === 0;
  const to = still ? move.to() : add2(times(move.turn(), away), move.to());
  // what lies along V is not touched
  return add3(p, view.out(deep(sub2(to, at), 0)));
}

/** g: what the section's point gains by u beyond what its turn gives. */
function strainOf(move: Move, at: Vec2): Vec2 {
  const away = sub2(at, move.from());
  const gain = gainOf(move);
  return away[0] === 0 && away[1] === 0 ? gain : add2(times(move.dTurn(), away), gain);
}

/** The station afterwards, so that bends stack. Turns about the section's own normal are left out: they move nothing. */
export function moveStation(move: Move, view: Side2, station: Station): Station {
  return new MovedStation(move, view, station);
}

class MovedStation implements Station {
  readonly #move: Move;
  readonly #view: Side2;
  readonly #before: Station;
  #known: { centre?: Vec3; rate?: Vec3; normal?: Vec3; spin?: Vec3 } = {};

  constructor(move: Move, view: Side2, before: Station) {
    this.#move = move;
    this.#view = view;
    this.#before = before;
  }

  get centre(): Vec3 {
    this.#known.centre ??= moved(this.#move, this.#view, this.#before.centre);
    return this.#known.centre;
  }

  get rate(): Vec3 {
    this.#known.rate ??= this.#newRate();
    return this.#known.rate;
  }

  get normal(): Vec3 {
    if (!this.#known.normal) {
      const m = this.#carried();
      this.#known.normal = this.#view.out(scale3(m, 1 / length3(m)));
    }
    return this.#known.normal;
  }

  get spin(): Vec3 {
    this.#known.spin ??= this.#newSpin();
    return this.#known.spin;
  }

  #newRate(): Vec3 {
    const [move, view] = [this.#move, this.#view];
    const before = view.into(this.#before.rate);
    const at = view.point(this.#before.centre);
    return view.out(deep(add2(times(move.turn(), flat(before)), strainOf(move, at)), before[2]));
  }

  #newSpin(): Vec3 {
    const [move, view, before] = [this.#move, this.#view, this.#before];
    const m = this.#carried();
    const dBack = transposed(inverse(move.dTurn()));
    const dm = view.into(cross3(before.spin, before.normal));
    const gained = deep(
      add2(times(this.#back(), flat(dm)), times(dBack, flat(view.into(before.normal)))),
      dm[2],
    );
    const size = length3(m);
    return view.out(cross3(scale3(m, 1 / size), scale3(gained, 1 / size)));
  }

  /** A⁻ᵀ */
  #back(): Matrix {
    return transposed(inverse(this.#move.turn()));
  }

  /** A⁻ᵀ m, in the side view */
  #carried(): Vec3 {
    const m = this.#view.into(this.#before.normal);
    return deep(times(this.#back(), flat(m)), m[2]);
  }
}
