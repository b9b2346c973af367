/** A NURBS skeleton (Jin & Tai 2002): control points with radii, which are what a person edits. */
import type { AnySkel } from '../../field/expand.ts';
import { distance2, mix2 } from '../../math/tuple.ts';
import type { Vec3 } from '../../math/vec.ts';
import type { MedialGraph, MedialNode } from '../../skeleton/medial/axis.ts';
import type { Curve } from '../../stroke/curve.ts';
import { graphOf, type Row } from './chains.ts';
import { controlsOf, evenKnots, grevilles, knotsFor } from './controls.ts';
import { type FormKind, type Ink, radiiOf, radiusAt, widthForRadii } from './form.ts';
import { chainSkels } from './tubes.ts';

export const curve: FormKind = {
  width: (ink, kernel) => widthForRadii(kernel, radiiOf(skeletonOf(ink))),
  make(ink, sum) {
    const skeleton = skeletonOf(ink);
    const skels = chainSkels(skeleton, sum, (row) => nurbsOf(row, ink));
    return skels.length > 0 ? { skeleton, skels } : null;
  },
};

const skeletonOf = (ink: Ink): MedialGraph =>
  ink.skeleton ?? graphOf(ink.curves.map((drawn) => ({ nodes: nodesOf(ink, drawn), closed: false })));

function nodesOf(ink: Ink, drawn: Curve): readonly MedialNode[] {
  const controls = controlsOf((u) => drawn.point(u), ink.shape.knots);
  const knots = knotsFor(ink.shape.knots, controls.length) ?? evenKnots(controls.length);
  return grevilles(knots).map((u, i) => ({ at: controls[i]!, radius: radiusAt(ink, drawn, u) }));
}

/** null where all of it is one place. Knots that are not for so many control points give way to even ones. */
function nurbsOf({ nodes, closed }: Row, { shape }: Ink): AnySkel | null {
  const round = closed ? [...nodes, nodes[0]!] : nodes;
  const controls = cubic(round);
  if (controls.every(({ at }) => distance2(at, controls[0]!.at) === 0)) return null;
  return {
    type: 'nurbs',
    points: controls.map(({ at }): Vec3 => [at[0], at[1], 0]),
    radii: controls.map(({ radius }) => radius),
    knots: [...(knotsFor(shape.knots, controls.length) ?? evenKnots(controls.length))],
    density: shape.density,
  };
}

/** Four control points at least: the same curve of degree one or two, raised to three. */
function cubic(nodes: readonly MedialNode[]): readonly MedialNode[] {
  const mixed = (a: MedialNode, b: MedialNode, t: number): MedialNode => ({
    at: mix2(a.at, b.at, t),
    radius: a.radius + t * (b.radius - a.radius),
  });
  const [a, b, c] = nodes;
  if (nodes.length > 3 || !a) return nodes;
  if (!b) return [a, a, a, a];
  if (!c) return [a, mixed(a, b, 1 / 3), mixed(a, b, 2 / 3), b];
  return [a, mixed(a, b, 2 / 3), mixed(c, b, 2 / 3), c];
}
