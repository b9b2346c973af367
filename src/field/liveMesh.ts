/**
 * The mesh of a body that is being edited: of what it was made of before everything is kept that a change does not reach, cubes of the
 * octree (liveBricks.ts), values, vertices. Trees that are built otherwise than before, and bodies that leave their lattice, are
 * made anew.
 */
import type { Box } from '../skeleton/skeleton.ts';
import { bindField } from './bind.ts';
import { grown } from './boxes.ts';
import { BrickMesh, type FieldMesh } from './brickMesh.ts';
import type { Brick, Bricks } from './bricks.ts';
import { BrickValues } from './brickValues.ts';
import { fitting } from './fitBox.ts';
import { type Lattice, latticeAround, latticeOver } from './lattice.ts';
import { LiveBricks } from './liveBricks.ts';
import { type Near, Tally } from './near.ts';
import type { FieldNode } from './node.ts';
import { PAGE } from './polygonize.ts';
import { treeChanges } from './treeChanges.ts';

export interface LiveMade {
  readonly mesh: FieldMesh;
  /** work of this edit (skeleton/work.ts) */
  readonly evaluations: number;
  readonly bricks: Bricks;
  /** of the active bricks, those that were evaluated */
  readonly renewed: number;
}

interface State {
  readonly node: FieldNode;
  readonly live: LiveBricks;
  readonly places: ReadonlyMap<number, number>;
  readonly values: BrickValues;
  readonly mesh: BrickMesh;
  /** skels in all */
  readonly asked: number;
}

/** of the longest side, on all sides: room for what a drag adds */
const ROOM = 0.1;
/** of all skels: with more of them changed most of the body is made again anyway */
const EDIT = 0.3;
/** bricks between two looks at the clock */
const BATCH = 16;

export class LiveMesh {
  readonly #resolution: number;
  readonly #tally = new Tally();
  #state: State | null = null;

  /** Cells along the longest side of the body as it is first. */
  constructor(resolution: number) {
    this.#resolution = resolution;
  }

  /** Runs to the end; see `making`. */
  make(node: FieldNode): LiveMade {
    return ended(this.making(node));
  }

  /** Whether `node` differs from the body before in some of its leaves or terms only, so that an edit is worth it. */
  isEdit(node: FieldNode): boolean {
    const changes = this.#state && treeChanges(this.#state.node, node);
    if (!changes || !this.#state) return false;
    const parts = [...changes.values()].map((change) =>
      change ? Math.max(change.removed.length, change.added.length) : 1,
    );
    return parts.reduce((sum, count) => sum + count, 0) <= EDIT * this.#state.asked;
  }

  /** Given up half-way it begins anew the next time. FieldError for what has no field. */
  *making(node: FieldNode): Generator<number, LiveMade> {
    const field = bindField(node);
    const tally = this.#tally;
    tally.work = 0;
    const before = this.#state;
    const changes = before && this.isEdit(node) ? treeChanges(before.node, node) : null;
    this.#state = null;
    if (before && changes) {
      const whole = this.#whole(field);
      before.live.edit(whole, changes);
      const made = yield* this.#meshing(node, whole, before.live, before);
      // what has no end leaves every lattice
      if (!made.leaves || !field.box) return made.made;
    }
    const whole = this.#whole(field);
    // a body that has left its lattice is being dragged
    const room = before && changes ? ROOM : 0;
    const lattice = yield* roomyLattice(whole, this.#resolution, field.box, room);
    const live = yield* LiveBricks.making(whole, lattice);
    return (yield* this.#meshing(node, whole, live, null)).made;
  }

  /** Leaves and branches are numbered again. */
  #whole(field: ReturnType<typeof bindField>): Near {
    this.#tally.leaves = 0;
    this.#tally.branches = 0;
    return field.near(this.#tally);
  }

  *#meshing(node: FieldNode, whole: Near, live: LiveBricks, before: State | null) {
    const bricks = live.bricks();
    const placeOf = (place: number) => keptPlace(live, bricks, before, place);
    const kept = before && { values: before.values, placeOf };
    const values = new BrickValues(whole, bricks, this.#tally, kept, true);
    const mesh = new BrickMesh(bricks, values, this.#tally, before?.mesh);
    for (const [place, brick] of bricks.active.entries()) {
      mesh.add(brick, values.fill(place), placeOf(place) >= 0);
      if (place % BATCH === 0) yield place / bricks.active.length;
    }
    const places = new Map(bricks.active.map((brick, place) => [live.number(brick), place]));
    const made: LiveMade = {
      mesh: mesh.mesh(),
      evaluations: this.#tally.work,
      bricks,
      renewed: bricks.active.filter((brick) => live.renewed.has(live.number(brick))).length,
    };
    values.forget();
    this.#state = { node, live, places, values, mesh, asked: whole.asked };
    return { made, leaves: values.leaves.includes(true) };
  }
}

/** −1 where the brick was made anew. */
function keptPlace(live: LiveBricks, { active }: Bricks, before: State | null, place: number): number {
  const number = live.number(active[place] as Brick);
  return before && !live.renewed.has(number) ? (before.places.get(number) ?? -1) : -1;
}

function* roomyLattice(
  whole: Near,
  resolution: number,
  box: Box | null,
  share: number,
): Generator<number, Lattice> {
  if (!box) return latticeOver(PAGE, resolution);
  const { min, max } = (yield* fitting(whole, box)) ?? box;
  const room = share * Math.max(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  return latticeAround(grown({ min, max }, room), Math.round(resolution * (1 + 2 * share)));
}

function ended<T>(steps: Generator<number, T>): T {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}
