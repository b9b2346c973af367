/**
 * The point in the middle of a loop, where it has one: on the crease or the corner that it is around, or on the surface in the middle of
 * a twisted loop. What was found before an edit is taken over by its key.
 */

import { add3, cross3, dot3, length3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { type Crease, creaseNear } from './crease.ts';
import type { Fan } from './creaseFans.ts';
import type { Near } from './near.ts';
import { NO_BRANCH, onSurface, type VertexStore } from './vertexStore.ts';

/** Cells from the middle of its loop that a point on a crease may be; blades end that far from where lattices see both sides. */
const REACH = 3;
/** cells: what is farther is held against the whole field */
const OWN = 1;
const ON = 0.05;
/** sine of an angle: what is turned by less is flat */
const TURNED = 0.05;
/** of the way to the middle of its loop: what is in one place with another point is moved by it */
const APART = 1e-3;
const TRIES = 8;

/** The number of a loop; and that before an edit where nothing changed, null where something did. */
export interface LoopKey {
  readonly now: number;
  readonly before: number | null;
}

/** On a crease, or in the middle of a loop, with the one normal there. */
export type LoopPoint = Crease;

const value = new Float64Array(4);

export class LoopPoints {
  readonly #store: VertexStore;
  #before: LoopPoints | null;
  readonly #step: number;
  /** places of points on creases */
  readonly #places = new Set<string>();
  readonly #found = new Map<string, LoopPoint | null>();

  constructor(store: VertexStore, step: number, before: LoopPoints | null) {
    this.#store = store;
    this.#step = step;
    this.#before = before;
  }

  /** What was before an edit. */
  forget(): void {
    this.#before = null;
  }

  /** What `search` finds, or found before where nothing changed since. `what`: of several points that the loop may have. */
  remembered({ now, before }: LoopKey, what: string, search: () => LoopPoint | null): LoopPoint | null {
    const then = before === null ? null : this.#before;
    const known = then ? then.#found.get(`${before} ${what}`) : undefined;
    const found = known === undefined ? search() : known;
    this.#found.set(`${now} ${what}`, found);
    return found;
  }

  /** The copies of a point on the crease, or at the corner, that the loop is around; null where there is none. */
  creased(near: Near, whole: Near, ring: readonly number[], key: LoopKey): Fan | null {
    const store = this.#store;
    const all = store.branches;
    const branches = [...new Set(ring.map((vertex) => all[vertex]!))].sort((a, b) => a - b);
    if (branches.length < 2 || branches.includes(NO_BRANCH)) return null;
    const middle = store.mean(store.positions, ring);
    const search = (of: readonly number[]) => () => {
      const found = creaseNear(near, of, middle, REACH * this.#step);
      return found && this.#isOn(near, whole, found.at, middle) ? found : null;
    };
    const found = this.remembered(key, 'all', search(branches));
    if (found) return this.#fanOf(ring, branches, found, middle);
    // sides that meet in no point nearby: the crease of the two that most of the loop is on
    if (branches.length === 2) return null;
    const count = (branch: number) => ring.filter((vertex) => all[vertex] === branch).length;
    const two = branches.toSorted((a, b) => count(b) - count(a)).slice(0, 2);
    const crease = this.remembered(key, 'two', search(two));
    if (!crease) return null;
    const normals = branches.map((branch) => crease.normals[two.indexOf(branch)] ?? crease.normals[0]!);
    return this.#fanOf(ring, branches, { at: crease.at, normals }, middle);
  }

  /** What else there is may hide where these sides meet. */
  #isOn(near: Near, whole: Near, at: Vec3, middle: Vec3): boolean {
    const isHere = at.every((x, axis) => Math.abs(x - middle[axis]!) < OWN * this.#step);
    (isHere ? near : whole).evaluate(...at, value);
    const slope = Math.sqrt(value[1]! * value[1]! + value[2]! * value[2]! + value[3]! * value[3]!);
    return Math.abs(value[0]!) <= ON * this.#step * slope;
  }

  /** Whether a triangle of the fan would be seen from within: of blades too thin for the lattice the tip is behind the loop. */
  #isTurned(ring: readonly number[], branches: readonly number[], { at, normals }: LoopPoint): boolean {
    const { branches: all } = this.#store;
    const positions = this.#store.positions.array;
    const from = (vertex: number): Vec3 => [
      positions[3 * vertex]! - at[0],
      positions[3 * vertex + 1]! - at[1],
      positions[3 * vertex + 2]! - at[2],
    ];
    return ring.some((a, i) => {
      const b = ring[(i + 1) % ring.length]!;
      if (all[a] !== all[b]) return false;
      const [p, q] = [from(a), from(b)];
      const across = cross3(p, q);
      return dot3(across, normals[branches.indexOf(all[a]!)]!) < -TURNED * length3(p) * length3(q);
    });
  }

  /** Null where it makes no sense. */
  #fanOf(
    ring: readonly number[],
    branches: readonly number[],
    { at: found, normals }: LoopPoint,
    middle: Vec3,
  ): Fan | null {
    if (this.#isTurned(ring, branches, { at: found, normals })) return null;
    const at = this.#own(found, middle);
    const store = this.#store;
    const copies = branches.map((branch, i) => {
      const side = ring.filter((vertex) => store.branches[vertex] === branch);
      const colour = store.mean(store.colours, side);
      return [branch, store.add(onSurface(at, normals[i]!), colour, branch)] as const;
    });
    return { copies: new Map(copies) };
  }

  /** A place that no other point has: loops around one corner find the same, and two vertices there would be one. */
  #own(found: Vec3, middle: Vec3): Vec3 {
    let at = found;
    for (let i = 0; i < TRIES; i++) {
      const place = Float32Array.from(at).join(' ');
      if (!this.#places.has(place)) {
        this.#places.add(place);
        break;
      }
      at = add3(at, scale3(sub3(middle, at), APART));
    }
    return at;
  }
}
