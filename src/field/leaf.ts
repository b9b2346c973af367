/** A field of one colour, and a field that a matrix has moved. */
import type { ShapeField } from '../shape/shape.ts';
import { type Box, type FieldValue, SPREAD } from '../skeleton/skeleton.ts';
import { type Affine, IDENTITY, inverted, mappedBox, stretches } from './affine.ts';
import { AROUND, closed, roundedHalf } from './closed.ts';
import { LeafFrame } from './leafFrame.ts';
import type { Near, Tally } from './near.ts';
import { nearShape } from './nearShape.ts';
import type { Colour } from './node.ts';
import type { LeafField, TreeField } from './treeField.ts';

export function coloured(field: ShapeField, colour: Colour): LeafField {
  const spread = new Float64Array(SPREAD);
  const facets = field.facets ?? null;
  const leaf: LeafField = {
    value: (x, y, z) => field.value(x, y, z),
    evaluate(x, y, z, out) {
      field.evaluate(x, y, z, out);
    },
    spread(x, y, z, radius, out) {
      field.spread(x, y, z, radius, out);
    },
    range(x, y, z, half, out) {
      const grown = roundedHalf(x, y, z, half);
      field.spread(x, y, z, AROUND * grown, spread);
      closed(spread, grown, out);
    },
    box: field.box,
    boxAbove: (level) => field.boxAbove(level),
    colour(x, y, z, out) {
      out[0] = colour[0];
      out[1] = colour[1];
      out[2] = colour[2];
      return field.value(x, y, z);
    },
    near: (tally) => nearShape(leaf, colour, facets, null, tally),
    nearIn: (frame, moved, tally) => nearShape(moved, colour, facets, frame, tally),
  };
  return leaf;
}

/** `field` under `matrix`; `isDistance`: its value grows with the least stretch. FieldError for a matrix that flattens. */
export function moved(field: LeafField, matrix: Affine, isDistance: boolean): TreeField {
  const back = inverted(matrix);
  const unmoved = matrix.every((entry, i) => entry === IDENTITY[i]);
  return unmoved ? field : new Moved(field, matrix, back, isDistance ? stretches(matrix).least : 1);
}

/** of values */
const ROUNDING = 4e-15;

const widened = (end: number, way: 1 | -1) => end + way * ROUNDING * Math.abs(end);

class Moved implements TreeField {
  readonly #field: LeafField;
  readonly #matrix: Affine;
  readonly #frame: LeafFrame;
  readonly #spread = new Float64Array(SPREAD);
  readonly box: Box | null;

  constructor(field: LeafField, matrix: Affine, back: Affine, scale: number) {
    this.#field = field;
    this.#matrix = matrix;
    this.#frame = new LeafFrame(back, scale);
    this.box = this.boxAbove(0);
  }

  value(x: number, y: number, z: number): number {
    const frame = this.#frame;
    frame.enter(x, y, z);
    return frame.scale * this.#field.value(frame.x, frame.y, frame.z);
  }

  evaluate(x: number, y: number, z: number, out: FieldValue): void {
    const frame = this.#frame;
    frame.enter(x, y, z);
    this.#field.evaluate(frame.x, frame.y, frame.z, out);
    frame.leave(out);
  }

  colour(x: number, y: number, z: number, out: Float64Array): number {
    const frame = this.#frame;
    frame.enter(x, y, z);
    return frame.scale * this.#field.colour(frame.x, frame.y, frame.z, out);
  }

  near(tally: Tally): Near {
    return this.#field.nearIn(this.#frame, this, tally);
  }

  range(x: number, y: number, z: number, half: number, out: Float64Array): void {
    const frame = this.#frame;
    const spread = this.#spread;
    // a mapped point is off by what rounding leaves of its coordinates
    const radius = AROUND * roundedHalf(x, y, z, half);
    const off = frame.off(x, y, z, radius);
    frame.enter(x, y, z);
    this.#field.spread(frame.x, frame.y, frame.z, frame.reach(radius) + off, spread);
    // those of the centre and of the points
    spread[4] = spread[4]! + 2 * off * (Math.abs(spread[1]!) + Math.abs(spread[2]!) + Math.abs(spread[3]!));
    frame.turn(spread);
    closed(spread, roundedHalf(x, y, z, half), out);
    out[0] = widened(frame.scale * out[0]!, -1);
    out[1] = widened(frame.scale * out[1]!, 1);
  }

  boxAbove(level: number): Box | null {
    const box = this.#field.boxAbove(level / this.#frame.scale);
    return box && mappedBox(this.#matrix, box);
  }
}
