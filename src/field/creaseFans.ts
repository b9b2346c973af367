/**
 * Triangles around points on creases: a fan each, whose rim edges that cross the crease are turned, so that they run along it
 * from point to point (Kobbelt et al. 2001). A point has a copy for each side, with that side's normal.
 *
 * A rim edge belongs to two loops, in cubes side by side. It is turned when both have points, and no edge between
 * these is there yet: a second one would have four triangles.
 */

type Triangle = (a: number, b: number, c: number) => void;

/** The copies of a point, by branch. */
export interface Fan {
  readonly copies: ReadonlyMap<number, number>;
}

/** A rim edge from `a` to `b` that waits for the loop on its other side. */
interface Waiting {
  readonly fan: Fan;
  readonly a: number;
  readonly b: number;
}

export class CreaseFans {
  readonly #branches: readonly number[];
  readonly #visit: Triangle;
  readonly #waiting = new Map<string, Waiting>();
  readonly #along = new Set<string>();

  /** `branches`: of each vertex. */
  constructor(branches: readonly number[], visit: Triangle) {
    this.#branches = branches;
    this.#visit = visit;
  }

  /** The loop `ring`, in order, around a point. */
  add(ring: readonly number[], fan: Fan): void {
    ring.forEach((a, i) => {
      const b = ring[(i + 1) % ring.length]!;
      if (this.#branches[a] === this.#branches[b]) this.#plain(fan, a, b);
      else this.#cross(fan, a, b);
    });
  }

  /** What is left waiting has no point on its other side. */
  finish(): void {
    for (const { fan, a, b } of this.#waiting.values()) this.#plain(fan, a, b);
    this.#waiting.clear();
  }

  #plain({ copies }: Fan, a: number, b: number): void {
    this.#visit(copies.get(this.#branches[a]!)!, a, b);
  }

  #cross(fan: Fan, a: number, b: number): void {
    const key = keyOf(a, b);
    const other = this.#waiting.get(key);
    if (!other) {
      this.#waiting.set(key, { fan, a, b });
      return;
    }
    this.#waiting.delete(key);
    const along = keyOf(first(fan), first(other.fan));
    if (this.#along.has(along)) {
      this.#plain(fan, a, b);
      this.#plain(other.fan, b, a);
      return;
    }
    this.#along.add(along);
    const [sideA, sideB] = [this.#branches[a]!, this.#branches[b]!];
    this.#visit(fan.copies.get(sideA)!, a, other.fan.copies.get(sideA)!);
    this.#visit(other.fan.copies.get(sideB)!, b, fan.copies.get(sideB)!);
  }
}

const first = ({ copies }: Fan): number => copies.values().next().value!;

const keyOf = (a: number, b: number): string => (a < b ? `${a} ${b}` : `${b} ${a}`);
