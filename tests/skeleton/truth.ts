/** Fields by quadrature of the kernel's value and slope alone, in mm. */
import { type Kernel, type KernelParams, LineFrame } from '../../src/kernel/kernel.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { frameOf } from '../../src/skeleton/region.ts';
import type { PointSkel, PolygonSkel, SegmentSkel } from '../../src/skeleton/skels.ts';
import { integrate, withMarks } from '../fixtures/integrate.ts';

/** Value and gradient. */
export type Truth = readonly [value: number, x: number, y: number, z: number];

/** f and df/d(r²) at mm² */
interface Radial {
  f(r2: number): number;
  slope(r2: number): number;
  /** mm */
  readonly support: number;
}

function radial(kernel: Kernel, params: KernelParams): Radial {
  const unit = kernel.unit(params, 1);
  const n = params.n ?? 4;
  return {
    f: (r2) => kernel.value(r2 / unit ** 2, n),
    slope: (r2) => kernel.slope(r2 / unit ** 2, n) / unit ** 2,
    support: kernel.support * unit,
  };
}

export function truth(skel: PointSkel | SegmentSkel, kernel: Kernel, params: KernelParams, p: Vec3): Truth {
  const f = radial(kernel, params);
  if (skel.type === 'segment') return ofSegment(skel, f, p);
  const to = [p[0] - skel.at[0], p[1] - skel.at[1], p[2] - skel.at[2]] as const;
  const r2 = to[0] ** 2 + to[1] ** 2 + to[2] ** 2;
  const steep = 2 * skel.weight * f.slope(r2);
  return [skel.weight * f.f(r2), steep * to[0], steep * to[1], steep * to[2]];
}

/** Where an integrand that peaks within `near` of 0 changes its size. */
const decades = (near: number): number[] => {
  const away = Array.from({ length: 8 }, (_, i) => near * 5 ** i);
  return [0, ...away, ...away.map((mark) => -mark)];
};

function ofSegment({ a, b, weights }: SegmentSkel, f: Radial, p: Vec3): Truth {
  const d = [b[0] - a[0], b[1] - a[1], b[2] - a[2]] as const;
  const length = Math.hypot(...d);
  const u = [d[0] / length, d[1] / length, d[2] / length] as const;
  const to = [p[0] - a[0], p[1] - a[1], p[2] - a[2]] as const;
  const foot = to[0] * u[0] + to[1] * u[1] + to[2] * u[2];
  const perp = [to[0] - foot * u[0], to[1] - foot * u[1], to[2] - foot * u[2]] as const;
  const rho2 = perp[0] ** 2 + perp[1] ** 2 + perp[2] ** 2;
  const rim = Math.sqrt(Math.max(f.support ** 2 - rho2, 0));
  const near = Math.sqrt(rho2) + 1e-4 * length;
  const ends = withMarks(-foot, length - foot, [rim, -rim, ...decades(near)]);
  const weight = (t: number) => weights.reduceRight((sum, w) => sum * (t + foot) + w, 0);
  const across = integrate((t) => 2 * weight(t) * f.slope(rho2 + t * t), ends);
  const along = integrate((t) => -2 * t * weight(t) * f.slope(rho2 + t * t), ends);
  const gradient = (axis: 0 | 1 | 2) => across * perp[axis] + along * u[axis];
  return [integrate((t) => weight(t) * f.f(rho2 + t * t), ends), gradient(0), gradient(1), gradient(2)];
}

/**
 * The value of a polygon, slice by slice: each is the kernel's own integral over a line, which its own suite holds against
 * quadrature, and which shares nothing with the sums over edges.
 */
export function valueOfPolygon(
  { origin, loops, weight, ...axes }: PolygonSkel,
  { line, support, homogeneity, unit }: Kernel,
  params: KernelParams,
  p: Vec3,
): number {
  const { u, v, n } = frameOf(axes);
  const per = 1 / unit(params, 1);
  const to = [p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]] as const;
  const dot = (w: Vec3) => to[0] * w[0] + to[1] * w[1] + to[2] * w[2];
  const [px, py, z] = [dot(u), dot(v), dot(n)];
  const rim = Math.sqrt(Math.max(support ** 2 - (z * per) ** 2, 0)) / per;
  const heights = loops.flat().map(([, y]) => y - py);
  const [low, high] = [Math.min(...heights), Math.max(...heights)];
  const ends = withMarks(low, high, [...heights, rim, -rim, ...decades(Math.abs(z) + 0.01)]);
  const frame = Object.assign(new LineFrame(), { slopes: false, exponent: params.n ?? 4 });
  frame.weights[0] = 1;
  const out = new Float64Array(3);
  const slice = (y: number): number => {
    const xs = crossings(loops, y + py).map((x) => per * (x - px));
    frame.rho2 = (z * z + y * y) * per * per;
    let sum = 0;
    for (let i = 0; i + 1 < xs.length; i += 2) {
      const [alpha, beta] = [xs[i]!, xs[i + 1]!];
      if (beta <= alpha || frame.rho2 >= support ** 2) continue;
      line(Object.assign(frame, { alpha, beta, length: beta - alpha }), out);
      sum += out[0]!;
    }
    return sum;
  };
  return (weight * integrate(slice, ends)) / per ** (1 + homogeneity);
}

function crossings(loops: PolygonSkel['loops'], y: number): number[] {
  return loops
    .flatMap((loop) =>
      loop.flatMap(([x1, y1], i) => {
        const [x0, y0] = loop.at(i - 1)!;
        return y0 > y === y1 > y ? [] : [x0 + ((y - y0) / (y1 - y0)) * (x1 - x0)];
      }),
    )
    .sort((a, b) => a - b);
}
