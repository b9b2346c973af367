/**
 * The mesh of a body that is being edited: bricks (liveField.ts), values and vertices are kept where a change does not reach them.
 */
import { finished } from '../math/finished.ts';
import { BrickMesh, type FieldMesh } from './brickMesh.ts';
import type { Bricks } from './bricks.ts';
import { BrickValues } from './brickValues.ts';
import { grownWhere } from './fitBox.ts';
import { LiveField, type LiveStep } from './liveField.ts';
import type { FieldNode } from './node.ts';
import { ROUNDS } from './polygonize.ts';

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
  readonly places: ReadonlyMap<number, number>;
  readonly values: BrickValues;
  readonly mesh: BrickMesh;
}

/** bricks between two looks at the clock */
const BATCH = 16;

export class LiveMesh {
  readonly #field: LiveField;
  #state: State | null = null;

  /** Cells along the longest side of the body as it is first. */
  constructor(resolution: number) {
    this.#field = new LiveField(resolution);
  }

  /** Active bricks that are kept, which most of its memory is for. */
  get size(): number {
    return this.#state?.places.size ?? 0;
  }

  /** Runs to the end; see `making`. */
  make(node: FieldNode): LiveMade {
    return finished(this.making(node));
  }

  /** Whether `node` differs from the body before in some of its parts or terms only, so that an edit is worth it. */
  isEdit(node: FieldNode): boolean {
    return this.#state !== null && this.#field.isEdit(node);
  }

  /** Given up half-way it begins anew the next time. FieldError for what has no field: what there is stays. */
  *making(node: FieldNode): Generator<number, LiveMade> {
    let step = yield* this.#field.locating(node);
    let within = step.box;
    let before = 0;
    for (let round = 0; ; round++) {
      const made = yield* this.#meshing(step);
      const evaluations = before + made.evaluations;
      if (!made.isCut || !within || round === ROUNDS) return { ...made, evaluations };
      before = evaluations;
      // a body that leaves what was kept, or what was thought to hold it
      if (!step.isEdit) within = grownWhere(within, this.#state!.values.exits) ?? within;
      step = yield* this.#field.locatingAnew(node, within);
    }
  }

  *#meshing({ whole, tally, bricks, numbers, renewed, isEdit }: LiveStep): Generator<number, LiveMade> {
    const before = isEdit ? this.#state : null;
    this.#state = null;
    const placeOf = (place: number) => {
      const number = numbers[place]!;
      return before && !renewed.has(number) ? (before.places.get(number) ?? -1) : -1;
    };
    const kept = before && { values: before.values, placeOf };
    const values = new BrickValues(whole, bricks, tally, kept, true);
    const mesh = new BrickMesh(bricks, values, tally, before?.mesh);
    for (const [place, brick] of bricks.active.entries()) {
      mesh.add(brick, values.fill(place), placeOf(place) >= 0);
      if (place % BATCH === 0) yield place / bricks.active.length;
    }
    values.forget();
    this.#state = { places: new Map(numbers.map((number, place) => [number, place])), values, mesh };
    return {
      mesh: mesh.mesh(),
      isCut: values.exits.includes(true),
      isEdit,
      evaluations: tally.work,
      bricks,
      renewed: numbers.filter((number) => renewed.has(number)).length,
    };
  }
}
