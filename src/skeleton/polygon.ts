/**
 * A planar region, concave and with holes: a sum over its edges (Green; docs/fields.md), no triangles, no clipping.
 *
 * Zhu et al. 2011 §3.3 need the projection's winding number, sorted intersections with a disc (at most sixteen), and axes
 * along the edges. Here each edge brings its whole share, angles included, so that points exactly over an edge or a vertex
 * (snapped sketches) are as good as any. Only far away does a residue of 1e-16 of the plate's field stay, which a circle
 * around the region cuts off for kernels with a support.
 */
import { EdgeFrame, type Kernel, type KernelParams } from '../kernel/kernel.ts';
import { pow } from '../math/pow.ts';
import { TAU } from '../math/trig.ts';
import type { Vec3 } from '../math/vec.ts';
import { checkedParams, reach, whole } from './binding.ts';
import { boxOf } from './boxOf.ts';
import { CIRCLE, NEXT, outlineOf, STRIDE } from './outline.ts';
import { plateDistance } from './plateDistance.ts';
import { type Region, regionOf } from './region.ts';
import { FieldError, type FieldValue, type Skeleton, type SkelField } from './skeleton.ts';
import type { PolygonSkel } from './skels.ts';
import { Spreader } from './spread.ts';

export const polygon: Skeleton<PolygonSkel> = { name: 'polygon', bind };

/** kernel units; farther away nothing is left but what sums over edges do not cancel, and their squares overflow */
const FARTHEST = 1e30;
/** so much farther than rounding leaves doubt */
const OVER = 1.0001;
/**
 * What sums over edges leave, in parts of the largest field at the point's height, and from afar of the field times the distance;
 * of kernels whose plane is infinite, in parts of what edges come to. Panels are good to 1e-12 of it; singular kernels, whose
 * largest is large, have none that are worse than 1e-14.
 */
const RESIDUE = { wide: 4e-12, singular: 1e-13 };

function bind(skel: PolygonSkel, kernel: Kernel, params: KernelParams): SkelField {
  const checked = checkedParams(kernel, params);
  const { edge } = kernel;
  if (!edge) throw new FieldError(`polygons have no field of the kernel ${kernel.name}`);
  const region = regionOf(skel);
  const { u, v, n, middle } = region;
  const unit = kernel.unit(checked, region.radius);
  const per = 1 / unit;
  const edges = outlineOf(region, per, kernel.support);
  const factor = skel.weight * whole(unit, 2 + kernel.homogeneity);
  const extent = {
    dimension: 2,
    size: region.covered * per * per,
    turns: region.turns,
    most: Math.abs(factor),
    sign: region.isOneWay ? Math.sign(factor) : 0,
    evenness: 1,
  } as const;
  const frame = new EdgeFrame();
  frame.exponent = checked.n ?? frame.exponent;
  frame.floor2 = kernel.floor2.plate;
  const integral = new Float64Array(3);
  const { support } = kernel;
  const size = region.radius * per;
  const beyond = size + Math.min(support, FARTHEST);
  // value and gradient in the frame of the plane, kernel units
  const sum = new Float64Array(4);
  const least = Math.sqrt(frame.floor2);
  const residue = least > 0 ? RESIDUE.singular : RESIDUE.wide;

  const integrate = (x: number, y: number, z: number, slopes: boolean): void => {
    const vx = (x - middle[0]) * per;
    const vy = (y - middle[1]) * per;
    const vz = (z - middle[2]) * per;
    sum.fill(0);
    if (vx * vx + vy * vy + vz * vz >= beyond * beyond) return;
    const qx = vx * u[0] + vy * u[1] + vz * u[2];
    const qy = vx * v[0] + vy * v[1] + vz * v[2];
    frame.z = vx * n[0] + vy * n[1] + vz * n[2];
    if (Math.abs(frame.z) >= support) return;
    frame.slopes = slopes;
    const seenTo = Math.sqrt(support * support - frame.z * frame.z);
    let next = STRIDE;
    for (let i = 0; i < edges.length; i = next) {
      const end = edges[i + NEXT]!;
      const isEdge = end === i + STRIDE;
      next = isEdge || isBeyond(edges, i, qx, qy, seenTo) ? end : i + STRIDE;
      if (next !== end || edges[i + 6] === 0) continue;
      seen(frame, edges, i, qx, qy);
      edge(frame, integral);
      sum[0] = sum[0]! + integral[0]!;
      if (!slopes) continue;
      sum[1] = sum[1]! + integral[1]! * edges[i + 5]!;
      sum[2] = sum[2]! - integral[1]! * edges[i + 4]!;
      sum[3] = sum[3]! + integral[2]!;
    }
  };

  const isSlow = (kernel.wholePlane?.(1, frame.exponent) ?? Infinity) === Infinity;
  const growth = kernel.homogeneity === 0 ? Math.max(2 - frame.exponent, 0) : 0;
  const left = (height: number, distance: number) => {
    if (isSlow) return residue * TAU * region.turns * extent.most * pow(1 + distance, growth);
    const near = Math.max(distance - size, height);
    return residue * (spreader.most(height * height) + (1 + distance / size) * spreader.most(near * near));
  };
  const spreader = new Spreader(kernel, frame.exponent, extent, per, ({ x, y, z, radius }, sight) => {
    const vx = (x - middle[0]) * per;
    const vy = (y - middle[1]) * per;
    const vz = (z - middle[2]) * per;
    const qx = vx * u[0] + vy * u[1] + vz * u[2];
    const qy = vx * v[0] + vy * v[1] + vz * v[2];
    const height = Math.abs(vx * n[0] + vy * n[1] + vz * n[2]);
    const low = Math.max(height - radius * per, 0);
    const far = Math.max(Math.sqrt(vx * vx + vy * vy + vz * vz) - radius * per, 0);
    // beyond the circle nothing at all is left
    const isBeyond = far > OVER * beyond || low > OVER * support;
    const across = isBeyond ? Math.max(Math.sqrt(qx * qx + qy * qy) - size, 0) : plateDistance(edges, qx, qy);
    sight.distance = Math.sqrt(across * across + height * height);
    sight.isClear = least === 0 || low > least;
    sight.slack = isBeyond ? 0 : left(low, far);
  });
  const field: SkelField = {
    box: boxOf(cornersOf(region)),
    offset: (threshold) => (factor === 0 ? 0 : unit * reach((r2) => spreader.most(r2), threshold, support)),
    value(x, y, z) {
      integrate(x, y, z, false);
      return factor * sum[0]!;
    },
    add(x: number, y: number, z: number, scale: number, out: FieldValue): void {
      integrate(x, y, z, true);
      out[0] = out[0]! + scale * factor * sum[0]!;
      const steep = scale * factor * per;
      for (let axis = 0; axis < 3; axis++) {
        const slope = sum[1]! * u[axis]! + sum[2]! * v[axis]! + sum[3]! * n[axis]!;
        out[axis + 1] = out[axis + 1]! + steep * slope;
      }
    },
    spread(ball, scale, out) {
      spreader.add(field, ball, scale, out);
    },
    missed: (ball, most) => spreader.missed(ball, most),
    isCubic: false,
    ahead: (ball, scale, out) => spreader.ahead(field, ball, scale, out),
    apart: () => Infinity,
    standIn: (ball, scale, out) => spreader.standIn(field, ball, scale, out),
  };
  return field;
}

/** Fills the frame for the edge at `i`, seen from the point over (qx, qy): everything from the nearer end. */
function seen(frame: EdgeFrame, edges: Float64Array, i: number, qx: number, qy: number): void {
  const ux = edges[i + 4]!;
  const uy = edges[i + 5]!;
  const length = edges[i + 6]!;
  const x0 = edges[i]! - qx;
  const y0 = edges[i + 1]! - qy;
  const x1 = edges[i + 2]! - qx;
  const y1 = edges[i + 3]! - qy;
  const alpha = x0 * ux + y0 * uy;
  const beta = x1 * ux + y1 * uy;
  frame.length = length;
  if (alpha + beta > 0) {
    frame.d = x0 * uy - y0 * ux;
    frame.alpha = alpha;
    frame.beta = alpha + length;
  } else {
    frame.d = x1 * uy - y1 * ux;
    frame.alpha = beta - length;
    frame.beta = beta;
  }
}

/** Whether all that the chord at `i` stands for is farther from (qx, qy) than `reach`. */
function isBeyond(edges: Float64Array, i: number, qx: number, qy: number, reach: number): boolean {
  const x = edges[i + CIRCLE]! - qx;
  const y = edges[i + CIRCLE + 1]! - qy;
  const far = edges[i + CIRCLE + 2]! + reach;
  return x * x + y * y >= far * far;
}

function cornersOf({ loops, middle, u, v }: Region): Vec3[] {
  return loops.flat().map(([x, y]): Vec3 => {
    const along = (axis: 0 | 1 | 2) => middle[axis] + x * u[axis] + y * v[axis];
    return [along(0), along(1), along(2)];
  });
}
