/**
 * A planar region made ready for sums over its edges: an orthonormal frame, and edges in units of a kernel from the
 * middle of the region, so that raw coordinates are subtracted once, in float64.
 */
import { cross2 } from '../math/tuple.ts';
import { type Vec2, type Vec3, vec3 } from '../math/vec.ts';
import { checkNumbers, checkPlaces } from './binding.ts';
import { FieldError } from './skeleton.ts';
import type { PolygonSkel } from './skels.ts';
import { type Winding, windingOf } from './winding.ts';

export interface Frame {
  readonly u: Vec3;
  readonly v: Vec3;
  /** u × v */
  readonly n: Vec3;
}

/** u normalised, v made orthogonal to it; FieldError where they do not span a plane. */
export function frameOf({ u, v }: Pick<PolygonSkel, 'u' | 'v'>): Frame {
  const first = unitVector(u);
  const along = vec3.dot(first, unitVector(v));
  const rest: [number, number, number] = [0, 0, 0];
  vec3.scaleAndAdd(rest, unitVector(v), first, -along);
  if (!(vec3.dot(rest, rest) > 1e-20)) throw new FieldError('the axes of a polygon must span a plane');
  const second = unitVector(rest);
  const normal: [number, number, number] = [0, 0, 0];
  vec3.cross(normal, first, second);
  return { u: first, v: second, n: normal };
}

function unitVector(v: Vec3): Vec3 {
  const most = Math.max(Math.abs(v[0]), Math.abs(v[1]), Math.abs(v[2]));
  if (!(most > 0)) throw new FieldError('the axes of a polygon must have a length above 0');
  const [x, y, z] = [v[0] / most, v[1] / most, v[2] / most];
  const length = Math.sqrt(x * x + y * y + z * z);
  return [x / length, y / length, z / length];
}

export interface Region extends Frame, Winding {
  /** mm, in space */
  readonly middle: Vec3;
  /** mm, of the circle around `middle` that holds the region */
  readonly radius: number;
  /** mm from `middle`: outer loop counter-clockwise, holes clockwise, no edge without length */
  readonly loops: readonly (readonly Vec2[])[];
}

export function regionOf(skel: PolygonSkel): Region {
  checkPlaces('the frame of a polygon', [...skel.origin, ...skel.u, ...skel.v]);
  checkNumbers('the weight of a polygon', [skel.weight]);
  checkPlaces('the vertices of a polygon', skel.loops.flat(2));
  if (skel.loops.length === 0) throw new FieldError('a polygon has at least one loop');
  const frame = frameOf(skel);
  const outer = skel.loops[0]!;
  const centre = middleOf(outer);
  const loops = skel.loops.map((loop, i) => turned(loop, centre, i));
  const area = loops.reduce((sum, loop) => sum + areaOf(loop), 0);
  if (!(area > 0)) throw new FieldError('the holes of a polygon must be smaller than its outline');
  const radius = Math.sqrt(Math.max(...loops.flat().map(([x, y]) => x * x + y * y)));
  const middle: [number, number, number] = [0, 0, 0];
  vec3.scaleAndAdd(middle, skel.origin, frame.u, centre[0]);
  vec3.scaleAndAdd(middle, middle, frame.v, centre[1]);
  return { ...frame, middle, radius, loops, ...windingOf(loops, area) };
}

function middleOf(loop: readonly Vec2[]): Vec2 {
  if (loop.length < 3)
    throw new FieldError(`a loop of a polygon has at least 3 vertices, found ${loop.length}`);
  const of = (axis: 0 | 1) => {
    const values = loop.map((vertex) => vertex[axis]);
    return 0.5 * (Math.min(...values) + Math.max(...values));
  };
  return [of(0), of(1)];
}

/** About the middle, repeated vertices dropped, the right way round: outlines and holes may come either way. */
function turned(loop: readonly Vec2[], [cx, cy]: Vec2, index: number): readonly Vec2[] {
  const moved = loop
    .filter(([x, y], i) => {
      const [px, py] = loop.at(i - 1)!;
      return x !== px || y !== py;
    })
    .map(([x, y]): Vec2 => [x - cx, y - cy]);
  const area = areaOf(moved);
  const extent = moved.reduce((most, [x, y]) => Math.max(most, x * x + y * y), 0);
  if (moved.length < 3 || !(Math.abs(area) > 1e-12 * extent)) {
    throw new FieldError(`loop ${index} of a polygon ${hasLobes(moved, extent) ? CROSSED : 'has no area'}`);
  }
  return area > 0 === (index === 0) ? moved : [...moved].reverse();
}

const CROSSED = 'crosses itself, and goes round as much one way as the other: nothing is left';

/** Without area, but not all on one line. */
function hasLobes(loop: readonly Vec2[], extent: number): boolean {
  const fan = loop.reduce((sum, p, i) => sum + Math.abs(cross2(loop.at(i - 1)!, p)), 0);
  return loop.length > 3 && fan > 1e-12 * extent;
}

/** mm², above 0 counter-clockwise. */
export function areaOf(loop: readonly Vec2[]): number {
  return loop.reduce((sum, [x, y], i) => {
    const [px, py] = loop.at(i - 1)!;
    return sum + 0.5 * (px * y - py * x);
  }, 0);
}
