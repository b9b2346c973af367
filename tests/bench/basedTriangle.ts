/** A triangle on its longest side, kernel units: the frame of double integrals, which go along that side first. */
import type { Vec2 } from '../../src/math/vec.ts';

export type Triangle = readonly [Vec2, Vec2, Vec2];

export interface BasedTriangle {
  /** kernel units of a millimetre */
  readonly per: number;
  /** an end of the longest side, and its direction */
  readonly ax: number;
  readonly ay: number;
  readonly ux: number;
  readonly uy: number;
  readonly base: number;
  /** where the corner opposite lies: along the side, across it, and on which side (1 is left) */
  readonly top: number;
  readonly height: number;
  readonly side: number;
}

/** `per` kernel units are a millimetre. */
export function based(triangle: Triangle, per: number): BasedTriangle {
  const corners = triangle.map(([x, y]): Vec2 => [x * per, y * per]);
  const sides = corners.map(([x, y], i) => {
    const [nx, ny] = corners[(i + 1) % 3]!;
    return Math.hypot(nx - x, ny - y);
  });
  const base = Math.max(...sides);
  const longest = sides.indexOf(base);
  const corner = (i: number) => corners[(longest + i) % 3]!;
  const [ax, ay] = corner(0);
  const ux = (corner(1)[0] - ax) / base;
  const uy = (corner(1)[1] - ay) / base;
  const cx = corner(2)[0] - ax;
  const cy = corner(2)[1] - ay;
  const left = cy * ux - cx * uy;
  return { per, ax, ay, ux, uy, base, top: cx * ux + cy * uy, height: Math.abs(left), side: Math.sign(left) };
}
