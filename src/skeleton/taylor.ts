/**
 * Taylor polynomials of the second degree in three variables: what stands for skels from afar. Ten coefficients about a centre:
 * 1, x, y, z, x², y², z², xy, yz, zx.
 *
 * Theory: k(c + v) = k + k′ (2 D·v + v²) + ½ k″ (2 D·v)² with k′ and k″ the derivatives in r², D = c − q.
 */

export type Taylor = Float64Array;

export const TAYLOR = 10;

/** Adds a point source's: its kernel's value and derivatives in r², and the vector from it to the centre, in one unit of length. */
export function addSource(
  out: Taylor,
  value: number,
  first: number,
  second: number,
  x: number,
  y: number,
  z: number,
): void {
  out[0] = out[0]! + value;
  out[1] = out[1]! + 2 * first * x;
  out[2] = out[2]! + 2 * first * y;
  out[3] = out[3]! + 2 * first * z;
  out[4] = out[4]! + first + 2 * second * x * x;
  out[5] = out[5]! + first + 2 * second * y * y;
  out[6] = out[6]! + first + 2 * second * z * z;
  out[7] = out[7]! + 4 * second * x * y;
  out[8] = out[8]! + 4 * second * y * z;
  out[9] = out[9]! + 4 * second * z * x;
}

/** At (x, y, z) from the centre. */
export function taylorAt(c: Taylor, x: number, y: number, z: number): number {
  return (
    c[0]! +
    x * (c[1]! + c[4]! * x + c[7]! * y) +
    y * (c[2]! + c[5]! * y + c[8]! * z) +
    z * (c[3]! + c[6]! * z + c[9]! * x)
  );
}

/** Writes value and gradient at (x, y, z) from the centre. */
export function evaluateTaylor(c: Taylor, x: number, y: number, z: number, out: Float64Array): void {
  out[0] = taylorAt(c, x, y, z);
  out[1] = c[1]! + 2 * c[4]! * x + c[7]! * y + c[9]! * z;
  out[2] = c[2]! + 2 * c[5]! * y + c[7]! * x + c[8]! * z;
  out[3] = c[3]! + 2 * c[6]! * z + c[8]! * y + c[9]! * x;
}

/** Writes the same polynomial about a centre that is (x, y, z) away. */
export function shiftTaylor(c: Taylor, x: number, y: number, z: number, out: Taylor): void {
  evaluateTaylor(c, x, y, z, out);
  for (let i = 4; i < TAYLOR; i++) out[i] = c[i]!;
}

/** Adds `local` of l(v) = rows · v: of a linear map of the variables, its rows one after the other. */
export function addMapped(local: Taylor, rows: ArrayLike<number>, out: Taylor): void {
  const [g, h] = [local.subarray(1, 4), hessian(local)];
  out[0] = out[0]! + local[0]!;
  for (let i = 0; i < 3; i++) {
    out[1 + i] = out[1 + i]! + rows[i]! * g[0]! + rows[3 + i]! * g[1]! + rows[6 + i]! * g[2]!;
  }
  const bent = (i: number, j: number) => {
    let sum = 0;
    for (let k = 0; k < 3; k++)
      for (let l = 0; l < 3; l++) sum += rows[3 * k + i]! * h[3 * k + l]! * rows[3 * l + j]!;
    return sum;
  };
  for (let i = 0; i < 3; i++) {
    out[4 + i] = out[4 + i]! + 0.5 * bent(i, i);
    out[7 + i] = out[7 + i]! + bent(i, (i + 1) % 3);
  }
}

function hessian(c: Taylor): readonly number[] {
  const [xx, yy, zz, xy, yz, zx] = [2 * c[4]!, 2 * c[5]!, 2 * c[6]!, c[7]!, c[8]!, c[9]!];
  return [xx, xy, zx, xy, yy, yz, zx, yz, zz];
}
