/**
 * The handles on the selected parts and groups: a square for the view plane, a knob an axis, one that slides over the surface
 * underneath, and a ring with those that turn, about the line of sight and the screen's other axes, and one that scales. They keep their size on the screen, lie over everything, and are buttons for the keyboard.
 */
import { html, nothing, svg, type TemplateResult } from 'lit';
import { groupsChosen } from '../document/chosen.ts';
import { nameOf } from '../document/command/changeParts.ts';
import { middleOfParts, seenParts } from '../document/extent.ts';
import { place3 } from '../math/placement.ts';
import { length2, scale2, unrotate3 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import { project, toWorld } from '../stroke/plane.ts';
import type { View } from '../stroke/stroke.ts';
import { AXIS, type Handle, TILT } from '../tool/move.ts';
import type { Carried } from '../tool/tool.ts';
import type { Actions } from './controls.ts';
import { dragHandle, hasFocus, keyHandle, letGo, takeFocus } from './gizmoHands.ts';
import { icon } from './icons.ts';
import type { Rect, Size } from './place.ts';
import { isDrawingRadius } from './radiusDrawing.ts';
import type { Session } from './session.ts';
import { PART_WORDS, SOLID_WORDS } from './words.ts';

/** px from the middle: a whole axis, the sliding knob, the ring; and below 700 px of width */
const REACH = {
  wide: { axis: 118, slide: 116, ring: 184 },
  narrow: { axis: 88, slide: 90, ring: 138 },
} as const;
/** px of width below which everything is nearer */
const NARROW = 700;
/** An axis that appears shorter than this part of itself points at the viewer. */
const END_ON = 0.42;
/** px between two knobs */
const APART = 46;
/** px the controls at the edges take: the top row, the tools, the actions, an open dock, and on phones tools and actions, or a sheet */
const EDGE = { side: 28, top: 92, left: 104, bottom: 112, dock: 352, tools: 190 } as const;

interface Knob {
  readonly handle: Handle;
  /** px from the middle, right and down; null: not to be had now */
  readonly at: Vec2 | null;
}

export function gizmo(session: Session, actions: Actions): TemplateResult | typeof nothing {
  const { view, size, document } = session;
  // the pen draws over where it would be
  if (session.tool !== 'select' || session.state.band || isDrawingRadius(session)) return nothing;
  const middle = middleNow(session);
  const at = (middle && project(view, size, middle)) ?? OUTSIDE;
  // A handle in the hand stays, wherever it goes: without it nobody would hear where the hand lets go, nor what is typed.
  if (!session.state.carried && !hasFocus(session) && !isOn(size, at)) return nothing;
  const isOfParts = session.selection.every((id) => document.parts.some((part) => part.id === id));
  const others =
    isOfParts && document.parts.some(({ id, hidden }) => !hidden && !session.selection.includes(id));
  const free = freeArea(size, actions.open === 'parts' || actions.open === 'settings');
  const { carried } = session.state;
  const knobs = knobsAround(view, size, at, free, others).map((knob) => held(knob, carried));
  return html`<div class="gizmo" role="group" aria-label=${PART_WORDS.handles(nameOf(document, session.selection))}
    style="transform:translate(${at[0]}px,${at[1]}px)">
    <svg aria-hidden="true">${inkOfGroups(session, at)}${ring(knobs)}${knobs.map(shaft)}</svg>
    <span id="handle-hint" class="hidden">${PART_WORDS.handleHint}</span>
    <span id="turn-hint" class="hidden">${SOLID_WORDS.turnHint}</span>
    <span id="tilt-hint" class="hidden">${SOLID_WORDS.tiltHint}</span>
    <span id="scale-hint" class="hidden">${SOLID_WORDS.scaleHint}</span>
    ${knobs.map((knob) => button(knob, session))}
    ${tag(knobs, carried)}
  </div>`;
}

/** A knob of the ring goes with the hand. */
function held(knob: Knob, carried: Carried | undefined): Knob {
  const { handle, at } = knob;
  if (!at) return knob;
  if (carried?.degrees !== undefined && carried.about && turnOf(carried) === handle) {
    const way = carried.degrees / TILT;
    return { handle, at: carried.about === 'x' ? [at[0], at[1] + way] : [at[0] + way, at[1]] };
  }
  if (handle === 'turn' && carried?.degrees !== undefined && !carried.about) {
    const angle = (-carried.degrees * Math.PI) / 180;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    return { handle, at: [c * at[0] - s * at[1], s * at[0] + c * at[1]] };
  }
  if (handle === 'scale' && carried?.factor !== undefined) return { handle, at: scale2(at, carried.factor) };
  return knob;
}

const turnOf = ({ about }: Carried): Handle =>
  about === undefined ? 'turn' : about === 'x' ? 'turnX' : 'turnY';

/** The value beside the hand. */
function tag(knobs: readonly Knob[], carried: Carried | undefined): TemplateResult | typeof nothing {
  const { degrees, factor } = carried ?? {};
  const handle = carried && degrees !== undefined ? turnOf(carried) : 'scale';
  const at = knobs.find((knob) => knob.handle === handle)?.at;
  if (!at || (degrees === undefined && factor === undefined)) return nothing;
  const text =
    degrees !== undefined ? `${Math.round(degrees)}°`.replace('-', '−') : `${Math.round(100 * factor!)} %`;
  return html`<span class="value-tag" aria-hidden="true" style="left:${at[0]}px;top:${at[1]}px">${text}</span>`;
}

/** Around the middle, with gaps where its knobs are. */
function ring(knobs: readonly Knob[]) {
  const on = knobs.filter(({ handle, at }) => at && isOnRing(handle));
  const turn = on.find(({ handle }) => handle === 'turn')?.at;
  if (!turn) return nothing;
  const radius = length2(turn);
  const circle = svg`<circle r=${radius} class="ring-halo"/><circle r=${radius} class="ring"/>`;
  const holes = on.map(({ at }) => svg`<circle cx=${at![0]} cy=${at![1]} r="30" fill="#000"/>`);
  const far = radius + 8;
  return svg`<mask id="ring-gaps" maskUnits="userSpaceOnUse" x=${-far} y=${-far} width=${2 * far} height=${2 * far}>
      <circle r=${far} fill="#fff"/>${holes}</mask><g mask="url(#ring-gaps)">${circle}</g>`;
}

/** The strokes of selected groups, in blue pencil: the contour is that of all they blend with. */
function inkOfGroups(session: Session, [x0, y0]: Vec2) {
  const { view, size, selection } = session;
  const shown = groupsChosen(session.shown(), selection).filter(
    ({ solid, group }) => !group.hidden && !selection.includes(solid.id),
  );
  return shown.flatMap(({ group, solid }) =>
    group.strokes.map(({ samples, plane, closed }) => {
      const points = samples.flatMap(({ x, y }) => {
        const at = project(view, size, place3(solid.placement, toWorld(plane, [x, y])));
        return at ? [`${(at[0] - x0).toFixed(1)} ${(at[1] - y0).toFixed(1)}`] : [];
      });
      const path = `M${points.join('L')}${closed ? 'Z' : ''}`;
      return svg`<path class="ink-halo" d=${path}/><path class="ink" d=${path}/>`;
    }),
  );
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
  const bottom = !narrow ? EDGE.bottom : docked ? height / 2 + EDGE.side : EDGE.tools;
  const right = docked && !narrow ? EDGE.dock : EDGE.side;
  return {
    left: narrow ? EDGE.side : EDGE.left,
    top: EDGE.top,
    right: width - right,
    bottom: height - bottom,
  };
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
  const slide = others ? placeAt(SLIDE, reach.slide, middle, free, taken) : null;
  if (slide) taken.push(slide);
  const turn = placeAt(TURN, reach.ring, middle, free, taken);
  taken.push(turn);
  const scale = placeAt(SCALE, reach.ring, middle, free, taken);
  taken.push(scale);
  const tilts = (['turnY', 'turnX'] as const).map((handle): Knob => {
    const at = placeAt(handle === 'turnY' ? TILT_Y : TILT_X, reach.ring, middle, free, taken);
    taken.push(at);
    return { handle, at };
  });
  return [
    { handle: 'view', at: [0, 0] },
    ...axes,
    { handle: 'surface', at: slide },
    { handle: 'turn', at: turn },
    ...tilts,
    { handle: 'scale', at: scale },
  ];
}

const isFree = (at: Vec2, taken: readonly Vec2[]): boolean =>
  taken.every((other) => Math.hypot(at[0] - other[0], at[1] - other[1]) >= APART);

function isWithin({ left, top, right, bottom }: Rect, middle: Vec2, at: Vec2): boolean {
  const [x, y] = [middle[0] + at[0], middle[1] + at[1]];
  return x > left && x < right && y > top && y < bottom;
}

/** Degrees clockwise from the right: where a knob likes to be, and where else where there is no room. */
const QUARTERS = [45, 135, -135, -45] as const;
const BETWEEN = [22, 158, -158, -22, 67, 113, -113, -67, 0, 180, 90, -90] as const;
const SLIDE = [135, 45, -135, -45, ...BETWEEN] as const;
const TURN = [...QUARTERS, ...BETWEEN] as const;
const SCALE = [-36, -135, 135, 45, ...BETWEEN] as const;
/** below and above the form, and beside it: they are dragged along the ring there */
const TILT_Y = [90, -90, 67, 113, -67, -113, ...QUARTERS, ...BETWEEN] as const;
const TILT_X = [180, 0, 158, -158, 22, -22, ...QUARTERS, ...BETWEEN] as const;

function placeAt(
  angles: readonly number[],
  reach: number,
  middle: Vec2,
  free: Rect,
  taken: readonly Vec2[],
): Vec2 {
  const places = angles.map((degrees): Vec2 => {
    const angle = (degrees * Math.PI) / 180;
    return [reach * Math.cos(angle), reach * Math.sin(angle)];
  });
  const apart = places.filter((at) => isFree(at, taken));
  return apart.find((at) => isWithin(free, middle, at)) ?? apart[0] ?? places[0]!;
}

const shaft = ({ handle, at }: Knob) =>
  at && handle !== 'view' && !isOnRing(handle)
    ? svg`<path class="halo" d="M0 0L${at[0]} ${at[1]}"/><path class="shaft ${handle}" d="M0 0L${at[0]} ${at[1]}"/>`
    : nothing;

const HINT: Partial<Record<Handle, string>> = {
  turn: 'turn-hint',
  turnX: 'tilt-hint',
  turnY: 'tilt-hint',
  scale: 'scale-hint',
};

const isOnRing = (handle: Handle): handle is 'turn' | 'turnX' | 'turnY' | 'scale' =>
  HINT[handle] !== undefined;

/** Always there, hidden or not: the one that is being dragged must stay the same. */
function button({ handle, at }: Knob, session: Session): TemplateResult {
  const [x, y] = at ?? [0, 0];
  const name = PART_WORDS.handle[handle];
  return html`<button class="handle ${handle}" aria-label=${name} title=${name} aria-describedby=${HINT[handle] ?? 'handle-hint'} ?hidden=${!at}
    style="left:${x}px;top:${y}px"
    @pointerdown=${(event: PointerEvent) => dragHandle(event, session, handle)}
    @keydown=${(event: KeyboardEvent) => keyHandle(event, session, handle)}
    @keyup=${(event: KeyboardEvent) => letGo(session, event)} @focus=${() => takeFocus(session)} @blur=${() => letGo(session)}
  ><span>${face(handle)}</span></button>`;
}

function face(handle: Handle): TemplateResult | string {
  if (handle === 'view') return icon('move', 20);
  if (isOnRing(handle)) return icon(handle, 20);
  return handle === 'surface' ? icon('attach', 20) : handle.toUpperCase();
}
