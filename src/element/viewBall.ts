/** The view ball: drag turns, a tap on an axis looks along it, a double tap resets. There for fingers at every size. */
import { html, svg, type TemplateResult } from 'lit';
import { type Vec3, vec3 } from '../math/vec.ts';
import type { View } from '../stroke/stroke.ts';

export type Axis = 'right' | 'left' | 'top' | 'bottom' | 'front' | 'back';

const AXES: readonly { name: Axis; label: string; direction: Vec3; colour: string }[] = [
  { name: 'right', label: 'X', direction: [1, 0, 0], colour: 'var(--axis-x)' },
  { name: 'top', label: 'Y', direction: [0, 1, 0], colour: 'var(--axis-y)' },
  { name: 'front', label: 'Z', direction: [0, 0, 1], colour: 'var(--axis-z)' },
  { name: 'left', label: '', direction: [-1, 0, 0], colour: 'var(--axis-x)' },
  { name: 'bottom', label: '', direction: [0, -1, 0], colour: 'var(--axis-y)' },
  { name: 'back', label: '', direction: [0, 0, -1], colour: 'var(--axis-z)' },
];

/** px in the ball's own 76 px square */
const REACH = 25;

/** Which way one looks, in a word. */
export function viewName({ rotation }: View): string {
  const towards = vec3.transformQuat([0, 0, 0], [0, 0, 1], rotation);
  const found = AXES.find(({ direction }) => vec3.dot(direction, towards) > 0.999);
  return found ? found.name[0]!.toUpperCase() + found.name.slice(1) : 'Turned';
}

export interface BallActions {
  orbit(dx: number, dy: number): void;
  face(axis: Axis): void;
  reset(): void;
}

export function viewBall(view: View, actions: BallActions): TemplateResult {
  const back = [-view.rotation[0], -view.rotation[1], -view.rotation[2], view.rotation[3]] as const;
  const ends = AXES.map((axis) => ({ ...axis, at: vec3.transformQuat([0, 0, 0], axis.direction, back) }));
  ends.sort((a, b) => a.at[2]! - b.at[2]!);
  const name = viewName(view);
  return html`<div class="view chrome" part="view-ball" role="group" aria-label="View: ${name}">
    <svg viewBox="0 0 76 76" @pointerdown=${(event: PointerEvent) => drag(event, actions)} @dblclick=${() => actions.reset()}>
      <circle cx="38" cy="38" r="35" fill="var(--surface)" stroke="var(--hairline)" />
      ${ends.map(({ name: axis, label, colour, at }) => {
        const x = 38 + REACH * at[0]!;
        const y = 38 - REACH * at[1]!;
        const line = label
          ? svg`<path d="M38 38L${x} ${y}" stroke=${colour} stroke-width="2.5" stroke-linecap="round"/>`
          : '';
        const letter = label ? svg`<text x=${x} y=${y + 4}>${label}</text>` : '';
        const radius = label ? 9 : 5;
        return svg`<g data-axis=${axis}>${line}<circle cx=${x} cy=${y} r=${radius} fill=${colour} opacity=${label ? 1 : 0.35}/>${letter}</g>`;
      })}
    </svg>
    <span>${name}</span>
  </div>`;
}

const moved = { pixels: 0 };

function drag(event: PointerEvent, actions: BallActions): void {
  const ball = event.currentTarget as SVGElement;
  const axis = (event.target as Element).closest<SVGElement>('[data-axis]')?.dataset.axis as Axis | undefined;
  ball.setPointerCapture(event.pointerId);
  let { clientX: x, clientY: y } = event;
  moved.pixels = 0;
  const move = (e: PointerEvent) => {
    moved.pixels += Math.hypot(e.clientX - x, e.clientY - y);
    // The ball is small: the model follows four times as far.
    actions.orbit(4 * (e.clientX - x), 4 * (e.clientY - y));
    x = e.clientX;
    y = e.clientY;
  };
  const end = () => {
    ball.removeEventListener('pointermove', move);
    if (axis && moved.pixels < 4) actions.face(axis);
  };
  ball.addEventListener('pointermove', move);
  ball.addEventListener('lostpointercapture', end, { once: true });
}
