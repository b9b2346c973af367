/**
 * The mesh of a body that is being edited: of what it was made of before everything is kept that a change does not reach, cubes of the
 * octree (liveBricks.ts), values, vertices. The lattice grows with the body, so that its cells stay what they are. Made anew are trees that are
 * built otherwise than before (treeChanges.ts), bodies of which much has changed and those that have grown by half.
 */
import type { Box } from '../skeleton/skeleton.ts';
import { bindField } from './bind.ts';
import { unite } from './boxes.ts';
import { BrickMesh, type FieldMesh } from './brickMesh.ts';
import type { Brick, Bricks } from './bricks.ts';
import { BrickValues } from './brickValues.ts';
import { fitting, grownWhere } from './fitBox.ts';
import { growth } from './growth.ts';
import { type Grown, type Lattice, latticeGrown } from './lattice.ts';
import { LiveBricks } from './liveBricks.ts';
import { type Near, Tally } from './near.ts';
import type { FieldNode } from './node.ts';
import { type Numbered, numbered, numbersIn, Supply } from './numbered.ts';
import { fittedLattice, ROUNDS } from './polygonize.ts';
import { shared } from './shared.ts';
import { type TreeChanges, treeChanges } from './treeChanges.ts';
import type { TreeField } from './treeField.ts';

export interface LiveMade {
  readonly mesh: FieldMesh;
  /** by the lattice: what has no end */
  readonly isCut: boolean;
  /** something was kept: to the bit it is what is made at once only where this is false */
  readonly isEdit: boolean;
  /** work of this edit (skeleton/work.ts) */
  readonly evaluations: number;
  readonly bricks: Bricks;
  /** of the active bricks, those that were evaluated */
  readonly renewed: number;
}

interface State {
  readonly tree: Numbered;
  /** the numbers that come next */
  readonly next: Supply;
  readonly live: LiveBricks;
  readonly lattice: Lattice;
  readonly places: ReadonlyMap<number, number>;
  readonly values: BrickValues;
  readonly mesh: BrickMesh;
  readonly hasEnd: boolean;
}

/** What is asked for, of objects of what there was. */
interface Wish {
  readonly asked: FieldNode;
  readonly node: FieldNode;
  /** null: it is to be made anew */
  readonly changes: TreeChanges | null;
}

/** as many cells along the longest side as were asked for first: bodies that grow are made anew in larger cells then */
const GROWN = 1.5;
/** bricks between two looks at the clock */
const BATCH = 16;

export class LiveMesh {
  readonly #resolution: number;
  readonly #tally = new Tally();
  #state: State | null = null;
  /** that was asked about last */
  #wish: Wish | null = null;

  /** Cells along the longest side of the body as it is first. */
  constructor(resolution: number) {
    this.#resolution = resolution;
  }

  /** Active bricks that are kept, which most of its memory is for. */
  get size(): number {
    return this.#state?.places.size ?? 0;
  }

  /** Runs to the end; see `making`. */
  make(node: FieldNode): LiveMade {
    return ended(this.making(node));
  }

  /** Whether `node` differs from the body before in some of its leaves or terms only, so that an edit is worth it. */
  isEdit(node: FieldNode): boolean {
    return this.#wishFor(node).changes !== null;
  }

  /** Given up half-way it begins anew the next time. FieldError for what has no field: what there is stays. */
  *making(node: FieldNode): Generator<number, LiveMade> {
    const { node: own, changes } = this.#wishFor(node);
    const field = bindField(own);
    const before = this.#state;
    this.#wish = null;
    this.#state = null;
    this.#tally.work = 0;
    const edit = before && changes && (yield* this.#edited(before, changes, field));
    return edit ?? (yield* this.#anew(own, field));
  }

  #wishFor(node: FieldNode): Wish {
    if (this.#wish?.asked === node) return this.#wish;
    const before = this.#state;
    const own = before ? shared(before.tree.node, node) : node;
    const found = before && treeChanges(before.tree, own, before.next);
    const changes = found?.isWorthIt ? found : null;
    this.#wish = { asked: node, node: own, changes };
    return this.#wish;
  }

  /** Null where it is to be made anew. */
  *#edited(before: State, changes: TreeChanges, field: TreeField): Generator<number, LiveMade | null> {
    const hasEnd = field.box !== null;
    if (hasEnd !== before.hasEnd) return null;
    const grown = hasEnd ? yield* this.#grown(before, changes) : null;
    const lattice = grown?.lattice ?? before.lattice;
    if (Math.max(...lattice.counts) > GROWN * this.#resolution && grown) return null;
    const whole = this.#whole(field, changes.tree);
    yield* before.live.edit(whole, changes.nodes, grown);
    const state = { ...before, tree: changes.tree, lattice };
    const made = yield* this.#meshing(state, whole, before);
    return hasEnd && made.isCut ? null : made;
  }

  /** The lattice, if the body leaves it by what came. */
  *#grown({ lattice, tree }: State, changes: TreeChanges): Generator<number, Grown | null> {
    if (changes.reach) return latticeGrown(lattice, changes.reach);
    let box: Box | null = null;
    for (const part of growth(tree, changes.tree, changes.nodes)) {
      const field = bindField(part);
      const own = field.box && (yield* fitting(field.near(this.#tally), field.box));
      if (own) box = unite(box ?? own, own);
    }
    return box && latticeGrown(lattice, box);
  }

  *#anew(node: FieldNode, field: TreeField): Generator<number, LiveMade> {
    const next = new Supply();
    const tree = numbered(node, next);
    const whole = this.#whole(field, tree);
    let within = field.box;
    for (let round = 0; ; round++) {
      const { lattice } = yield* fittedLattice(whole, within, this.#resolution);
      const live = yield* LiveBricks.making(whole, lattice);
      const state = { tree, next, live, lattice, hasEnd: field.box !== null };
      const made = yield* this.#meshing(state, whole, null);
      const larger = within && round < ROUNDS ? grownWhere(within, this.#state!.values.leaves) : null;
      if (!larger) return made;
      within = larger;
    }
  }

  #whole(field: TreeField, tree: Numbered): Near {
    this.#tally.leaves = 0;
    this.#tally.sets = 0;
    this.#tally.numbers = numbersIn(tree);
    return field.near(this.#tally);
  }

  *#meshing(
    state: Omit<State, 'places' | 'values' | 'mesh'>,
    whole: Near,
    before: State | null,
  ): Generator<number, LiveMade> {
    const { live } = state;
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
    this.#state = { ...state, places, values, mesh };
    return {
      mesh: mesh.mesh(),
      isCut: values.leaves.includes(true),
      isEdit: before !== null,
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

function ended<T>(steps: Generator<number, T>): T {
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}
