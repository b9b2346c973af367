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
  /** bricks with surface in them, and those of them that were evaluated */
  readonly bricks: number;
  readonly renewed: number;
}

interface State {
  readonly node: FieldNode;
  readonly live: LiveBricks;
  readonly places: ReadonlyMap<number, number>;
  readonly values: BrickValues;
  readonly mesh: BrickMesh;
}

/** of the longest side, on all sides: room for what a drag adds */
const ROOM = 0.1;

export class LiveMesh {
  readonly #resolution: number;
  readonly #tally = new Tally();
  #state: State | null = null;

  /** Cells along the longest side of the body as it is first. */
  constructor(resolution: number) {
    this.#resolution = resolution;
  }

  /** FieldError for what has no field; the body before stays then. */
  make(node: FieldNode): LiveMade {
    const field = bindField(node);
    const tally = this.#tally;
    tally.work = 0;
    const before = this.#state;
    const changes = before && treeChanges(before.node, node);
    if (before && changes) {
      const whole = this.#whole(field);
      before.live.edit(whole, changes);
      const made = this.#meshed(node, whole, before.live, before);
      // what has no end leaves every lattice
      if (!made.leaves || !field.box) return made.made;
    }
    const whole = this.#whole(field);
    const live = new LiveBricks(whole, roomyLattice(whole, this.#resolution, field.box));
    return this.#meshed(node, whole, live, null).made;
  }

  /** Leaves and branches are numbered again. */
  #whole(field: ReturnType<typeof bindField>): Near {
    this.#tally.leaves = 0;
    this.#tally.branches = 0;
    return field.near(this.#tally);
  }

  #meshed(node: FieldNode, whole: Near, live: LiveBricks, before: State | null) {
    const bricks = live.bricks();
    const placeOf = (place: number) => keptPlace(live, bricks, before, place);
    const kept = before && { values: before.values, placeOf };
    const values = new BrickValues(whole, bricks, this.#tally, kept, true);
    const mesh = new BrickMesh(bricks, values, this.#tally, before?.mesh);
    for (const [place, brick] of bricks.active.entries()) {
      mesh.add(brick, values.fill(place), placeOf(place) >= 0);
    }
    const places = new Map(bricks.active.map((brick, place) => [live.number(brick), place]));
    this.#state = { node, live, places, values, mesh };
    const made: LiveMade = {
      mesh: mesh.mesh(),
      evaluations: this.#tally.work,
      bricks: bricks.active.length,
      renewed: bricks.active.filter((brick) => live.renewed.has(live.number(brick))).length,
    };
    values.forget();
    return { made, leaves: values.leaves.includes(true) };
  }
}

/** −1 where the brick was made anew. */
function keptPlace(live: LiveBricks, { active }: Bricks, before: State | null, place: number): number {
  const number = live.number(active[place] as Brick);
  return before && !live.renewed.has(number) ? (before.places.get(number) ?? -1) : -1;
}

function roomyLattice(whole: Near, resolution: number, box: Box | null): Lattice {
  if (!box) return latticeOver(PAGE, resolution);
  const steps = fitting(whole, box);
  let step = steps.next();
  while (!step.done) step = steps.next();
  const { min, max } = step.value ?? box;
  const room = ROOM * Math.max(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  return latticeAround(grown({ min, max }, room), Math.round(resolution * (1 + 2 * ROOM)));
}
