/** A field of one colour, and a field that a matrix has moved. */
import type { ShapeField } from '../shape/shape.ts';
import { type Box, type FieldValue, SPREAD } from '../skeleton/skeleton.ts';
import { type Affine, IDENTITY, inverted, mappedBox, stretches } from './affine.ts';
import { AROUND, closed, roundedHalf } from './closed.ts';
import type { Colour } from './node.ts';
import type { LeafField, TreeField } from './treeField.ts';

export function coloured(field: ShapeField, colour: Colour): LeafField {
  const spread = new Float64Array(SPREAD);
  return {
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
  };
}

/** `field` under `matrix`; `isDistance`: its value grows with the least stretch. FieldError for a matrix that flattens. */
export function moved(field: LeafField, matrix: Affine, isDistance: boolean): TreeField {
  const back = inverted(matrix);
  const unmoved = matrix.every((entry, i) => entry === IDENTITY[i]);
  return unmoved ? field : new Moved(field, matrix, back, isDistance ? stretches(matrix).least : 1);
}

/** of coordinates, and of values */
const ROUNDING = 4e-15;

const widened = (end: number, way: 1 | -1) => end + way * ROUNDING * Math.abs(end);

class Moved implements TreeField {
  readonly #field: LeafField;
  readonly #matrix: Affine;
  readonly #back: Affine;
  readonly #scale: number;
  /** of lengths, the largest */
  readonly #stretch: number;
  readonly #size: number;
  readonly #spread = new Float64Array(SPREAD);
  readonly box: Box | null;

  constructor(field: LeafField, matrix: Affine, back: Affine, scale: number) {
    this.#field = field;
    this.#matrix = matrix;
    this.#back = back;
    this.#scale = scale;
    this.#stretch = stretches(back).most;
    this.#size = Math.abs(back[3]) + Math.abs(back[7]) + Math.abs(back[11]);
    this.box = this.boxAbove(0);
  }

  value(x: number, y: number, z: number): number {
    const m = this.#back;
    return (
      this.#scale *
      this.#field.value(
        m[0] * x + m[1] * y + m[2] * z + m[3],
        m[4] * x + m[5] * y + m[6] * z + m[7],
        m[8] * x + m[9] * y + m[10] * z + m[11],
      )
    );
  }

  evaluate(x: number, y: number, z: number, out: FieldValue): void {
    const m = this.#back;
    this.#field.evaluate(
      m[0] * x + m[1] * y + m[2] * z + m[3],
      m[4] * x + m[5] * y + m[6] * z + m[7],
      m[8] * x + m[9] * y + m[10] * z + m[11],
      out,
    );
    const k = this.#scale;
    const gx = k * out[1]!;
    const gy = k * out[2]!;
    const gz = k * out[3]!;
    out[0]! *= k;
    out[1] = m[0] * gx + m[4] * gy + m[8] * gz;
    out[2] = m[1] * gx + m[5] * gy + m[9] * gz;
    out[3] = m[2] * gx + m[6] * gy + m[10] * gz;
  }

  colour(x: number, y: number, z: number, out: Float64Array): number {
    const m = this.#back;
    return (
      this.#scale *
      this.#field.colour(
        m[0] * x + m[1] * y + m[2] * z + m[3],
        m[4] * x + m[5] * y + m[6] * z + m[7],
        m[8] * x + m[9] * y + m[10] * z + m[11],
        out,
      )
    );
  }

  range(x: number, y: number, z: number, half: number, out: Float64Array): void {
    const m = this.#back;
    const spread = this.#spread;
    // a mapped point is off by what rounding leaves of its coordinates
    const radius = AROUND * roundedHalf(x, y, z, half);
    const off = ROUNDING * (this.#stretch * (Math.abs(x) + Math.abs(y) + Math.abs(z) + radius) + this.#size);
    this.#field.spread(
      m[0] * x + m[1] * y + m[2] * z + m[3],
      m[4] * x + m[5] * y + m[6] * z + m[7],
      m[8] * x + m[9] * y + m[10] * z + m[11],
      radius * this.#stretch + off,
      spread,
    );
    const gx = spread[1]!;
    const gy = spread[2]!;
    const gz = spread[3]!;
    // those of the centre and of the points
    spread[4] = spread[4]! + 2 * off * (Math.abs(gx) + Math.abs(gy) + Math.abs(gz));
    spread[1] = m[0] * gx + m[4] * gy + m[8] * gz;
    spread[2] = m[1] * gx + m[5] * gy + m[9] * gz;
    spread[3] = m[2] * gx + m[6] * gy + m[10] * gz;
    closed(spread, roundedHalf(x, y, z, half), out);
    out[0] = widened(this.#scale * out[0]!, -1);
    out[1] = widened(this.#scale * out[1]!, 1);
  }

  boxAbove(level: number): Box | null {
    const box = this.#field.boxAbove(level / this.#scale);
    return box && mappedBox(this.#matrix, box);
  }
}
