/**
 * Skels as the GPU reads them: what src/skeleton binds, in float32. What can be done once is done here in float64 and
 * rounded last. Positions stay in mm (the shader subtracts before it scales, so that neither 1e±6 mm nor an offset of
 * 1e3 radii costs digits); weights become those of kernel units, so that the integral is the field.
 */
import type { Kernel, KernelParams } from '../kernel/kernel.ts';
import type { RecordLayout, RecordValue } from '../math/record.ts';
import { type Vec2, type Vec3, vec3 } from '../math/vec.ts';
import { checkedParams, SHORTEST, whole } from '../skeleton/binding.ts';
import { regionOf } from '../skeleton/region.ts';
import type { PointSkel, PolygonSkel, SegmentSkel, Skel } from '../skeleton/skels.ts';
import type { Heap } from './heap.ts';
import { EDGE, POINT, POLYGON, SEGMENT } from './structs.ts';

/** A skel with the kernel that it is convolved with. */
export interface KernelSkel {
  readonly skel: Skel;
  readonly kernel: Kernel;
  readonly params: KernelParams;
}

type Row<L> = L extends RecordLayout<infer M> ? RecordValue<M> : never;

/** 1/r⁵ has a slope of r⁻⁷: a float32 as long as r² is above this, which is 1e-5 of the radius where a point is 1. */
const POINT_FLOOR2 = 2 ** -33;
/** Its square is a float32 too. */
const FAR = 1e19;

/** Adds the skel's record, and those of its edges; returns where. Throws FieldError for what `bindSkel` refuses. */
export function addSkel(heap: Heap, { skel, kernel, params }: KernelSkel): number {
  const checked = checkedParams(kernel, params);
  switch (skel.type) {
    case 'point':
      return heap.add(POINT, pointRecord(skel, kernel, checked));
    case 'segment':
      return heap.add(SEGMENT, segmentRecord(skel, kernel, checked));
    case 'polygon':
      return addPolygon(heap, skel, kernel, checked);
  }
}

const kernelMembers = (params: KernelParams, unit: number, floor2: number) => {
  return { exponent: params.n ?? 4, floor2, scale: 1 / unit };
};

function pointRecord(skel: PointSkel, kernel: Kernel, params: KernelParams): Row<typeof POINT> {
  const { homogeneity } = kernel;
  // without a width: the radius where a lone point is 1
  const size = homogeneity === 0 || skel.weight === 0 ? 1 : Math.abs(skel.weight) ** (-1 / homogeneity);
  const unit = kernel.unit(params, size);
  const floor2 = homogeneity === 0 ? 0 : POINT_FLOOR2;
  const members = kernelMembers(params, unit, floor2);
  return { at: skel.at, weight: skel.weight * whole(unit, homogeneity), ...members };
}

function segmentRecord(skel: SegmentSkel, kernel: Kernel, params: KernelParams): Row<typeof SEGMENT> {
  // Length and direction belong to the rounded ends, else the two ends would tell different places of one point.
  const a = rounded(skel.a);
  const b = rounded(skel.b);
  const apart = vec3.distance(a, b);
  const mm = apart < SHORTEST ? 0 : apart;
  const unit = kernel.unit(params, mm || 1);
  // An integral over nothing: any direction, no weight.
  const factor = mm > 0 ? whole(unit, 1 + kernel.homogeneity) : 0;
  return {
    a,
    b,
    length: (mm || 1) / unit,
    degree: skel.weights.length - 1,
    u: mm > 0 ? [0, 1, 2].map((axis) => (b[axis]! - a[axis]!) / mm) : [1, 0, 0],
    weights: [0, 1, 2, 3].map((k) => (skel.weights[k] ?? 0) * factor * whole(unit, k)),
    ...kernelMembers(params, unit, kernel.floor2.line),
  };
}

function addPolygon(heap: Heap, skel: PolygonSkel, kernel: Kernel, params: KernelParams): number {
  const { u, v, n, middle, radius, loops } = regionOf(skel);
  const unit = kernel.unit(params, radius);
  // What rounding moves the middle by goes into the coordinates: they are small and keep it.
  const origin = rounded(middle);
  const rest: [number, number, number] = [0, 0, 0];
  vec3.subtract(rest, middle, origin);
  const [dx, dy] = [vec3.dot(rest, u), vec3.dot(rest, v)];
  const first = heap.next;
  for (const loop of loops) {
    const moved = loop.map(([x, y]): Vec2 => [Math.fround((x + dx) / unit), Math.fround((y + dy) / unit)]);
    moved.forEach((end, i) => {
      heap.add(EDGE, edgeRecord(moved.at(i - 1)!, end));
    });
  }
  return heap.add(POLYGON, {
    origin,
    lift: vec3.dot(rest, n) / unit,
    u,
    v,
    n,
    weight: skel.weight * whole(unit, 2 + kernel.homogeneity),
    // rounding has moved it a little, and culling has to be on the safe side
    radius: (1.001 * radius) / unit,
    support: Math.min(kernel.support, FAR),
    first,
    end: heap.next,
    ...kernelMembers(params, unit, kernel.floor2.plate),
  });
}

function edgeRecord(start: Vec2, end: Vec2): Row<typeof EDGE> {
  const [dx, dy] = [end[0] - start[0], end[1] - start[1]];
  const length = Math.hypot(dx, dy);
  // Vertices that float32 cannot tell apart leave an edge without length, whose share is 0.
  return { start, end, u: length > 0 ? [dx / length, dy / length] : [1, 0], length };
}

const rounded = (p: Vec3): Vec3 => [Math.fround(p[0]), Math.fround(p[1]), Math.fround(p[2])];
