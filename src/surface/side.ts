/**
 * A stroke as one side of a blended surface: perhaps reversed, and, when closed, opened at a chosen start.
 * The pair looks at strokes only through this, so that order and direction of drawing are settled in one place.
 */
import { scale2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { Curve } from '../stroke/curve.ts';

/** u nearer to a corner than this is on it: a tenth of a micrometre on a stroke of a metre. */
export const ON_CORNER = 1e-7;

export interface Side {
  /** mm */
  readonly length: number;
  /** ascending, in [0, 1); 0 only when the start of a closed curve is one */
  readonly corners: readonly number[];
  /** u in [0, 1] → mm on the plane */
  point(u: number): Vec2;
  /** d point / du, mm; `side`: at a corner the derivative before (−1) or after (1) it */
  derivative(u: number, side: -1 | 1): Vec2;
}

/** Where u = 0 lies on a closed curve (open ones begin at their ends), and which way u runs. */
export interface Opening {
  readonly start: number;
  readonly reversed: boolean;
}

/** The curve seen from its opening. */
export function openSide(curve: Curve, { start, reversed }: Opening): Side {
  const base = curve.closed ? start : reversed ? 1 : 0;
  const onCurve = (u: number): number => (reversed ? base - u : base + u);
  const snaps = cornersFrom(curve, base, reversed);
  const tangent = (u: number, side: -1 | 1): Vec2 => {
    // rounding of base ± u must not step over a corner
    const at = snaps.find((snap) => Math.abs(snap.u - u) <= ON_CORNER)?.corner ?? onCurve(u);
    return reversed ? curve.tangent(at, side === 1 ? -1 : 1) : curve.tangent(at, side);
  };
  return {
    length: curve.length,
    corners: snaps.map(({ u }) => u).filter((u) => u < 1),
    point: (u) => curve.point(onCurve(u)),
    derivative: (u, side) => scale2(tangent(u, side), reversed ? -curve.length : curve.length),
  };
}

/** The curve's corners by the side's own u, ascending; one at the start of a closed curve is also at its end. */
function cornersFrom(curve: Curve, base: number, reversed: boolean): { u: number; corner: number }[] {
  const found = curve.corners.flatMap((corner) => {
    const away = reversed ? base - corner : corner - base;
    const u = curve.closed ? away - Math.floor(away) : away;
    const atSeam = curve.closed && (u < ON_CORNER || u > 1 - ON_CORNER);
    return (atSeam ? [0, 1] : [u]).map((place) => ({ u: place, corner }));
  });
  return found.sort((a, b) => a.u - b.u);
}
