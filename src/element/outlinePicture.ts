/** A section in small: its chord dashed, its front solid below it, and a back of its own above. */
import { html, type TemplateResult } from 'lit';
import type { Outline } from '../surface/outline.ts';

/** px */
const SIZE = { width: 56, height: 34, margin: 3 } as const;
const STEPS = 48;

export function outlinePicture(outline: Outline): TemplateResult {
  const front = pointsOf(outline, 0, outline.closed ? 0.5 : 1);
  const back = outline.closed ? pointsOf(outline, 0.5, 1) : [];
  const all = [...front, ...back, [-1, 0], [1, 0]];
  const [left, right] = spanOf(all.map(([x]) => x!));
  const [top, bottom] = spanOf(all.map(([, y]) => y!));
  const { width, height, margin } = SIZE;
  const scale = Math.min(
    (width - 2 * margin) / Math.max(right - left, 1e-6),
    (height - 2 * margin) / Math.max(bottom - top, 1e-6),
  );
  // out of the plane is down: the side that one sees is nearer
  const path = (points: readonly (readonly number[])[]) =>
    points
      .map(([x, y]) => {
        const at = [
          (x! - (left + right) / 2) * scale + width / 2,
          (y! - (top + bottom) / 2) * scale + height / 2,
        ];
        return at.map((value) => value.toFixed(1)).join(' ');
      })
      .reduce((so, at) => (so ? `${so}L${at}` : `M${at}`), '');
  return html`<svg class="outline" viewBox="0 0 ${width} ${height}" aria-hidden="true">
    <path class="back" d=${path(back)} /><path class="chord" d=${path([
      [-1, 0],
      [1, 0],
    ])} /><path class="front" d=${path(front)} />
  </svg>`;
}

const spanOf = (values: readonly number[]): readonly [number, number] => [
  Math.min(...values),
  Math.max(...values),
];

function pointsOf(outline: Outline, from: number, to: number): (readonly [number, number])[] {
  const even = Array.from({ length: STEPS + 1 }, (_, i) => from + ((to - from) * i) / STEPS);
  const corners = outline.corners.filter((v) => v > from && v < to);
  return [...even, ...corners]
    .sort((a, b) => a - b)
    .map((v) => outline.point(v) as readonly [number, number]);
}
