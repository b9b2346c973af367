/**
 * Needles, and holes as narrow: a node of the lattice from which two of its lines soon leave the body in different directions. What is left of a needle along an
 * axis, where lines pass beside its middle, is a sliver, none of whose sides lie against each other along a line (a needle of 0.9 cells kept a fifth
 * of its volume). Edges and corners have such nodes too, but there all normals point to one side, or else, as at the rim of a plate, the body goes on
 * on one side: so the field is asked around the thinnest chord, which finds the outside everywhere.
 */
import { add3, dot3, length3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Chord, Surface } from './chords.ts';
import { BRICK, type Lattice } from './lattice.ts';
import type { Sided } from './local.ts';
import type { ThinSpot } from './thinWalls.ts';

/** Cells: cross sections that may have a single node, and lose 15 to 100 % of their area. Thicker ones lose up to 15 %, from 2.5 cells on 11 %. */
export const BAR = 2;
/** cosine: chords of plates have one direction */
const APART = 0.8;
/** cosine to that mean: normals of edges and corners of 60° or more are nearer to it */
const OPEN = 0.5;
/** radii from the middle of a bar: outside all around, of square ones too */
const BEYOND = 1.5;
/** Along the thinnest chord, across it, and in between. */
const AROUND = [
  ...[-1, 1].flatMap((y) => [0, 1, -1].map((x) => [x, y] as const)),
  ...[-1, 1].map((x) => [x, 0] as const),
];

interface Seen {
  readonly chord: Chord;
  readonly thickness: number;
}

export class Bars {
  readonly #surface: Surface;
  readonly #field: Sided;
  readonly #isGap: boolean;
  readonly #lattice: Lattice;
  readonly #atNode = new Map<number, Seen[]>();

  /** Of what is inside, or of gaps. */
  constructor(surface: Surface, lattice: Lattice, field: Sided, isGap: boolean) {
    this.#lattice = lattice;
    this.#surface = surface;
    this.#field = field;
    this.#isGap = isGap;
  }

  /** A chord of less than `BAR` cells. */
  add(chord: Chord, thickness: number): void {
    for (let i = 0; i < chord.nodes; i++) {
      const node = chord.node + i * chord.stride;
      const seen = this.#atNode.get(node);
      if (seen) seen.push({ chord, thickness });
      else this.#atNode.set(node, [{ chord, thickness }]);
    }
  }

  /** At most one in each brick, or a long needle would have the field asked again and again. */
  spots(): ThinSpot[] {
    const spots = new Map<number, ThinSpot>();
    for (const [node, seen] of this.#atNode) {
      const brick = seen.length > 1 ? this.#brickOf(node) : -1;
      const spot = brick < 0 || spots.has(brick) ? null : this.#spotOf(seen);
      if (spot) spots.set(brick, spot);
    }
    return [...spots.values()];
  }

  #brickOf(node: number): number {
    const [nx, ny] = this.#lattice.counts;
    const brick = (at: number) => Math.floor(at / BRICK);
    const [i, j, k] = [node % nx, Math.floor(node / nx) % ny, Math.floor(node / (nx * ny))];
    return brick(i) + nx * (brick(j) + ny * brick(k));
  }

  /** Of chords through one node. */
  #spotOf(seen: readonly Seen[]): ThinSpot | null {
    const { chord, thickness } = seen.reduce((a, b) => (b.thickness < a.thickness ? b : a));
    const way = this.#wayOf(chord);
    const across = seen
      .map((other) => this.#wayOf(other.chord))
      .find((other) => Math.abs(dot3(way, other)) < APART);
    if (!across || this.#isOpen(seen)) return null;
    const middle = scale3(add3(this.#within(chord.p, thickness), this.#within(chord.q, thickness)), 0.5);
    const side = unit(sub3(across, scale3(way, dot3(way, across))));
    // chords beside the middle of what is not round say too little: along and across, it has to be as thin as is told
    const widest = Math.min(BEYOND * thickness, BAR * this.#lattice.step);
    const isBar = AROUND.every(([x, y]) => {
      const out = unit(add3(scale3(way, x), scale3(side, y)));
      const width = x !== 0 && y !== 0 ? BEYOND * thickness : widest;
      return this.#field.value(...add3(middle, scale3(out, width / 2))) > 0 === this.#isGap;
    });
    return isBar ? { at: middle, thickness, across: BAR, isGap: this.#isGap } : null;
  }

  /** From one side of a chord to the other. */
  #wayOf({ p, q }: Chord): Vec3 {
    return unit(sub3(this.#normal(q), this.#normal(p)));
  }

  /** Whether all normals point to one side. */
  #isOpen(seen: readonly Seen[]): boolean {
    const normals = seen.flatMap(({ chord: { p, q } }) => [this.#normal(p), this.#normal(q)]);
    const mean = unit(normals.reduce(add3));
    return normals.every((normal) => dot3(normal, mean) > OPEN);
  }

  /** The middle of the ball that touches the side at a vertex. */
  #within(vertex: number, thickness: number): Vec3 {
    const { positions } = this.#surface;
    const at: Vec3 = [positions[3 * vertex]!, positions[3 * vertex + 1]!, positions[3 * vertex + 2]!];
    return sub3(at, scale3(this.#normal(vertex), thickness / 2));
  }

  /** Out of what is thin. */
  #normal(vertex: number): Vec3 {
    const { normals } = this.#surface;
    const sign = this.#isGap ? -1 : 1;
    return [sign * normals[3 * vertex]!, sign * normals[3 * vertex + 1]!, sign * normals[3 * vertex + 2]!];
  }
}

const unit = (way: Vec3): Vec3 => scale3(way, 1 / length3(way));
