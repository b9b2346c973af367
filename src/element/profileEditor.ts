/**
 * The profile of a line, curve or ring: what its radius is multiplied by along it, as a curve whose points are dragged or moved by arrow keys. It is
 * shown as it would be while a point is in the hand, and is one undo step then.
 */
import { css, html, nothing, svg, type TemplateResult } from 'lit';
import { profileAt } from '../document/form/profile.ts';
import type { Form, Group } from '../document/solid.ts';
import type { Session } from './session.ts';
import { percent } from './sliderRow.ts';
import { SKELETON_WORDS } from './words.ts';

const WITH_PROFILE: readonly Form[] = ['line', 'curve', 'ring'];

/** px */
const WIDE = 272;
const HIGH = 104;
const AIR = 14;
/** factors at the lower and the upper edge, in equal ratios; and points of a profile that has fewer */
const LEAST = 0.25;
const MOST = 4;
const POINTS = 5;
/** a press of an arrow key multiplies by this */
const STEP = 1.1;

/** Of exactly one group that has one. */
export function profileEditor(session: Session, groups: readonly Group[]): TemplateResult | typeof nothing {
  const [group, ...others] = groups;
  if (!group || others.length > 0 || !WITH_PROFILE.includes(group.form)) return nothing;
  const title = html`<h3>${SKELETON_WORDS.profile} <span class="value">${rangeOf(group.shape.profile)}</span></h3>`;
  if (group.skeleton) return html`${title}<p class="quiet-words">${SKELETON_WORDS.profileByHand}</p>`;
  const points = pointsOf(group.shape.profile);
  const line = points
    .map((factor, i) => `${i === 0 ? 'M' : 'L'}${xOf(i, points.length)} ${yOf(factor)}`)
    .join('');
  return html`${title}
    <div class="profile" role="group" aria-label=${SKELETON_WORDS.profileOf(group.name)} style="width:${WIDE}px;height:${HIGH}px">
      <svg aria-hidden="true" viewBox="0 0 ${WIDE} ${HIGH}">
        <path class="even" d="M${AIR} ${yOf(1)}H${WIDE - AIR}"/>
        <path class="area" d="${line}L${WIDE - AIR} ${HIGH}L${AIR} ${HIGH}Z"/><path class="line" d=${line}/>
        ${points.map((factor, i) => svg`<circle cx=${xOf(i, points.length)} cy=${yOf(factor)} r="6"/>`)}
      </svg>
      ${points.map((factor, i) => handle(session, group, points, factor, i))}
    </div>
    ${
      points.every((factor) => factor === points[0])
        ? nothing
        : html`<button class="b even-profile" @click=${() => session.run(commandOf(group, [1]))}>${SKELETON_WORDS.profileEven}</button>`
    }`;
}

/** As many as there are, or enough to shape it. */
export function pointsOf(profile: readonly number[]): readonly number[] {
  if (profile.length >= POINTS) return profile;
  return Array.from({ length: POINTS }, (_, i) => profileAt({ profile }, i / (POINTS - 1)));
}

function rangeOf(profile: readonly number[]): string {
  const [low, high] = [Math.min(...profile), Math.max(...profile)];
  return low === high ? percent(low) : `${percent(low)} – ${percent(high)}`;
}

const xOf = (i: number, count: number): number => AIR + (i * (WIDE - 2 * AIR)) / (count - 1);

/** Within the picture, however far off. */
export function yOf(factor: number): number {
  const within = Math.min(Math.max(factor, LEAST), MOST);
  const share = Math.log(within / LEAST) / Math.log(MOST / LEAST);
  return HIGH - AIR - share * (HIGH - 2 * AIR);
}

/** The factor at a height, in whole percent; 1 is easy to meet. */
export function factorAt(y: number): number {
  const share = Math.min(Math.max((HIGH - AIR - y) / (HIGH - 2 * AIR), 0), 1);
  const factor = LEAST * (MOST / LEAST) ** share;
  return Math.abs(factor - 1) < 0.05 ? 1 : Math.round(100 * factor) / 100;
}

const commandOf = ({ id }: Group, profile: readonly number[]) =>
  ({ type: 'setGroups', ids: [id], change: { profile } }) as const;

function handle(
  session: Session,
  group: Group,
  points: readonly number[],
  factor: number,
  i: number,
): TemplateResult {
  const set = (value: number, done: boolean) =>
    session.tune(
      commandOf(
        group,
        points.map((old, k) => (k === i ? value : old)),
      ),
      done,
    );
  const name = SKELETON_WORDS.profilePoint(i + 1, points.length);
  return html`<span class="factor" role="slider" tabindex="0" aria-label=${name} aria-orientation="vertical"
    aria-valuemin=${100 * LEAST} aria-valuemax=${100 * MOST} aria-valuenow=${Math.round(100 * factor)} aria-valuetext=${percent(factor)}
    style="left:${xOf(i, points.length)}px;top:${yOf(factor)}px"
    @pointerdown=${(event: PointerEvent) => drag(event, session, set)}
    @keydown=${(event: KeyboardEvent) => step(event, factor, set)}></span>`;
}

type Set = (value: number, done: boolean) => void;

function drag(event: PointerEvent, session: Session, set: Set): void {
  if (event.button !== 0) return;
  const point = event.currentTarget as HTMLElement;
  const box = point.parentElement!.getBoundingClientRect();
  const ended = new AbortController();
  const { signal } = ended;
  const at = (e: PointerEvent) => factorAt(((e.clientY - box.top) * HIGH) / box.height);
  let last: number | null = null;
  session.holdSlider();
  point.setPointerCapture(event.pointerId);
  point.addEventListener(
    'pointermove',
    (e) => {
      last = at(e);
      set(last, false);
    },
    { signal },
  );
  point.addEventListener(
    'pointerup',
    () => {
      ended.abort();
      if (last !== null) set(last, true);
    },
    { signal },
  );
  for (const type of ['pointercancel', 'lostpointercapture'] as const)
    point.addEventListener(
      type,
      () => {
        ended.abort();
        session.holdSlider();
      },
      { signal },
    );
}

function step(event: KeyboardEvent, factor: number, set: Set): void {
  const up = event.key === 'ArrowUp' || event.key === 'ArrowRight';
  const down = event.key === 'ArrowDown' || event.key === 'ArrowLeft';
  if (!up && !down && event.key !== 'Home') return;
  event.preventDefault();
  event.stopPropagation();
  const next = up ? factor * STEP : down ? factor / STEP : 1;
  set(Math.round(100 * Math.min(Math.max(next, LEAST), MOST)) / 100, true);
}

export const profileLayout = css`
  .profile { position: relative; margin: 0 0.5rem; border-radius: 0.75rem; background: var(--sunken); max-width: 100%; }
  .b.even-profile { margin: 0.25rem 0.5rem 0; padding: 0 0.75rem; border: 1.5px solid var(--edge); border-radius: 0.75rem; font: 600 0.875rem/1.25rem var(--font); }
  .profile svg { width: 100%; height: 100%; overflow: visible; }
  .profile path { fill: none; }
  .profile .even { stroke: var(--edge); stroke-dasharray: 3 4; }
  .profile .area { fill: var(--pencil-soft); }
  .profile .line { stroke: var(--pencil); stroke-width: 2; stroke-linejoin: round; }
  .profile circle { fill: var(--surface); stroke: var(--pencil); stroke-width: 2.5; }
  .profile .factor { position: absolute; width: 2.75rem; height: 2.75rem; margin: -1.375rem; border-radius: 50%; cursor: ns-resize; touch-action: none; }
  .profile .factor:focus-visible { outline: 3px solid var(--pencil); outline-offset: -6px; }
`;
