/**
 * Marching cubes without a table of triangles: on each face of a cube the places where the surface crosses its edges are
 * joined in pairs, and the pairs make closed loops around the cube, each a piece of surface. Neighbours join the same pairs
 * on the face between them, so that every edge of the mesh has two sides and every vertex one ring: watertight and
 * manifold whatever the values are.
 *
 * Theory: Lorensen & Cline 1987; where all four edges of a face are crossed, the sign at the saddle of the bilinear interpolant
 * decides which corners hang together (Nielson & Hamann 1991). Corners are masks of bits, 1 a step along x, 2 along y, 4 along z; an edge
 * is `corner + 8 axis`, its corner the one without that step.
 */

/** at most as many crossings; four loops of three at most */
export const MOST_CROSSINGS = 12;

/** Of a corner and an axis. */
export const edgeOf = (corner: number, axis: number): number => corner + 8 * axis;

/** Corners of each face, counter-clockwise from outside, and the edges from each to the next. */
export const FACES = (
  [
    [0, 4, 6, 2],
    [1, 3, 7, 5],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 2, 3, 1],
    [4, 5, 7, 6],
  ] as const
).map((corners) => ({
  corners,
  edges: corners.map((corner, i) => {
    const step = corner ^ corners[(i + 1) % 4]!;
    return edgeOf(corner & ~step, step >> 1);
  }),
}));

type Face = (typeof FACES)[number];

/** Whether all edges of a face are crossed: its corners are inside and outside in turn. */
export function isOpen({ corners: [a, b, c, d] }: Face, mask: number): boolean {
  const at = (corner: number) => (mask >> corner) & 1;
  return at(a) === at(c) && at(b) === at(d) && at(a) !== at(b);
}

/** Of the faces that the mask leaves open those that the values join, as bits. */
function joinedFaces(mask: number, values: ArrayLike<number>): number {
  let joined = 0;
  for (let number = 0; number < 6; number++) {
    const face = FACES[number]!;
    if (!isOpen(face, mask)) continue;
    const [a, b, c, d] = face.corners;
    const [ac, bd] = [values[a]! * values[c]!, values[b]! * values[d]!];
    if ((mask >> a) & 1 ? ac > bd : bd > ac) joined |= 1 << number;
  }
  return joined;
}

/** Whether a cube with these corners inside has a face of which all four edges are crossed. */
export const AMBIGUOUS = Uint8Array.from({ length: 256 }, (_, mask) =>
  FACES.some((face) => isOpen(face, mask)) ? 1 : 0,
);

/** Of one cube. */
export interface Loops {
  readonly count: number;
  /** one loop after the other: edges in order, counter-clockwise seen from outside of the solid */
  readonly edges: Uint8Array;
  /** where each ends in `edges` */
  readonly ends: Uint8Array;
  /** whether each has two crossings on a face that are no neighbours: a chord between them would lie in that face */
  readonly isTwisted: Uint8Array;
}

const known: (Loops | undefined)[] = Array.from({ length: 256 });

/** Of a cube without faces of which all four edges are crossed; found once for all. */
export function plainLoops(mask: number): Loops {
  const found = known[mask];
  if (found) return found;
  const made = new CubeLoops();
  made.follow(mask, 0);
  known[mask] = made;
  return made;
}

export class CubeLoops implements Loops {
  readonly edges = new Uint8Array(MOST_CROSSINGS);
  readonly ends = new Uint8Array(4);
  count = 0;
  readonly isTwisted = new Uint8Array(4);
  readonly #next = new Int8Array(24);
  readonly #leave = new Uint8Array(2);
  readonly #enter = new Uint8Array(2);
  #ambiguous = 0;

  /** `mask`: the corners that are inside (value above 0); `values`: of the eight corners. */
  trace(mask: number, values: ArrayLike<number>): void {
    this.follow(mask, joinedFaces(mask, values));
  }

  /** `joined`: a bit for each face of which the corners inside hang together where all its edges are crossed. */
  follow(mask: number, joined: number): void {
    this.count = 0;
    this.#ambiguous = 0;
    this.#next.fill(-1);
    for (let face = 0; face < 6; face++) this.#join(FACES[face]!, mask, (joined >> face) & 1);
    let end = 0;
    for (let edge = 0; edge < 24; edge++) {
      if (this.#next[edge]! < 0) continue;
      const start = end;
      for (let at = edge; this.#next[at]! >= 0; ) {
        this.edges[end++] = at;
        const next = this.#next[at]!;
        this.#next[at] = -1;
        at = next;
      }
      this.isTwisted[this.count] = this.#ambiguous > 0 && end - start > 3 ? 1 : 0;
      this.ends[this.count++] = end;
    }
  }

  /** From where the boundary of the face comes to the inside to where it leaves it: seen from outside of the cube, that is on the right. */
  #join({ corners, edges }: Face, mask: number, joined: number): void {
    const leave = this.#leave;
    const enter = this.#enter;
    let [leaving, entering] = [0, 0];
    for (let i = 0; i < 4; i++) {
      const here = (mask >> corners[i]!) & 1;
      const there = (mask >> corners[(i + 1) & 3]!) & 1;
      if (here > there) leave[leaving++] = edges[i]!;
      if (here < there) enter[entering++] = edges[i]!;
    }
    if (leaving === 0) return;
    if (leaving === 1) {
      this.#next[enter[0]!] = leave[0]!;
      return;
    }
    this.#ambiguous++;
    const isFirstInside = ((mask >> corners[0]!) & 1) === 1;
    // in order around the face: with the first corner inside it is left before it is entered
    const own = isFirstInside ? 1 : 0;
    const other = 1 - own;
    this.#next[enter[joined ? other : own]!] = leave[0]!;
    this.#next[enter[joined ? own : other]!] = leave[1]!;
  }
}
