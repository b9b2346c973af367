/** A ring: a closed tube with a radius at each of a few places, smooth in between. */
import type { MedialGraph, MedialNode } from '../../skeleton/medial/axis.ts';
import { distanceTo } from '../../skeleton/medial/outline.ts';
import type { Curve } from '../../stroke/curve.ts';
import { graphOf } from './chains.ts';
import { type FormKind, type Ink, radiiOf, radiusAt, widthForRadii } from './form.ts';
import { through } from './through.ts';
import { chainSkels, straight } from './tubes.ts';

/** places of a stroke that stay, beside its corners */
const FEWEST = 12;
const MOST = 24;
const LOOKED_AT = 240;
/** of the size: what the curve may be off the stroke */
const OFF = 0.008;

export const ring: FormKind = {
  width: (ink, kernel) => widthForRadii(kernel, radiiOf(skeletonOf(ink))),
  make(ink, sum) {
    const skeleton = skeletonOf(ink);
    const skels = chainSkels(skeleton, sum, (row) => straight(through(row)));
    return skels.length > 0 ? { skeleton, skels } : null;
  },
};

const skeletonOf = (ink: Ink): MedialGraph =>
  ink.skeleton ?? graphOf(ink.curves.map((curve) => ({ nodes: nodesOf(ink, curve), closed: true })));

/** Corners and even places, and one more where the curve through them is off most, until it is near enough. */
function nodesOf(ink: Ink, curve: Curve): readonly MedialNode[] {
  const at = (u: number): MedialNode => ({ at: curve.point(u), radius: radiusAt(ink, curve, u) });
  const looked = evenly(LOOKED_AT, curve.closed);
  const enough = OFF * sizeOf(looked.map(at));
  let chosen = [...curve.corners].slice(0, MOST);
  for (const u of evenly(FEWEST, curve.closed)) if (isFar(u, chosen)) chosen.push(u);
  for (;;) {
    chosen = [...chosen].sort((a, b) => a - b);
    const nodes = chosen.map(at);
    if (chosen.length >= MOST) return nodes;
    const { u, off } = worst(looked, curve, through({ nodes, closed: true }).nodes);
    if (off <= enough || chosen.includes(u)) return nodes;
    chosen.push(u);
  }
}

function evenly(count: number, closed: boolean): readonly number[] {
  const last = closed ? count : count - 1;
  return Array.from({ length: count }, (_, i) => i / last);
}

/** u: two nearer than this are one */
const NEAR = 0.5 / FEWEST;

const isFar = (u: number, others: readonly number[]): boolean =>
  others.every((other) => {
    const apart = Math.abs(u - other);
    return Math.min(apart, 1 - apart) > NEAR;
  });

/** The place of the stroke that is farthest from a closed row, and how far, mm. */
function worst(places: readonly number[], curve: Curve, row: readonly MedialNode[]) {
  const loop = [row.map(({ at }) => at)];
  return places
    .map((u) => ({ u, off: distanceTo(curve.point(u), loop) }))
    .reduce((most, next) => (next.off > most.off ? next : most));
}

function sizeOf(nodes: readonly MedialNode[]): number {
  const span = (axis: 0 | 1) => {
    const values = nodes.map(({ at }) => at[axis]);
    return Math.max(...values) - Math.min(...values);
  };
  return Math.max(span(0), span(1));
}
