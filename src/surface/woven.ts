/**
 * The smooth pieces of a patch: control nets that make the surface pass through every row and column (through.ts; clamped at stops
 * and creases with the surface's own derivatives, which neighbours share where it is smooth), subdivided and pushed to their
 * limits; or, without a spline (thesis fig. 5.13(b)), the mixed sections themselves in as many places.
 */
import type { Vec2 } from '../math/vec.ts';
import { controlsAcross } from './across.ts';
import type { AlikePiece, Along } from './alike.ts';
import { type KnotPiece, knotsOf } from './knots.ts';
import { type Limit, limitOf, masked, type Net, subdivided } from './net.ts';
import { clampedThrough, netOfRows } from './through.ts';
import type { Weave } from './weave.ts';
import { rowAt } from './wovenRow.ts';

/** How often every span is halved. */
export interface Times {
  readonly u: number;
  readonly v: number;
}

/** A piece of the surface between stops and creases: rows at us, columns at vs. */
export interface Woven {
  readonly us: readonly number[];
  readonly vs: readonly number[];
  readonly limit: Limit;
}

/** The controls of every piece, in order along and across. */
export function controlNets(weave: Weave): Net[][] {
  const { alike, along, across } = weave;
  const polygons = alike.pieces.map((piece, j) =>
    piece.along.map((outline) => flat(controlsAcross(outline, across[j]!, alike.seamless))),
  );
  return along.map((piece) => polygons.map((polygon) => netAlong(weave, piece, polygon)));
}

function netAlong(weave: Weave, piece: KnotPiece, polygon: readonly number[][]): Net {
  const us = knotsOf(piece);
  const rows = us.map((u, k) => rowAt(weave, polygon, 'points', u, sideOf(k, us)));
  const slope = (k: number, t: number): Float64Array => rows[k]!.rate.map((x) => x * piece.map.slope(t));
  const ends = { first: slope(0, 0), last: slope(us.length - 1, piece.spans) };
  return netOfRows(
    clampedThrough(
      rows.map(({ at }) => at),
      ends,
    ),
  );
}

/** The patch: its pieces in order along and across. */
export function splined(weave: Weave, times: Times): Woven[][] {
  const v = weave.alike.seamless ? 'periodic' : 'clamped';
  return controlNets(weave).map((nets, i) =>
    nets.map((net, j) => {
      const fine = subdivided(subdivided(net, 'u', 'clamped', times.u), 'v', v, times.v);
      const limit = limitOf(fine, { u: 'clamped', v });
      return {
        us: knotsOf(weave.along[i]!, times.u),
        vs: knotsOf(weave.across[j]!, times.v),
        limit: v === 'periodic' ? roundAgain(limit) : limit,
      };
    }),
  );
}

/** The same without a spline. */
export function unsplined(weave: Weave, times: Times): Woven[][] {
  const { alike, along, across } = weave;
  return along.map((piece) => {
    const us = knotsOf(piece, times.u);
    return alike.pieces.map((part, j) => {
      const vs = knotsOf(across[j]!, times.v);
      const rows = (kind: 'points' | 'vectors', sample: (outline: Along, v: number) => Vec2) => {
        const forms = formsAt(part, vs, sample);
        return us.map((u, k) => rowAt(weave, forms, kind, u, sideOf(k, us)));
      };
      const points = rows('points', (outline, v) => outline.point(v));
      const vectors = rows('vectors', (outline, v) => outline.derivative(v));
      return {
        us,
        vs,
        limit: {
          points: netOfRows(points.map(({ at }) => at)),
          du: netOfRows(points.map(({ rate }) => rate)),
          dv: netOfRows(vectors.map(({ at }) => at)),
          duv: netOfRows(vectors.map(({ rate }) => rate)),
        },
      };
    });
  });
}

function formsAt(
  part: AlikePiece,
  vs: readonly number[],
  sample: (outline: Along, v: number) => Vec2,
): number[][] {
  return part.along.map((outline) => vs.flatMap((v) => [...sample(outline, v)]));
}

/** At the end of its piece a row belongs to what comes before. */
function sideOf(k: number, us: readonly number[]): -1 | 1 {
  return k === us.length - 1 ? -1 : 1;
}

/** The first column once more at the end. */
function roundAgain(limit: Limit): Limit {
  const { columns } = limit.points;
  const mask = Array.from({ length: columns + 1 }, (_, from) => ({ from, weights: [1] }));
  const round = (net: Net): Net => masked(net, 'v', mask);
  return { points: round(limit.points), du: round(limit.du), dv: round(limit.dv), duv: round(limit.duv) };
}

function flat(points: readonly Float64Array[]): number[] {
  return points.flatMap((point) => [...point]);
}
