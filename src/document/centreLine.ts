/** The line that the sections of a surface stand on, under its bends, and after some or all of them: what is seen of it is its axis (thesis 6.1). */
import { add3, cross3, scale3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Plane } from '../stroke/stroke.ts';
import { deform } from '../surface/deform.ts';
import type { Spine } from '../surface/sheet.ts';
import { sourceOf } from '../surface/source.ts';
import { curveOfStroke } from './curves.ts';
import type { SurfacePart } from './document.ts';
import { bendOf } from './sheets.ts';

type Part = Pick<SurfacePart, 'strokes' | 'bends' | 'brush'>;

interface Known {
  readonly bends: Part['bends'];
  readonly brush: Part['brush'];
  readonly count: number;
  readonly spine: Spine | null;
  readonly line: readonly Vec3[];
}

const lines = new WeakMap<Part['strokes'], readonly Known[]>();
/** of the same strokes: bends in the list, and those a pen tries */
const KEPT = 4;
/** points of a piece of the line at least, and of all of it about */
const STEPS = { least: 4, all: 96 } as const;

/** In the coordinates of the drawing plane, after the first `count` bends; null where strokes are too short. */
export const spineOf = (part: Part, count = part.bends.length): Spine | null => known(part, count).spine;

/** mm, in the part's own space, after the first `count` bends; nothing where strokes are too short. */
export const centreLine = (part: Part, count = part.bends.length): readonly Vec3[] => known(part, count).line;

function known(part: Part, count: number): Known {
  const { strokes, bends, brush } = part;
  const all = lines.get(strokes) ?? [];
  const found = all.find((other) => other.bends === bends && other.brush === brush && other.count === count);
  if (found) return found;
  const spine = derived(part, count);
  const plane = strokes[0]?.plane;
  const next: Known = { bends, brush, count, spine, line: spine && plane ? pointsOf(spine, plane) : [] };
  lines.set(strokes, [next, ...all].slice(0, KEPT));
  return next;
}

function derived(part: Part, count: number): Spine | null {
  const { strokes, brush, bends } = part;
  const curves = strokes.map((stroke) => curveOfStroke(stroke, brush)).filter((curve) => curve !== null);
  if (curves.length === 0 || curves.length < strokes.length) return null;
  const source = sourceOf({ ...brush, curves });
  if (!(source.length > 0)) return null;
  const bare = { rows: [], columns: { vs: [], joined: [] }, spine: source.spine };
  const inForce = bends.slice(0, count).filter(({ isOff }) => !isOff);
  return inForce.flatMap((bend) => bendOf(bend, strokes[0]!.plane, brush)).reduce(deform, bare).spine;
}

function pointsOf({ stops, at }: Spine, plane: Plane): Vec3[] {
  const us = stops.slice(1).flatMap((to, i) => {
    const from = stops[i]!;
    const count = Math.max(STEPS.least, Math.ceil(STEPS.all * (to - from)));
    return Array.from({ length: count }, (_, k) => from + ((to - from) * k) / count);
  });
  return [...us, 1].map((u) => outOf(plane, at(u, u < 1 ? 1 : -1).centre));
}

/** From the coordinates of a drawing plane. */
export function outOf({ origin, x, y }: Plane, p: Vec3): Vec3 {
  return add3(origin, turnedOut({ x, y }, p));
}

/** A direction. */
export const turnedOut = ({ x, y }: Pick<Plane, 'x' | 'y'>, [a, b, c]: Vec3): Vec3 =>
  add3(scale3(x, a), add3(scale3(y, b), scale3(cross3(x, y), c)));
