/** A field of one colour, and a field that a matrix has moved. */
import type { Field } from '../shape/shape.ts';
import type { Box, FieldValue } from '../skeleton/skeleton.ts';
import { type Affine, IDENTITY, inverted, mappedBox, stretches } from './affine.ts';
import type { Colour } from './node.ts';
import type { TreeField } from './treeField.ts';

export function coloured(field: Field, colour: Colour): TreeField {
  return {
    value: (x, y, z) => field.value(x, y, z),
    evaluate(x, y, z, out) {
      field.evaluate(x, y, z, out);
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
export function moved(field: TreeField, matrix: Affine, isDistance: boolean): TreeField {
  const back = inverted(matrix);
  const unmoved = matrix.every((entry, i) => entry === IDENTITY[i]);
  return unmoved ? field : new Moved(field, matrix, back, isDistance ? stretches(matrix).least : 1);
}

class Moved implements TreeField {
  readonly #field: TreeField;
  readonly #matrix: Affine;
  readonly #back: Affine;
  readonly #scale: number;
  readonly box: Box | null;

  constructor(field: TreeField, matrix: Affine, back: Affine, scale: number) {
    this.#field = field;
    this.#matrix = matrix;
    this.#back = back;
    this.#scale = scale;
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

  boxAbove(level: number): Box | null {
    const box = this.#field.boxAbove(level / this.#scale);
    return box && mappedBox(this.#matrix, box);
  }
}
