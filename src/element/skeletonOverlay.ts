/** The skeleton of what is selected, in blue pencil over the picture: circles and links that hands take hold of. */
import { css, html, nothing, svg, type TemplateResult } from 'lit';
import {
  type Hold,
  holdAt,
  holdSkeleton,
  type ShownNode,
  type SkeletonAt,
  shownNodes,
} from '../tool/skeleton.ts';
import { dragState, penOf } from './gizmoHands.ts';
import { icon } from './icons.ts';
import type { Session } from './session.ts';
import {
  chooseNode,
  chosenNode,
  isSkeletonOn,
  nodeKey,
  removeNode,
  selectedSkeleton,
  tapOf,
} from './skeletonEdit.ts';
import { SKELETON_WORDS } from './words.ts';

/** px from a chosen node to its knobs */
const KNOB = 46;
/** px: what one sees of a node */
const DOT = 5;

export function skeletonOverlay(session: Session): TemplateResult | typeof nothing {
  if (!isSkeletonOn(session)) return nothing;
  const found = selectedSkeleton(session);
  if (!found) return nothing;
  const at = session.state.skeleton ? { ...found, graph: session.state.skeleton } : found;
  const shown = shownNodes(at.graph, at.plane, session);
  const chosen = chosenNode(session, at);
  const take = (event: PointerEvent) => grab(event, session, at, shown);
  return html`<div class="skeleton" role="group" aria-label=${SKELETON_WORDS.of(at.group.name)}>
    <svg aria-hidden="true" @pointerdown=${take}>
      ${at.graph.links.map(([a, b]) => link(shown[a] ?? null, shown[b] ?? null))}
      ${shown.map((node, i) => circle(node, i === chosen, hasRim(at, i, chosen)))}
      ${shown.map((node, i) => dot(node, i === chosen))}
    </svg>
    <span id="node-hint" class="hidden">${SKELETON_WORDS.hint}</span>
    ${keyed(session, at, shown, chosen)}
  </div>`;
}

/** All radii of a plate are one: only the chosen node shows it. */
const hasRim = ({ group }: SkeletonAt, node: number, chosen: number | null): boolean =>
  group.form !== 'plate' || node === chosen;

function link(a: ShownNode | null, b: ShownNode | null) {
  if (!a || !b) return nothing;
  const path = `M${a.at[0]} ${a.at[1]}L${b.at[0]} ${b.at[1]}`;
  return svg`<path class="halo" d=${path}/><path class="bone" d=${path}/><path class="catch" d=${path}/>`;
}

function circle(node: ShownNode | null, chosen: boolean, rim: boolean) {
  if (!node || !rim) return nothing;
  const { at, radius } = node;
  return svg`<circle class="rim ${chosen ? 'chosen' : ''}" cx=${at[0]} cy=${at[1]} r=${radius}/>
    <circle class="catch" cx=${at[0]} cy=${at[1]} r=${radius}/>`;
}

function dot(node: ShownNode | null, chosen: boolean) {
  if (!node) return nothing;
  const [x, y] = node.at;
  return svg`<circle class="catch filled" cx=${x} cy=${y} r="22"/>
    <circle class="joint ${chosen ? 'chosen' : ''}" cx=${x} cy=${y} r=${chosen ? DOT + 2 : DOT}/>`;
}

/** For the keyboard: the chosen node, or the first. */
function keyed(
  session: Session,
  at: SkeletonAt,
  shown: readonly (ShownNode | null)[],
  chosen: number | null,
): TemplateResult | typeof nothing {
  const node = chosen ?? 0;
  const place = shown[node];
  if (!place) return nothing;
  const [x, y] = place.at;
  const name = SKELETON_WORDS.node(node + 1, shown.length, at.graph.nodes[node]!.radius);
  return html`<button class="node" aria-label=${name} aria-describedby="node-hint" style="left:${x}px;top:${y}px"
      @focus=${() => chosen === null && chooseNode(session, { node, time: 0 })}
      @keydown=${(event: KeyboardEvent) => pressed(event, session)}></button>
    ${chosen === null || session.state.skeleton ? nothing : knobs(session, node, x, y)}`;
}

/** Beside the chosen node, for hands without keys. */
function knobs(session: Session, node: number, x: number, y: number): TemplateResult {
  const grow = (event: PointerEvent) => begin(event, session, { kind: 'branch', node });
  const { width } = session.size;
  const side = x + KNOB + 24 > width ? -KNOB : KNOB;
  return html`<button class="knob" title=${SKELETON_WORDS.add} aria-label=${SKELETON_WORDS.add} style="left:${x + side}px;top:${y - KNOB / 2}px"
      @pointerdown=${grow} @click=${(event: MouseEvent) => event.detail === 0 && addBeside(session, node, x, y)}>${icon('plus', 20)}</button>
    <button class="knob danger" title=${SKELETON_WORDS.remove} aria-label=${SKELETON_WORDS.remove} style="left:${x + side}px;top:${y + KNOB / 2}px"
      @click=${() => removeNode(session)}>${icon('trash', 20)}</button>`;
}

/** As a tap on the knob does, by a key. */
function addBeside(session: Session, node: number, x: number, y: number): void {
  const pen = { x, y, pressure: 0.5, tiltX: 0, tiltY: 0, time: 0, pointer: 'mouse' } as const;
  session.begin(holding(session, { kind: 'branch', node }));
  session.down(pen);
  session.up();
}

function pressed(event: KeyboardEvent, session: Session): void {
  if (!nodeKey(event, session)) return;
  event.preventDefault();
  event.stopPropagation();
}

const holding = (session: Session, hold: Hold) =>
  holdSkeleton(hold, { before: tapOf(session), choose: (tap) => chooseNode(session, tap) }, session.idle);

function grab(
  event: PointerEvent,
  session: Session,
  at: SkeletonAt,
  shown: readonly (ShownNode | null)[],
): void {
  const frame = (event.currentTarget as Element).closest('.app')!;
  const chosen = chosenNode(session, at);
  const hold = holdAt(shown, at.graph, penOf(event, frame), (node) => hasRim(at, node, chosen));
  if (!hold) return;
  const { kind } = hold;
  if (kind === 'node' && event.altKey) begin(event, session, { kind: 'branch', node: hold.node });
  else if (kind === 'node' && event.shiftKey) begin(event, session, { kind: 'radius', node: hold.node });
  else begin(event, session, hold);
}

function begin(event: PointerEvent, session: Session, hold: Hold): void {
  const root = (event.currentTarget as Element).closest('.skeleton');
  dragState(event, session, holding(session, hold), () => {
    // Keys go to the node from now on; after the update that brings its button there.
    requestAnimationFrame(() => root?.querySelector<HTMLElement>('.node')?.focus({ preventScroll: true }));
  });
}

export const skeletonLayout = css`
  .skeleton, .skeleton > svg { position: absolute; left: 0; top: 0; width: 100%; height: 100%; pointer-events: none; overflow: visible; }
  .skeleton path, .skeleton .rim { fill: none; stroke-linecap: round; }
  .skeleton .halo { stroke: var(--surface); stroke-width: 5; opacity: 0.7; }
  .skeleton .bone { stroke: var(--pencil); stroke-width: 2; }
  .skeleton .rim { stroke: var(--pencil); stroke-width: 1.25; stroke-dasharray: 4 4; opacity: 0.8; }
  .skeleton .rim.chosen { stroke-width: 2.5; stroke-dasharray: none; opacity: 1; }
  .skeleton .joint { fill: var(--surface); stroke: var(--pencil); stroke-width: 2; }
  .skeleton .joint.chosen { fill: var(--pencil); stroke: var(--surface); }
  .skeleton .catch { fill: none; stroke: transparent; stroke-width: 20; pointer-events: stroke; touch-action: none; cursor: pointer; }
  .skeleton circle.catch:not(.filled) { cursor: ew-resize; stroke-width: 14; }
  .skeleton .catch.filled { stroke: none; fill: transparent; pointer-events: fill; cursor: grab; }
  .skeleton .node { position: absolute; width: 2.75rem; height: 2.75rem; margin: -1.375rem; border-radius: 50%; pointer-events: none; background: none; }
  .skeleton .knob { position: absolute; width: 2.75rem; height: 2.75rem; margin: -1.375rem; border-radius: 50%; display: grid; place-items: center; pointer-events: auto; touch-action: none; color: var(--pencil); }
  .skeleton .knob::before { content: ''; position: absolute; inset: 0.3125rem; border-radius: 50%; background: var(--surface); box-shadow: var(--e2); }
  .skeleton .knob > .icon { position: relative; }
  .skeleton .knob.danger { color: var(--danger); }
  .skeleton-row { display: flex; gap: 0.5rem; padding: 0.5rem 0.5rem 0; }
  .skeleton-row .b { flex: 1; border: 1.5px solid var(--edge); border-radius: 0.75rem; font: 600 0.875rem/1.25rem var(--font); }
`;
