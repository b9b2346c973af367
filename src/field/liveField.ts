/**
 * The bricks of a body that is being edited: of what there was before everything is kept that a change does not reach (liveBricks.ts). The lattice
 * grows with the body, so that its cells stay what they are. Located anew are trees that are built otherwise than before (treeChanges.ts), bodies of
 * which much has changed and those that have grown by half.
 */
import type { Box } from '../skeleton/skeleton.ts';
import { bindField } from './bind.ts';
import { unite } from './boxes.ts';
import type { Bricks } from './bricks.ts';
import { fitting } from './fitBox.ts';
import { growth } from './growth.ts';
import { type Grown, type Lattice, latticeGrown } from './lattice.ts';
import { LiveBricks } from './liveBricks.ts';
import { type Near, Tally } from './near.ts';
import type { FieldNode } from './node.ts';
import { type Numbered, numbered, numbersIn, Supply } from './numbered.ts';
import { fittedLattice } from './polygonize.ts';
import { shared } from './shared.ts';
import { type TreeChanges, treeChanges } from './treeChanges.ts';
import type { TreeField } from './treeField.ts';

export interface LiveStep {
  readonly whole: Near;
  readonly tally: Tally;
  readonly bricks: Bricks;
  /** around all that is inside of them, nearly */
  readonly box: Box | null;
  /** a number of each active brick that it keeps when the lattice grows */
  readonly numbers: readonly number[];
  /** those that were made anew */
  readonly renewed: ReadonlySet<number>;
  /** others were kept */
  readonly isEdit: boolean;
  /** the lattice is a larger one */
  readonly isGrown: boolean;
}

interface State {
  readonly tree: Numbered;
  /** the numbers that come next */
  readonly next: Supply;
  readonly live: LiveBricks;
  readonly lattice: Lattice;
  /** of the tree; null: it has no end */
  readonly box: Box | null;
}

/** What is asked for, of objects of what there was. */
interface Wish {
  readonly asked: FieldNode;
  readonly node: FieldNode;
  /** null: it is to be made anew */
  readonly changes: TreeChanges | null;
}

/** as many cells along the longest side as were asked for first: bodies that grow are located anew in larger cells then */
const GROWN = 1.5;

export class LiveField {
  readonly #resolution: number;
  readonly #isInPlace: boolean;
  readonly #tally = new Tally();
  #state: State | null = null;
  /** that was asked about last */
  #wish: Wish | null = null;

  /**
   * Cells along the longest side of the body as it is first. `isInPlace`: edits leave all leaves and terms in their places, so that lists of
   * bricks, which name them by these, hold; others are located anew.
   */
  constructor(resolution: number, isInPlace = false) {
    this.#resolution = resolution;
    this.#isInPlace = isInPlace;
  }

  /** Whether `node` differs from the body before in some of its parts or terms only, so that an edit is worth it. */
  isEdit(node: FieldNode): boolean {
    return this.#wishFor(node).changes !== null;
  }

  /** Given up half-way it begins anew the next time. FieldError for what has no field: what there is stays. */
  *locating(node: FieldNode): Generator<number, LiveStep> {
    const { node: own, changes } = this.#wishFor(node);
    const field = bindField(own);
    const before = this.#begin();
    const edit = before && changes && (yield* this.#edited(before, changes, field));
    return edit ?? (yield* this.#anew(own, field, field.box));
  }

  /** Of nothing that was there before. `within`: holds the body, as far as it is to be seen; without it the body's own box. */
  *locatingAnew(node: FieldNode, within: Box | null = null): Generator<number, LiveStep> {
    const field = bindField(node);
    this.#begin();
    return yield* this.#anew(node, field, within ?? field.box);
  }

  #begin(): State | null {
    const before = this.#state;
    this.#wish = null;
    this.#state = null;
    this.#tally.work = 0;
    return before;
  }

  #wishFor(node: FieldNode): Wish {
    if (this.#wish?.asked === node) return this.#wish;
    const before = this.#state;
    const own = before ? shared(before.tree.node, node) : node;
    const found = before && treeChanges(before.tree, own, before.next);
    const isTaken = found?.isWorthIt && (found.isInPlace || !this.#isInPlace);
    this.#wish = { asked: node, node: own, changes: isTaken ? found : null };
    return this.#wish;
  }

  /** Null where it is to be made anew. */
  *#edited(before: State, changes: TreeChanges, field: TreeField): Generator<number, LiveStep | null> {
    const { box } = field;
    if ((box === null) !== (before.box === null)) return null;
    const whole = this.#whole(field, changes.tree);
    const grown = box && (yield* this.#grown(before, changes, whole));
    const lattice = grown?.lattice ?? before.lattice;
    if (grown && Math.max(...lattice.counts) > GROWN * this.#resolution) return null;
    yield* before.live.edit(whole, changes.nodes, grown);
    return this.#step({ ...before, tree: changes.tree, lattice, box }, whole, true, grown !== null);
  }

  /** The lattice, if the body leaves it by what came. */
  *#grown({ lattice, tree }: State, changes: TreeChanges, whole: Near): Generator<number, Grown | null> {
    const { reach } = changes;
    if (reach) {
      // it holds more than the body does
      const fitted = latticeGrown(lattice, reach) && (yield* fitting(whole, reach));
      return fitted && roomier(lattice, fitted);
    }
    let box: Box | null = null;
    for (const part of growth(tree, changes.tree, changes.nodes)) {
      const field = bindField(part);
      if (!field.box || !latticeGrown(lattice, field.box)) continue;
      const own = yield* fitting(field.near(this.#tally), field.box);
      if (own) box = unite(box ?? own, own);
    }
    return box && roomier(lattice, box);
  }

  *#anew(node: FieldNode, field: TreeField, within: Box | null): Generator<number, LiveStep> {
    const next = new Supply();
    const tree = numbered(node, next);
    const whole = this.#whole(field, tree);
    const { lattice } = yield* fittedLattice(whole, within, this.#resolution);
    const live = yield* LiveBricks.making(whole, lattice);
    return this.#step({ tree, next, live, lattice, box: field.box }, whole, false, false);
  }

  #whole(field: TreeField, tree: Numbered): Near {
    this.#tally.leaves = 0;
    this.#tally.sets = 0;
    this.#tally.numbers = numbersIn(tree);
    return field.near(this.#tally);
  }

  #step(state: State, whole: Near, isEdit: boolean, isGrown: boolean): LiveStep {
    this.#state = state;
    const { live, box } = state;
    const bricks = live.bricks();
    const numbers = bricks.active.map((brick) => live.number(brick));
    return { whole, tally: this.#tally, bricks, box, numbers, renewed: live.renewed, isEdit, isGrown };
  }
}

/** of the longest side: what leaves a lattice is likely to go on the same way */
const ROOM = 0.05;

/** Null where the lattice holds the box; otherwise one that holds more than that. */
function roomier(lattice: Lattice, box: Box): Grown | null {
  if (!latticeGrown(lattice, box)) return null;
  const { min, max } = box;
  const room = ROOM * lattice.step * Math.max(...lattice.counts);
  const wide = (low: number, high: number, axis: 0 | 1 | 2) => {
    const end = lattice.origin[axis] + lattice.step * (lattice.counts[axis] - 1);
    return [low < lattice.origin[axis] ? low - room : low, high > end ? high + room : high] as const;
  };
  const [x, y, z] = [wide(min[0], max[0], 0), wide(min[1], max[1], 1), wide(min[2], max[2], 2)];
  return latticeGrown(lattice, { min: [x[0], y[0], z[0]], max: [x[1], y[1], z[1]] });
}
