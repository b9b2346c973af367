/** The skeleton in the hand: whether it is shown, which node keys are for, and what they do. */
import { moved, split, swollen, without } from '../document/skeletonEdits.ts';
import { add2, mix2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import type { MedialGraph } from '../skeleton/medial/axis.ts';
import { neighboursOf } from '../skeleton/medial/branches.ts';
import { type NodeTap, type SkeletonAt, skeletonAt } from '../tool/skeleton.ts';
import type { Session } from './session.ts';
import { SKELETON_WORDS } from './words.ts';

interface Shown {
  on: boolean;
  tap: NodeTap | null;
  /** the group it is of: another one has its own nodes */
  group: string;
}

const shown = new WeakMap<Session, Shown>();

/** mm a press of a key moves, and with Shift */
const STEP = { plain: 1, shift: 10 } as const;

/** The skeleton that could be shown. */
export const selectedSkeleton = (session: Session): SkeletonAt | null =>
  session.tool === 'select' ? skeletonAt(session.shown(), session.selection) : null;

export const isSkeletonOn = (session: Session): boolean => shown.get(session)?.on ?? false;

/** It is shown now. */
export const hasSkeleton = (session: Session): boolean =>
  isSkeletonOn(session) && selectedSkeleton(session) !== null;

/** True when there is one to show, or to hide. */
export function toggleSkeleton(session: Session): boolean {
  const on = !isSkeletonOn(session);
  const at = selectedSkeleton(session);
  if (on && !at) {
    session.said = SKELETON_WORDS.none;
    session.update();
    return true;
  }
  shown.set(session, { on, tap: null, group: at?.group.id ?? '' });
  session.said =
    on && at ? SKELETON_WORDS.shown(at.group.name, at.graph.nodes.length) : SKELETON_WORDS.hidden;
  session.update();
  return true;
}

export const tapOf = (session: Session): NodeTap | null => shown.get(session)?.tap ?? null;

/** The node that keys are for; null: none. */
export function chosenNode(session: Session, { group, graph }: SkeletonAt): number | null {
  const known = shown.get(session);
  if (!known?.tap || known.group !== group.id || known.tap.node >= graph.nodes.length) return null;
  return known.tap.node;
}

export function chooseNode(session: Session, tap: NodeTap | null): void {
  const at = selectedSkeleton(session);
  shown.set(session, { on: true, tap, group: at?.group.id ?? '' });
  session.update();
}

/** Escape: the node is let go of, then the skeleton is hidden; false when neither is there. */
export function leaveSkeleton(session: Session): boolean {
  if (!isSkeletonOn(session) || !selectedSkeleton(session)) return false;
  if (tapOf(session)) chooseNode(session, null);
  else toggleSkeleton(session);
  return true;
}

/** Delete: a neighbour is chosen then. False when no skeleton is shown: while one is, the form is not what Delete is for. */
export function removeNode(session: Session): boolean {
  const at = isSkeletonOn(session) ? selectedSkeleton(session) : null;
  if (!at) return false;
  const node = chosenNode(session, at);
  if (node === null) {
    session.said = SKELETON_WORDS.chooseNode;
    session.update();
    return true;
  }
  const next = neighboursOf(at.graph)[node]![0] ?? 0;
  edit(session, at, without(at.graph, node));
  chooseNode(session, { node: next > node ? next - 1 : next, time: 0 });
  return true;
}

export function edit(session: Session, { group, graph }: SkeletonAt, next: MedialGraph | null): void {
  if (next !== graph) session.run({ type: 'editSkeleton', id: group.id, skeleton: next });
}

const ARROWS: Readonly<Record<string, Vec2>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Keys on the chosen node; false when the key means nothing. */
export function nodeKey(event: KeyboardEvent, session: Session): boolean {
  const at = selectedSkeleton(session);
  if (!at || event.ctrlKey || event.metaKey || event.altKey) return false;
  const { graph, group } = at;
  const node = chosenNode(session, at) ?? 0;
  const { at: place, radius } = graph.nodes[node]!;
  const step = event.shiftKey ? STEP.shift : STEP.plain;
  const [x, y] = ARROWS[event.key] ?? [0, 0];
  const count = graph.nodes.length;
  const to = (next: number) => chooseNode(session, { node: (next + count) % count, time: 0 });
  const wider = (by: number) =>
    swollen(graph, node, Math.round(10 * (radius + by)) / 10, group.form === 'plate');
  if (event.key in ARROWS) edit(session, at, moved(graph, node, add2(place, [step * x, step * y])));
  else if (event.key === '+' || event.key === '=') edit(session, at, wider(0.5));
  else if (event.key === '-') edit(session, at, wider(-0.5));
  else if (event.key === 'PageDown') to(node + 1);
  else if (event.key === 'PageUp') to(node - 1);
  else if (event.key === 'Enter') splitNext(session, at, node);
  else return false;
  return true;
}

/** The first link of a node gets one in its middle, which is chosen. */
function splitNext(session: Session, at: SkeletonAt, node: number): void {
  const { graph } = at;
  const link = graph.links.findIndex((ends) => ends.includes(node));
  if (link < 0) return;
  const [a, b] = graph.links[link]!;
  edit(session, at, split(graph, link, mix2(graph.nodes[a]!.at, graph.nodes[b]!.at, 0.5)));
  chooseNode(session, { node: graph.nodes.length, time: 0 });
}
