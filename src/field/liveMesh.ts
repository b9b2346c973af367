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
import { fitting, isWithin } from './fitBox.ts';
import { type Lattice, latticeAround, latticeOver } from './lattice.ts';
import { LiveBricks } from './liveBricks.ts';
import { type Near, Tally } from './near.ts';
import type { FieldNode } from './node.ts';
import { PAGE } from './polygonize.ts';
import { type TreeChanges, treeChanges } from './treeChanges.ts';

export interface LiveMade {
  readonly mesh: FieldMesh;
  /** by the lattice: what has no end */
  readonly isCut: boolean;
  /** work of this edit (skeleton/work.ts) */
  readonly evaluations: number;
  readonly bricks: Bricks;
  /** of the active bricks, those that were evaluated */
  readonly renewed: number;
}

interface State {
  readonly node: FieldNode;
  readonly live: LiveBricks;
  readonly lattice: Lattice;
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
    return this.#changesTo(node) !== null;
  }

  #changesTo(node: FieldNode): TreeChanges | null {
    const found = this.#state && treeChanges(this.#state.node, node);
    return found && found.touched <= EDIT * this.#state!.asked ? found : null;
  }

  /** Given up half-way it begins anew the next time. FieldError for what has no field. */
  *making(node: FieldNode): Generator<number, LiveMade> {
    const field = bindField(node);
    this.#tally.work = 0;
    const before = this.#state;
    const changes = this.#changesTo(node);
    this.#state = null;
    const isStaying = before !== null && changes !== null && !this.#exits(before, changes, node);
    const whole = this.#whole(field);
    if (isStaying) {
      yield* before.live.edit(whole, changes.leaves);
      const edit = yield* this.#meshing(node, whole, before.live, before.lattice, before);
      if (!edit.isCut || !field.box) return edit;
    }
    const box = field.box && ((yield* fitting(whole, field.box)) ?? field.box);
    // a body that has left its lattice is being dragged
    const lattice = roomyLattice(this.#resolution, box, before && changes ? ROOM : 0);
    const live = yield* LiveBricks.making(whole, lattice);
    return yield* this.#meshing(node, whole, live, lattice, null);
  }

  /** Whether the body leaves its lattice by what came. What has no end leaves every lattice. */
  #exits({ lattice, node: before }: State, { reach }: TreeChanges, after: FieldNode): boolean {
    const { origin, step, counts } = lattice;
    const end = (axis: 0 | 1 | 2) => origin[axis] + (counts[axis] - 1) * step;
    const limits: Box = { min: origin, max: [end(0), end(1), end(2)] };
    if (reach?.min.every((low, axis) => low > limits.min[axis]! && reach.max[axis]! < limits.max[axis]!)) {
      return false;
    }
    return changed(before, after).some((part) => {
      const field = bindField(part);
      return field.box !== null && !isWithin(field.near(this.#tally), field.box, limits, step);
    });
  }

  /** Leaves and branches are numbered again. */
  #whole(field: ReturnType<typeof bindField>): Near {
    this.#tally.leaves = 0;
    this.#tally.branches = 0;
    return field.near(this.#tally);
  }

  *#meshing(
    node: FieldNode,
    whole: Near,
    live: LiveBricks,
    lattice: Lattice,
    before: State | null,
  ): Generator<number, LiveMade> {
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
    values.forget();
    this.#state = { node, live, lattice, places, values, mesh, asked: whole.asked };
    return {
      mesh: mesh.mesh(),
      isCut: values.exits.includes(true),
      evaluations: this.#tally.work,
      bricks,
      renewed: bricks.active.filter((brick) => live.renewed.has(live.number(brick))).length,
    };
  }
}

/** −1 where the brick was made anew. */
function keptPlace(live: LiveBricks, { active }: Bricks, before: State | null, place: number): number {
  const number = live.number(active[place] as Brick);
  return before && !live.renewed.has(number) ? (before.places.get(number) ?? -1) : -1;
}

/** Of a union the parts that changed: the others are where they were. */
function changed(before: FieldNode, after: FieldNode): readonly FieldNode[] {
  if (before.type !== 'union' || after.type !== 'union') return [after];
  return after.parts.filter((part, i) => JSON.stringify(part) !== JSON.stringify(before.parts[i]));
}

function roomyLattice(resolution: number, box: Box | null, share: number): Lattice {
  if (!box) return latticeOver(PAGE, resolution);
  const { min, max } = box;
  const room = share * Math.max(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  return latticeAround(grown({ min, max }, room), Math.round(resolution * (1 + 2 * share)));
}

function ended<T>(steps: Generator<number, T>): T {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}
