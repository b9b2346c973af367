/**
 * The marks of a tool on the ink's canvas, projected anew in each frame. Ink is what a person drew, blue what the program adds; lines lie on
 * a halo of paper, so that they are read over any form.
 */
import type { Vec2, Vec3 } from '../math/vec.ts';
import { project } from '../stroke/plane.ts';
import type { LineStyle, Mark } from '../tool/marks.ts';
import type { Viewport } from '../tool/viewport.ts';
import type { InkColours } from './wetInk.ts';
import { MARK_WORDS } from './words.ts';

interface Pencil {
  readonly of: 'pencil' | 'ink';
  readonly width: number;
  readonly dash: readonly number[];
  readonly alpha: number;
  /** px of paper on either side */
  readonly halo: number;
}

/** px, as pictured in the section guide */
const LINES: Readonly<Record<LineStyle, Pencil>> = {
  flat: { of: 'pencil', width: 2, dash: [], alpha: 1, halo: 0 },
  full: { of: 'ink', width: 2, dash: [], alpha: 0.75, halo: 0 },
  hollow: { of: 'ink', width: 2, dash: [8, 7], alpha: 0.75, halo: 0 },
  lit: { of: 'pencil', width: 3.5, dash: [], alpha: 1, halo: 1.5 },
  axis: { of: 'pencil', width: 2.25, dash: [9, 6], alpha: 1, halo: 1.25 },
  control: { of: 'pencil', width: 1, dash: [], alpha: 0.55, halo: 0 },
};
const DOT = 7;
const KNOB = 3;
const RING = 22;
/** px from a label's or a tag's place to its middle */
const AWAY = { label: 17, tag: 58 } as const;
const TAG = { height: 26, padding: 14, radius: 13 } as const;

type Seen = Pick<Viewport, 'view' | 'size'>;

export function drawMarks(
  context: CanvasRenderingContext2D,
  marks: readonly Mark[],
  seen: Seen,
  colours: InkColours,
): void {
  context.save();
  context.lineCap = 'round';
  context.lineJoin = 'round';
  // words over lines, whatever the order they come in
  const rank = ({ kind }: Mark) => ORDER.indexOf(kind);
  for (const mark of [...marks].sort((a, b) => rank(a) - rank(b))) drawOne(context, mark, seen, colours);
  context.restore();
}

const ORDER: readonly Mark['kind'][] = ['line', 'knot', 'ring', 'dot', 'label', 'tag'];

function drawOne(context: CanvasRenderingContext2D, mark: Mark, seen: Seen, colours: InkColours): void {
  if (mark.kind === 'line') {
    drawPath(context, mark, seen, colours);
    return;
  }
  const at = pixelOf(mark.at, seen);
  if (!at) return;
  if (mark.kind === 'dot') drawDot(context, at, mark.held === true, colours);
  if (mark.kind === 'knot') drawKnot(context, at, colours);
  if (mark.kind === 'ring') drawRing(context, at, colours);
  if (mark.kind === 'label') drawLabel(context, outside(at, mark.from, AWAY.label, seen), mark.word, colours);
  if (mark.kind === 'tag') {
    const words = MARK_WORDS.value(mark.value, mark.unit);
    drawTag(context, outside(at, mark.from, AWAY.tag, seen), words, seen, colours);
  }
}

const pixelOf = (at: Vec3, { view, size }: Seen): Vec2 | null => project(view, size, at);

/** Farther on, in the direction from `from`. */
function outside(at: Vec2, from: Vec3, by: number, seen: Seen): Vec2 {
  const start = pixelOf(from, seen) ?? at;
  const [dx, dy] = [at[0] - start[0], at[1] - start[1]];
  const length = Math.hypot(dx, dy) || 1;
  return [at[0] + (by * dx) / length, at[1] + (by * dy) / length];
}

function drawPath(
  context: CanvasRenderingContext2D,
  { points, style, closed }: Extract<Mark, { kind: 'line' }>,
  seen: Seen,
  colours: InkColours,
): void {
  const { of, width, dash, alpha, halo } = LINES[style];
  context.beginPath();
  let isDown = false;
  for (const point of points) {
    const at = pixelOf(point, seen);
    if (at && isDown) context.lineTo(...at);
    else if (at) context.moveTo(...at);
    isDown = at !== null;
  }
  if (closed) context.closePath();
  context.setLineDash([]);
  if (halo > 0) stroke(context, colours.paper, width + 2 * halo, 0.7);
  context.setLineDash([...dash]);
  stroke(context, colours[of], width, alpha);
  context.setLineDash([]);
}

function stroke(context: CanvasRenderingContext2D, colour: string, width: number, alpha: number): void {
  context.globalAlpha = alpha;
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.stroke();
  context.globalAlpha = 1;
}

function circle(context: CanvasRenderingContext2D, [x, y]: Vec2, radius: number): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
}

/** Filled while an end is held there. */
function drawDot(context: CanvasRenderingContext2D, at: Vec2, held: boolean, colours: InkColours): void {
  circle(context, at, held ? DOT + 1 : DOT);
  context.fillStyle = held ? colours.pencil : colours.paper;
  context.fill();
  stroke(context, held ? colours.paper : colours.pencil, 2.5, 1);
}

function drawKnot(context: CanvasRenderingContext2D, at: Vec2, colours: InkColours): void {
  circle(context, at, KNOB);
  context.fillStyle = colours.paper;
  context.fill();
  stroke(context, colours.pencil, 1.25, 1);
}

function drawRing(context: CanvasRenderingContext2D, at: Vec2, colours: InkColours): void {
  circle(context, at, RING);
  context.setLineDash([2, 5]);
  stroke(context, colours.pencil, 1.75, 1);
  context.setLineDash([]);
}

function write(context: CanvasRenderingContext2D, font: string): void {
  context.font = `600 13px ${font}`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
}

function drawLabel(
  context: CanvasRenderingContext2D,
  [x, y]: Vec2,
  word: keyof typeof MARK_WORDS.label,
  colours: InkColours,
): void {
  write(context, colours.font);
  const words = MARK_WORDS.label[word];
  context.strokeStyle = colours.paper;
  context.lineWidth = 4;
  context.strokeText(words, x, y);
  context.fillStyle = colours.ink;
  context.fillText(words, x, y);
}

/** Inside the picture, whatever it is the value of. */
function drawTag(
  context: CanvasRenderingContext2D,
  [x, y]: Vec2,
  words: string,
  { size }: Seen,
  colours: InkColours,
): void {
  write(context, colours.font);
  const half = context.measureText(words).width / 2 + TAG.padding;
  const cx = Math.min(Math.max(x, half + 4), size.width - half - 4);
  const cy = Math.min(Math.max(y, TAG.height), size.height - TAG.height);
  context.beginPath();
  context.roundRect(cx - half, cy - TAG.height / 2, 2 * half, TAG.height, TAG.radius);
  context.fillStyle = colours.pencil;
  context.fill();
  context.fillStyle = colours.paper;
  context.fillText(words, cx, cy + 0.5);
}
