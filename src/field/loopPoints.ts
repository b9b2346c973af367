/**
 * The point in the middle of a loop, where it has one: on the crease or the corner that it is around, or on the surface in the middle of
 * a twisted loop. What was found before an edit is taken over by its key.
 */

import { cross3, dot3, length3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { type Crease, creaseNear } from './crease.ts';
import { CreaseCorners } from './creaseCorners.ts';
import type { CreaseFans, Fan } from './creaseFans.ts';
import type { Near } from './near.ts';
import { NO_BRANCH, onSurface, type VertexStore } from './vertexStore.ts';

/** Cells from the middle of its loop that a point on a crease may be; blades end that far from where lattices see both sides. */
const REACH = 3;
/** cells: what is farther is held against the whole field */
const OWN = 1;
const ON = 0.05;
/** sine of an angle: what is turned by less is flat */
const TURNED = 0.05;
/** of a cell: corners as near to each other, of the same sides, are one */
const SAME = 0.02;

/** On a crease, or in the middle of a loop, with the one normal there. */
export type LoopPoint = Crease;

const value = new Float64Array(4);

export class LoopPoints {
  readonly #store: VertexStore;
  readonly #fans: CreaseFans;
  #before: LoopPoints | null;
  readonly #step: number;
  readonly #corners = new CreaseCorners();
  /** places of points on creases */
  readonly #places = new Set<string>();
  readonly #found = new Map<string, LoopPoint | null>();

  constructor(store: VertexStore, fans: CreaseFans, step: number, before: LoopPoints | null) {
    this.#store = store;
    this.#fans = fans;
    this.#step = step;
    this.#before = before;
  }

  /** What was before an edit. */
  forget(): void {
    this.#before = null;
  }

  /** What `search` finds, or found before where nothing changed since. */
  remembered(key: string, isSame: boolean, search: () => LoopPoint | null): LoopPoint | null {
    const before = this.#before;
    const known = isSame && before ? before.#found.get(key) : undefined;
    const found = known === undefined ? search() : known;
    this.#found.set(key, found);
    return found;
  }

  /** The copies of a point on the crease, or at the corner, that the loop is around; null where there is none. */
  creased(near: Near, whole: Near, ring: readonly number[], key: number, isSame: boolean): Fan | null {
    const store = this.#store;
    const all = store.branches;
    const branches = [...new Set(ring.map((vertex) => all[vertex]!))].sort((a, b) => a - b);
    if (branches.length < 2 || branches.includes(NO_BRANCH)) return null;
    const middle = store.mean(store.positions, ring);
    const search = (of: readonly number[]) => () => {
      const found = creaseNear(near, of, middle, REACH * this.#step);
      return found && this.#isOn(near, whole, found.at, middle) ? found : null;
    };
    const found = this.remembered(`${key} all`, isSame, search(branches));
    if (found) return this.#around(ring, branches, found);
    // sides that meet in no point nearby: the crease of the two that most of the loop is on
    if (branches.length === 2) return null;
    const count = (branch: number) => ring.filter((vertex) => all[vertex] === branch).length;
    const two = branches.toSorted((a, b) => count(b) - count(a)).slice(0, 2);
    const crease = this.remembered(`${key} two`, isSame, search(two));
    if (!crease) return null;
    const normals = branches.map((branch) => crease.normals[two.indexOf(branch)] ?? crease.normals[0]!);
    return this.#fanOf(ring, branches, { at: crease.at, normals });
  }

  /** What else there is may hide where these sides meet. */
  #isOn(near: Near, whole: Near, at: Vec3, middle: Vec3): boolean {
    const isHere = at.every((x, axis) => Math.abs(x - middle[axis]!) < OWN * this.#step);
    (isHere ? near : whole).evaluate(...at, value);
    const slope = Math.sqrt(value[1]! * value[1]! + value[2]! * value[2]! + value[3]! * value[3]!);
    return Math.abs(value[0]!) <= ON * this.#step * slope;
  }

  /** Corners may have been found from a cube beside this. */
  #around(ring: readonly number[], branches: readonly number[], found: LoopPoint): Fan | null {
    const known = this.#corners.near(branches, found.at, SAME * this.#step);
    if (known) return this.#fans.joins(ring, known) ? known : null;
    const fan = this.#fanOf(ring, branches, found);
    if (branches.length > 2) this.#corners.add(branches, found.at, fan);
    return fan;
  }

  /** Whether a triangle of the fan would be seen from within: of blades too thin for the lattice the tip is behind the loop. */
  #isTurned(ring: readonly number[], branches: readonly number[], { at, normals }: LoopPoint): boolean {
    const { positions, branches: all } = this.#store;
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

  /** Null where a vertex is there already, for two in one place would be one, or where it makes no sense. */
  #fanOf(ring: readonly number[], branches: readonly number[], { at, normals }: LoopPoint): Fan | null {
    const place = Float32Array.from(at).join(' ');
    if (this.#places.has(place)) return null;
    const store = this.#store;
    if (this.#isTurned(ring, branches, { at, normals })) return null;
    this.#places.add(place);
    const copies = branches.map((branch, i) => {
      const side = ring.filter((vertex) => store.branches[vertex] === branch);
      const colour = store.mean(store.colours, side);
      return [branch, store.add(onSurface(at, normals[i]!), colour, branch)] as const;
    });
    return { copies: new Map(copies) };
  }
}
