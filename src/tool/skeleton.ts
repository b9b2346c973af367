/**
 * The skeleton of a group under the pen: a node is moved on the group's plane, a rim makes it larger or smaller, a link is split where it is
 * tapped, a node grows out of another one. While the pen is down the document is only shown as it would be; lifting it is one step.
 */
import { groupsChosen } from '../document/chosen.ts';
import { apply, type Command } from '../document/command/index.ts';
import type { Document } from '../document/document.ts';
import { branched, along as fraction, moved, split, swollen } from '../document/skeletonEdits.ts';
import type { Group } from '../document/solid.ts';
import { shapedOf } from '../document/solidNode.ts';
import { place3 } from '../math/placement.ts';
import { add2, add3, distance2, mix2, rotate3, scale3, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { MedialGraph } from '../skeleton/medial/axis.ts';
import { onPlane, project, rayAt, toWorld } from '../stroke/plane.ts';
import { isInReach, type Plane } from '../stroke/stroke.ts';
import type { Bench, Pen, State } from './tool.ts';
import type { Viewport } from './viewport.ts';

/** The one skeleton that is selected. */
export interface SkeletonAt {
  readonly group: Group;
  readonly graph: MedialGraph;
  /** where it lies now */
  readonly plane: Plane;
}

/** Of exactly one group, or of a solid that has but one; null where nothing can be made of it, or it is not seen. */
export function skeletonAt(document: Document, selection: readonly string[]): SkeletonAt | null {
  const chosen = groupsChosen(document, selection);
  const [only] = chosen;
  if (!only || chosen.length > 1 || only.solid.hidden || only.group.hidden) return null;
  const { group, component, solid } = only;
  const graph = group.skeleton ?? shapedOf(group, component)?.skeleton;
  if (!graph || graph.nodes.length === 0) return null;
  const { origin, x, y } = group.strokes[0]!.plane;
  const { rotation } = solid.placement;
  const plane = { origin: place3(solid.placement, origin), x: rotate3(rotation, x), y: rotate3(rotation, y) };
  return { group, graph, plane };
}

/** A node as it is seen, px. */
export interface ShownNode {
  readonly at: Vec2;
  readonly radius: number;
}

/** null: behind the camera */
export function shownNodes(
  graph: MedialGraph,
  plane: Plane,
  { view, size }: Pick<Viewport, 'view' | 'size'>,
): readonly (ShownNode | null)[] {
  const right = rotate3(view.rotation, [1, 0, 0]);
  return graph.nodes.map(({ at, radius }) => {
    const place = toWorld(plane, at);
    const [middle, rim] = [
      project(view, size, place),
      project(view, size, add3(place, scale3(right, radius))),
    ];
    return middle && rim && { at: middle, radius: distance2(middle, rim) };
  });
}

export type Hold =
  | { readonly kind: 'node'; readonly node: number }
  | { readonly kind: 'rim' | 'radius'; readonly node: number }
  | { readonly kind: 'branch'; readonly node: number }
  | { readonly kind: 'link'; readonly link: number };

/** px around the pen in which something is found */
const REACH = { touch: 22, pen: 14, mouse: 10 } as const;

/** What is under the pen: the nearest node, else a rim of one of `rims`, else a link. */
export function holdAt(
  shown: readonly (ShownNode | null)[],
  { links }: MedialGraph,
  { x, y, pointer }: Pick<Pen, 'x' | 'y' | 'pointer'>,
  rims: (node: number) => boolean = () => true,
): Hold | null {
  const reach = REACH[pointer];
  const pen: Vec2 = [x, y];
  const nearest = (offs: readonly number[]) =>
    offs.reduce((best, off, i) => (off <= reach && off < (offs[best] ?? Infinity) ? i : best), -1);
  const node = nearest(shown.map((at) => (at ? distance2(at.at, pen) : Infinity)));
  if (node >= 0) return { kind: 'node', node };
  const rim = nearest(
    shown.map((at, i) => (at && rims(i) ? Math.abs(distance2(at.at, pen) - at.radius) : Infinity)),
  );
  if (rim >= 0) return { kind: 'rim', node: rim };
  const link = nearest(
    links.map(([a, b]) => {
      const [p, q] = [shown[a], shown[b]];
      return p && q ? distance2(pen, mix2(p.at, q.at, fraction(pen, p.at, q.at))) : Infinity;
    }),
  );
  return link >= 0 ? { kind: 'link', link } : null;
}

export interface NodeTap {
  readonly node: number;
  readonly time: number;
}

export interface SkeletonHands {
  /** the tap before */
  readonly before: NodeTap | null;
  /** A node is what keys are for next. */
  choose(tap: NodeTap): void;
}

/** px a tap may move */
const STILL = 6;
/** ms between the two taps of a double tap */
const DOUBLE = 400;

/** What is about to be taken: the pen comes down on it next. */
export function holdSkeleton(hold: Hold, hands: SkeletonHands, back: State): State {
  return {
    name: 'skeleton.grip',
    still: true,
    down(pen, { document, selection }) {
      const at = skeletonAt(document, selection);
      return at
        ? dragging({ hold, hands, back, at, start: pen, pen, isMoved: false, graph: at.graph })
        : back;
    },
    cancel: () => back,
  };
}

interface Drag {
  readonly hold: Hold;
  readonly hands: SkeletonHands;
  readonly back: State;
  readonly at: SkeletonAt;
  readonly start: Pen;
  readonly pen: Pen;
  readonly isMoved: boolean;
  /** as it is now */
  readonly graph: MedialGraph;
}

function dragging(drag: Drag): State {
  const { at, back, graph, start } = drag;
  const command: Command = { type: 'editSkeleton', id: at.group.id, skeleton: graph };
  let shown: Document | null = null;
  return {
    name: 'skeleton.dragging',
    still: true,
    ...(drag.isMoved && {
      skeleton: graph,
      preview: (bench: Bench) => (shown ??= apply(bench.document, command)),
    }),
    move(pens, bench) {
      const pen = pens.at(-1) ?? drag.pen;
      const isMoved = drag.isMoved || Math.max(Math.abs(pen.x - start.x), Math.abs(pen.y - start.y)) > STILL;
      const next = isMoved ? taken({ ...drag, pen }, bench.viewport) : null;
      return dragging({ ...drag, pen, isMoved, graph: next ?? graph });
    },
    up(bench) {
      if (!drag.isMoved) return tapped(drag, bench);
      if (graph !== at.graph) bench.commit([command]);
      choose(drag, graph);
      return back;
    },
    cancel: () => back,
  };
}

/** The node that was held, or the one that is new. */
function choose({ hold, hands, at, start }: Drag, graph: MedialGraph): void {
  const isNew = graph.nodes.length > at.graph.nodes.length;
  const node = isNew ? graph.nodes.length - 1 : 'node' in hold ? hold.node : 0;
  // a drag is no tap
  hands.choose({ node, time: start.time - 2 * DOUBLE });
}

function tapped(drag: Drag, bench: Bench): State {
  const { hold, hands, at, start, back } = drag;
  const id = at.group.id;
  if (hold.kind === 'link') {
    const graph = taken(drag, bench.viewport);
    if (!graph) return back;
    bench.commit([{ type: 'editSkeleton', id, skeleton: graph }]);
    choose(drag, graph);
    return back;
  }
  const { node } = hold;
  if (hold.kind === 'branch') {
    const { at: from, radius } = at.graph.nodes[node]!;
    const graph = branched(at.graph, node, add2(from, [2 * radius, 0]), isLoop(at));
    bench.commit([{ type: 'editSkeleton', id, skeleton: graph }]);
    choose(drag, graph);
    return back;
  }
  const isDouble = hands.before?.node === node && start.time - hands.before.time < DOUBLE;
  if (isDouble && at.group.skeleton) bench.commit([{ type: 'editSkeleton', id, skeleton: null }]);
  hands.choose({ node, time: start.time });
  return back;
}

/** Plates are loops, of one thickness. */
const isLoop = ({ group }: SkeletonAt): boolean => group.form === 'plate';

/** The skeleton with the pen where it is; null where the plane cannot be told there. */
function taken({ hold, at, start, pen }: Drag, viewport: Viewport): MedialGraph | null {
  const { graph, plane } = at;
  if (hold.kind === 'rim' || hold.kind === 'radius')
    return wider(hold.kind, hold.node, at, start, pen, viewport);
  const to = placeUnder(pen, plane, viewport);
  const from = placeUnder(start, plane, viewport);
  if (!to || !from) return null;
  const by = sub2(to, from);
  if (hold.kind === 'link') {
    const [a, b] = graph.links[hold.link]!;
    const [p, q] = [graph.nodes[a]!.at, graph.nodes[b]!.at];
    return split(graph, hold.link, add2(mix2(p, q, fraction(from, p, q)), by));
  }
  const place = add2(graph.nodes[hold.node]!.at, by);
  return hold.kind === 'node'
    ? moved(graph, hold.node, place)
    : branched(graph, hold.node, place, isLoop(at));
}

/** By how much farther the pen is from the middle than it was, or, taken by the middle, how far to the right and up. */
function wider(
  kind: 'rim' | 'radius',
  node: number,
  at: SkeletonAt,
  start: Pen,
  pen: Pen,
  viewport: Viewport,
): MedialGraph | null {
  const shown = shownNodes(at.graph, at.plane, viewport)[node];
  if (!shown || !(shown.radius > 0)) return null;
  const { radius } = at.graph.nodes[node]!;
  const far = ({ x, y }: Pen) => distance2([x, y], shown.at);
  const by = kind === 'rim' ? far(pen) - far(start) : pen.x - start.x + start.y - pen.y;
  return swollen(at.graph, node, radius + (by * radius) / shown.radius, isLoop(at));
}

function placeUnder({ x, y }: Pen, plane: Plane, { view, size }: Viewport): Vec2 | null {
  const place = onPlane(rayAt(view, size, x, y), plane);
  return place && isInReach(place) ? place : null;
}
