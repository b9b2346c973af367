/**
 * What lies on the drawing: wet ink while the pen is down, the strokes of the unfinished form, and the blue
 * pencil (numbers, axis, the ring where a stroke starts on a part, the line that would close it). A canvas of its
 * own over the picture, so that ink never waits for the field.
 */
import { curveOfStroke } from '../document/curves.ts';
import { type Brush, isSurface, readingOf } from '../document/document.ts';
import { sectionCurves } from '../document/sectionCurves.ts';
import { PLAIN } from '../document/surfacePart.ts';
import { place3, UNMOVED } from '../math/placement.ts';
import { cross3 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import { project, toWorld } from '../stroke/plane.ts';
import type { Stroke } from '../stroke/stroke.ts';
import type { Band, Pen, Wet } from '../tool/tool.ts';
import { drawMarks } from './marks.ts';
import type { Session } from './session.ts';
import { litStroke } from './strokeLight.ts';
import { surfaceMarks } from './surfaceMarks.ts';

export interface InkColours {
  readonly ink: string;
  readonly pencil: string;
  readonly paper: string;
  readonly font: string;
}

/** px; a mouse, which has no pressure, draws at 0.5 */
const WIDTH = { least: 1.4, most: 4.4 } as const;
/** px between the points a dried stroke is drawn through, and how many there are at least and at most */
const STEP = { pixels: 3, least: 48, most: 1500 } as const;

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
  if (session.noPicture) drawParts(context, session);
  const { draft, brush } = session.document;
  const lines = (draft?.strokes ?? []).map((stroke) => dried(stroke, brush, session));
  if (lines.length === 2 && readingOf(session.document) === 'rotational')
    drawAxis(context, lines[0]!, lines[1]!, colours);
  const lit = litStroke(session);
  const colour = (i: number) => (i + 1 === lit ? colours.pencil : colours.ink);
  for (const [i, line] of lines.entries()) drawLine(context, line, colour(i));
  const across = draftSections(session);
  for (const [i, { line, isBehind }] of across.entries()) {
    // what lies behind is drawn behind
    context.globalAlpha = isBehind ? 0.45 : 1;
    drawLine(context, line, colour(lines.length + i));
    context.globalAlpha = 1;
  }
  // outlines are not counted
  if (readingOf(session.document) !== 'solid') {
    for (const i of lines.keys()) drawNumber(context, i, lines, colours);
    for (const [i, { at }] of across.entries())
      if (at) writeNumber(context, lines.length + i + 1, at, colours);
  }
  for (const mark of session.notice?.marks ?? []) drawMark(context, mark, session, colours);
  if (session.state.wet) drawWet(context, session.state.wet, predicted, colours);
  const { marks = session.state.marked?.(session) } = session.state;
  drawMarks(context, [...surfaceMarks(session), ...(marks ?? [])], session, colours);
  if (session.state.band) drawBand(context, session.state.band, colours);
}

/** Where an outline crosses itself: a cross in a ring, on paper so that it stands out from the ink. */
function drawMark(
  context: CanvasRenderingContext2D,
  mark: Vec3,
  { view, size }: Session,
  colours: InkColours,
): void {
  const at = project(view, size, mark);
  if (!at) return;
  const [x, y] = at;
  context.beginPath();
  context.arc(x, y, 10, 0, 2 * Math.PI);
  context.fillStyle = colours.paper;
  context.fill();
  context.strokeStyle = colours.pencil;
  context.lineWidth = 2;
  context.moveTo(x - 4, y - 4);
  context.lineTo(x + 4, y + 4);
  context.moveTo(x + 4, y - 4);
  context.lineTo(x - 4, y + 4);
  context.stroke();
}

/** The rectangle that selects what it takes in. */
function drawBand(context: CanvasRenderingContext2D, { from, to }: Band, { pencil }: InkColours): void {
  const box = [from.x, from.y, to.x - from.x, to.y - from.y] as const;
  context.fillStyle = pencil;
  context.globalAlpha = 0.08;
  context.fillRect(...box);
  context.globalAlpha = 1;
  context.strokeStyle = pencil;
  context.lineWidth = 1.5;
  context.setLineDash([5, 4]);
  context.strokeRect(...box);
  context.setLineDash([]);
}

/** Where nothing can be shaded, what was kept is still seen: its strokes, in its colours. */
function drawParts(context: CanvasRenderingContext2D, session: Session): void {
  for (const part of session.document.parts) {
    if (part.hidden || !isSurface(part)) continue;
    const { strokes, brush, placement } = part;
    for (const stroke of strokes) drawLine(context, dried(stroke, brush, session, placement), brush.colour);
  }
}

/** A stroke as filtered, where the camera sees it now. */
function dried(stroke: Stroke, brush: Brush, { view, size }: Session, placement = UNMOVED): Dot[] {
  const curve = curveOfStroke(stroke, brush);
  if (!curve) return [];
  const pixels = (curve.length * size.height) / view.height;
  const steps = Math.round(Math.min(STEP.most, Math.max(STEP.least, pixels / STEP.pixels)));
  const dots: Dot[] = [];
  for (let i = 0; i <= steps; i++) {
    const u = i / steps;
    const p = project(view, size, place3(placement, toWorld(stroke.plane, curve.point(u))));
    if (p) dots.push({ x: p[0], y: p[1], pressure: curve.pressure(u) });
  }
  return dots;
}

interface SectionInk {
  readonly line: readonly Dot[];
  readonly isBehind: boolean;
  /** of its number, px; null: behind the camera */
  readonly at: Vec2 | null;
}

/** What sections are made of, as it was drawn, but for its ends, which are where the surface has them. */
function draftSections({ document, view, size }: Session): readonly SectionInk[] {
  const { draft, brush } = document;
  if (!draft?.sections || readingOf(document) === 'solid') return [];
  const { plane } = draft.strokes[0]!;
  const [nx, ny, nz] = cross3(plane.x, plane.y);
  const pixel = ([x, y, z]: Vec3) => {
    const [ax, ay, az] = toWorld(plane, [x, y]);
    return project(view, size, [ax + z * nx, ay + z * ny, az + z * nz]);
  };
  const curves = sectionCurves({ strokes: draft.strokes, sections: draft.sections ?? PLAIN.sections }, brush);
  return curves.map(({ points, pressure, section, as, ends }, i) => {
    const before = curves.slice(0, i).filter((other) => other.section === section && other.as !== 'back');
    const [left, right] = ends.map(([x, y]) => pixel([x, y, 0]));
    return {
      isBehind: as === 'back',
      line: points.flatMap((p, k) => {
        const at = pixel(p);
        return at ? [{ x: at[0], y: at[1], pressure: pressure[k]! }] : [];
      }),
      at: as === 'back' ? beyond(right, left, 0) : beyond(left, right, before.length),
    };
  });
}

/** px from the end of a chord: outside of the ring that shows where the pen is near; and from one number to the next beyond it */
const BEYOND = { first: 36, next: 26 } as const;

/** Backs beyond one end, all others beyond the other one: no number covers another. */
function beyond(end: Vec2 | null | undefined, other: Vec2 | null | undefined, place: number): Vec2 | null {
  if (!end || !other) return null;
  const by = (BEYOND.first + place * BEYOND.next) / (Math.hypot(end[0] - other[0], end[1] - other[1]) || 1);
  return [end[0] + by * (end[0] - other[0]), end[1] + by * (end[1] - other[1])];
}

/** One filled outline, as wide as the pen was pressed: overlapping strokes would show their joints as beads. */
function drawLine(context: CanvasRenderingContext2D, dots: readonly Dot[], colour: string): void {
  const line = dots.filter((dot, i) => i === 0 || distance(dot, dots[i - 1]) > 0.01);
  const first = line[0];
  const last = line.at(-1);
  if (!first || !last) return;
  context.fillStyle = colour;
  context.beginPath();
  const left = line.map((_, i) => offset(line, i, 1));
  const right = line.map((_, i) => offset(line, i, -1));
  for (const [x, y] of [...left, ...right.reverse()]) context.lineTo(x, y);
  context.closePath();
  // Round ends, drawn the same way round as the outline may run either way: non-zero winding fills both.
  for (const end of [first, last]) {
    context.moveTo(end.x + halfWidth(end), end.y);
    context.arc(end.x, end.y, halfWidth(end), 0, 2 * Math.PI);
  }
  context.fill();
  if (line.length > 2) drawBends(context, line);
}

/** At a sharp bend the outline is cut off on its outer side: a disc rounds it. */
function drawBends(context: CanvasRenderingContext2D, line: readonly Dot[]): void {
  for (let i = 1; i + 1 < line.length; i++) {
    const [a, b, c] = [line[i - 1]!, line[i]!, line[i + 1]!];
    const cosine = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
    if (cosine > 0.7 * distance(a, b) * distance(b, c)) continue;
    context.beginPath();
    context.arc(b.x, b.y, halfWidth(b), 0, 2 * Math.PI);
    context.fill();
  }
}

const halfWidth = ({ pressure }: Dot) => (WIDTH.least + (WIDTH.most - WIDTH.least) * pressure) / 2;

/** A point of the outline beside dot i; `side` 1 is the left one. */
function offset(line: readonly Dot[], i: number, side: 1 | -1): Vec2 {
  const a = line[Math.max(0, i - 1)]!;
  const b = line[Math.min(line.length - 1, i + 1)]!;
  const dot = line[i]!;
  const length = distance(a, b) || 1;
  const width = (side * halfWidth(dot)) / length;
  return [dot.x + (b.y - a.y) * width, dot.y - (b.x - a.x) * width];
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
    const b = other[Math.round((i * (other.length - 1)) / Math.max(1, left.length - 1))];
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
  writeNumber(context, index + 1, [x, y], colours);
}

function writeNumber(
  context: CanvasRenderingContext2D,
  number: number,
  [x, y]: Vec2,
  colours: InkColours,
): void {
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
  context.fillText(String(number), x, y + 0.5);
}
