/**
 * What lies on the drawing: wet ink while the pen is down, the strokes of the unfinished form, and the blue
 * pencil (numbers, axis, the ring where a stroke starts on a part, the line that would close it). A canvas of its
 * own over the picture, so that ink never waits for the field.
 */
import { curveOfStroke } from '../document/build.ts';
import type { Vec2 } from '../math/vec.ts';
import { project, toWorld } from '../stroke/plane.ts';
import type { Stroke } from '../stroke/stroke.ts';
import type { Pen, Wet } from '../tool/tool.ts';
import type { Session } from './session.ts';

export interface InkColours {
  readonly ink: string;
  readonly pencil: string;
  readonly paper: string;
  readonly font: string;
}

/** px; a mouse, which has no pressure, draws at 0.5 */
const WIDTH = { least: 1.4, most: 4.4 } as const;
const STEPS = 96;

interface Dot {
  readonly x: number;
  readonly y: number;
  readonly pressure: number;
}

export function drawInk(
  canvas: HTMLCanvasElement,
  session: Session,
  colours: InkColours,
  predicted: readonly Pen[],
): void {
  const context = canvas.getContext('2d', { desynchronized: true });
  if (!context) return;
  const ratio = canvas.width / Math.max(1, session.size.width);
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, session.size.width, session.size.height);
  const lines = (session.document.draft?.strokes ?? []).map((stroke) => dried(stroke, session));
  if (lines.length === 2) drawAxis(context, lines[0]!, lines[1]!, colours);
  for (const line of lines) drawLine(context, line, colours.ink);
  for (const i of lines.keys()) drawNumber(context, i, lines, colours);
  if (session.state.wet) drawWet(context, session.state.wet, predicted, colours);
}

/** A stroke of the unfinished form as filtered, where the camera sees it now. */
function dried(stroke: Stroke, { document, view, size }: Session): Dot[] {
  const curve = curveOfStroke(stroke, document.brush);
  if (!curve) return [];
  const dots: Dot[] = [];
  for (let i = 0; i <= STEPS; i++) {
    const u = i / STEPS;
    const p = project(view, size, toWorld(stroke.plane, curve.point(u)));
    if (p) dots.push({ x: p[0], y: p[1], pressure: curve.pressure(u) });
  }
  return dots;
}

/** Segments as wide as the pen was pressed there; round caps hide their joints. */
function drawLine(context: CanvasRenderingContext2D, dots: readonly Dot[], colour: string): void {
  context.strokeStyle = colour;
  context.lineCap = 'round';
  for (let i = 1; i < dots.length; i++) {
    const a = dots[i - 1]!;
    const b = dots[i]!;
    context.lineWidth = WIDTH.least + ((WIDTH.most - WIDTH.least) * (a.pressure + b.pressure)) / 2;
    context.beginPath();
    context.moveTo(a.x, a.y);
    context.lineTo(b.x, b.y);
    context.stroke();
  }
}

function drawWet(
  context: CanvasRenderingContext2D,
  wet: Wet,
  predicted: readonly Pen[],
  colours: InkColours,
): void {
  drawLine(context, [...wet.pens, ...predicted], colours.ink);
  const first = wet.pens[0];
  const last = wet.pens.at(-1);
  if (!first || !last) return;
  if (wet.on) drawRing(context, first, colours, true);
  if (!wet.closing) return;
  drawRing(context, first, colours, false);
  dash(context, [last.x, last.y], [first.x, first.y], colours.pencil, [4, 5]);
}

function drawRing(context: CanvasRenderingContext2D, { x, y }: Dot, colours: InkColours, dot: boolean): void {
  context.strokeStyle = colours.pencil;
  context.lineWidth = 2;
  context.beginPath();
  context.arc(x, y, 11, 0, 2 * Math.PI);
  context.stroke();
  if (!dot) return;
  context.fillStyle = colours.pencil;
  context.beginPath();
  context.arc(x, y, 3.5, 0, 2 * Math.PI);
  context.fill();
}

/** The centre line of a rotational surface: midway between strokes that run the same way. */
function drawAxis(context: CanvasRenderingContext2D, left: Dot[], right: Dot[], colours: InkColours): void {
  const same = distance(left[0], right[0]) + distance(left.at(-1), right.at(-1));
  const crossed = distance(left[0], right.at(-1)) + distance(left.at(-1), right[0]);
  const other = same <= crossed ? right : [...right].reverse();
  const middle = left.flatMap((a, i): Vec2[] => {
    const b = other[i];
    return b ? [[(a.x + b.x) / 2, (a.y + b.y) / 2]] : [];
  });
  context.globalAlpha = 0.55;
  path(context, middle, colours.pencil, [2, 7]);
  context.globalAlpha = 1;
}

const distance = (a: Dot | undefined, b: Dot | undefined) => (a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0);

const dash = (context: CanvasRenderingContext2D, a: Vec2, b: Vec2, colour: string, pattern: number[]) =>
  path(context, [a, b], colour, pattern);

function path(
  context: CanvasRenderingContext2D,
  points: readonly Vec2[],
  colour: string,
  pattern: number[],
): void {
  context.strokeStyle = colour;
  context.lineWidth = 1.5;
  context.setLineDash(pattern);
  context.beginPath();
  points.forEach(([x, y], i) => {
    if (i === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  context.stroke();
  context.setLineDash([]);
}

/** 1, 2 at the starts, on the outer side, so that neighbours do not cover each other. */
function drawNumber(
  context: CanvasRenderingContext2D,
  index: number,
  lines: readonly (readonly Dot[])[],
  colours: InkColours,
): void {
  const line = lines[index] ?? [];
  const start = line[0];
  if (!start) return;
  const other = lines[1 - index]?.[0];
  const side =
    other && distance(start, other) < 60
      ? 26 * (other.x > start.x || (other.x === start.x && index === 0) ? -1 : 1)
      : 0;
  const away = line[Math.min(6, line.length - 1)] ?? start;
  const up = away.y >= start.y ? -1 : 1;
  const x = start.x + side;
  const y = start.y + 22 * up;
  context.fillStyle = colours.paper;
  context.strokeStyle = colours.pencil;
  context.lineWidth = 1.75;
  context.beginPath();
  context.arc(x, y, 11, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.fillStyle = colours.pencil;
  context.font = `600 13px ${colours.font}`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(String(index + 1), x, y + 0.5);
}
