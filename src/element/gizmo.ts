/**
 * The handles on the selected parts: a square for the view plane, a knob an axis, one that slides over the surface
 * underneath. They keep their size on the screen, lie over everything, and are buttons for the keyboard.
 */
import { html, nothing, svg, type TemplateResult } from 'lit';
import { middleOfParts, seenParts } from '../document/extent.ts';
import { place3 } from '../math/placement.ts';
import { unrotate3 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import { project } from '../stroke/plane.ts';
import type { View } from '../stroke/stroke.ts';
import { AXIS, type Handle } from '../tool/move.ts';
import type { Actions } from './controls.ts';
import { dragHandle, hasFocus, keyHandle, letGo, takeFocus } from './gizmoHands.ts';
import { icon } from './icons.ts';
import { partsName } from './partCard.ts';
import type { Rect, Size } from './place.ts';
import type { Session } from './session.ts';
import { PART_WORDS } from './words.ts';

/** px from the middle: a whole axis, the sliding knob; and below 700 px of width */
const REACH = { wide: { axis: 118, slide: 116 }, narrow: { axis: 96, slide: 98 } } as const;
/** px of width below which everything is nearer */
const NARROW = 700;
/** An axis that appears shorter than this part of itself points at the viewer. */
const END_ON = 0.42;
/** px between two knobs */
const APART = 46;
/** px the controls at the edges take: the top row, an open dock, and on phones tools and actions, or a sheet */
const EDGE = { side: 28, top: 92, dock: 352, tools: 190 } as const;

interface Knob {
  readonly handle: Handle;
  /** px from the middle, right and down; null: not to be had now */
  readonly at: Vec2 | null;
}

export function gizmo(session: Session, actions: Actions): TemplateResult | typeof nothing {
  const { view, size, document } = session;
  if (session.tool !== 'select' || session.state.band) return nothing;
  const parts = seenParts(document, session.selection);
  const middle = middleNow(session);
  const at = (middle && project(view, size, middle)) ?? OUTSIDE;
  // A handle in the hand stays, wherever it goes: without it nobody would hear where the hand lets go, nor what is typed.
  if (!session.state.carried && !hasFocus(session) && !isOn(size, at)) return nothing;
  const others = document.parts.some(({ id, hidden }) => !hidden && !session.selection.includes(id));
  const free = freeArea(size, actions.open === 'parts' || actions.open === 'settings');
  const knobs = knobsAround(view, size, at, free, others);
  return html`<div class="gizmo" role="group" aria-label=${PART_WORDS.handles(partsName(parts))}
    style="transform:translate(${at[0]}px,${at[1]}px)">
    <svg aria-hidden="true">${knobs.map(shaft)}</svg>
    <span id="handle-hint" class="hidden">${PART_WORDS.handleHint}</span>
    ${knobs.map((knob) => button(knob, session))}
  </div>`;
}

const OUTSIDE: Vec2 = [-1e4, -1e4];

const isOn = ({ width, height }: Size, [x, y]: Vec2): boolean =>
  x >= 0 && y >= 0 && x <= width && y <= height;

/** Of the parts as shown: with the drag that is under way. */
export function middleNow({ document, selection, state }: Session): Vec3 | null {
  const middle = middleOfParts(seenParts(document, selection));
  return middle && state.carried ? place3(state.carried.by, middle) : middle;
}

/** Where a hand can reach the handles. */
function freeArea({ width, height }: Size, docked: boolean): Rect {
  const narrow = width < NARROW;
  const bottom = !narrow ? EDGE.side : docked ? height / 2 + EDGE.side : EDGE.tools;
  const right = docked && !narrow ? EDGE.dock : EDGE.side;
  return { left: EDGE.side, top: EDGE.top, right: width - right, bottom: height - bottom };
}

export function knobsAround(view: View, size: Size, middle: Vec2, free: Rect, others: boolean): Knob[] {
  const reach = size.width < NARROW ? REACH.narrow : REACH.wide;
  const taken: Vec2[] = [[0, 0]];
  const axes = (['x', 'y', 'z'] as const).map((handle): Knob => {
    const [x, y] = unrotate3(view.rotation, AXIS[handle]);
    if (Math.hypot(x, y) < END_ON) return { handle, at: null };
    const ends: Vec2[] = [
      [reach.axis * x, -reach.axis * y],
      [-reach.axis * x, reach.axis * y],
    ];
    // Two axes may lie one behind the other, or an end under a card: then the knob sits at the other end.
    const apart = ends.filter((end) => isFree(end, taken));
    const at = apart.find((end) => isWithin(free, middle, end)) ?? apart[0] ?? null;
    if (at) taken.push(at);
    return { handle, at };
  });
  const slide = others ? slideAt(reach.slide, middle, free, taken) : null;
  return [{ handle: 'view', at: [0, 0] }, ...axes, { handle: 'surface', at: slide }];
}

const isFree = (at: Vec2, taken: readonly Vec2[]): boolean =>
  taken.every((other) => Math.hypot(at[0] - other[0], at[1] - other[1]) >= APART);

function isWithin({ left, top, right, bottom }: Rect, middle: Vec2, at: Vec2): boolean {
  const [x, y] = [middle[0] + at[0], middle[1] + at[1]];
  return x > left && x < right && y > top && y < bottom;
}

/** Down to the right, or the next quarter where there is room. */
function slideAt(reach: number, middle: Vec2, free: Rect, taken: readonly Vec2[]): Vec2 {
  const places = [45, 135, -135, -45, 22, 158, -158, -22].map((degrees): Vec2 => {
    const angle = (degrees * Math.PI) / 180;
    return [reach * Math.cos(angle), reach * Math.sin(angle)];
  });
  const apart = places.filter((at) => isFree(at, taken));
  return apart.find((at) => isWithin(free, middle, at)) ?? apart[0] ?? places[0]!;
}

const shaft = ({ handle, at }: Knob) =>
  at && handle !== 'view'
    ? svg`<path class="halo" d="M0 0L${at[0]} ${at[1]}"/><path class="shaft ${handle}" d="M0 0L${at[0]} ${at[1]}"/>`
    : nothing;

/** Always there, hidden or not: the one that is being dragged must stay the same. */
function button({ handle, at }: Knob, session: Session): TemplateResult {
  const [x, y] = at ?? [0, 0];
  const name = PART_WORDS.handle[handle];
  return html`<button class="handle ${handle}" aria-label=${name} title=${name} aria-describedby="handle-hint" ?hidden=${!at}
    style="left:${x}px;top:${y}px"
    @pointerdown=${(event: PointerEvent) => dragHandle(event, session, handle)}
    @keydown=${(event: KeyboardEvent) => keyHandle(event, session, handle)}
    @keyup=${(event: KeyboardEvent) => letGo(session, event)} @focus=${() => takeFocus(session)} @blur=${() => letGo(session)}
  ><span>${face(handle)}</span></button>`;
}

function face(handle: Handle): TemplateResult | string {
  if (handle === 'view') return icon('move', 20);
  return handle === 'surface' ? icon('attach', 20) : handle.toUpperCase();
}
