/** What every kernel owes, judged by quadrature of its value alone. A new kernel is tested by being registered. */
import { describe, expect, it } from 'vitest';
import { kernelNamed, kernels } from '../../src/kernel/index.ts';
import { LineFrame } from '../../src/kernel/kernel.ts';
import { integrate, withMarks } from '../fixtures/integrate.ts';
import { random } from '../fixtures/random.ts';
import { variants } from './variants.ts';

const SEED = 7;

/** rho, alpha, length: on the axis, beyond an end, at an end, far, long, short. */
const NASTY: readonly (readonly [rho: number, alpha: number, length: number])[] = [
  [0.3, -0.5, 1],
  [0, 0.4, 1],
  [0, 1e-3, 1],
  [1e-4, 0.7, 1],
  [1e-3, -1.2, 1],
  [0.5, 0, 1],
  [0.5, -1, 1],
  [0.8, -2000, 4000],
  [1e-3, -50, 60],
  [1e-3, 0.05, 60],
  [0.4, 30, 25],
  [2, -1e-6, 2e-6],
  [50, -3, 2],
  [0.9, 400, 3],
];

function frames(): LineFrame[] {
  const next = random(SEED);
  const spread = () => 10 ** (3 * next() - 2);
  const more = Array.from({ length: 40 }, () => {
    const length = spread();
    return [spread(), (2.4 * next() - 1.7) * length, length] as const;
  });
  return [...NASTY, ...more].flatMap(([rho, alpha, length], i) => {
    const frame = new LineFrame();
    Object.assign(frame, { rho2: rho * rho, alpha, beta: alpha + length, length, degree: i % 4 });
    for (let k = 0; k <= i % 4; k++) frame.weights[k] = (next() - 0.3) / length ** k;
    return frame;
  });
}

const weightAt = ({ weights: w }: LineFrame, t: number) => w[0]! + t * (w[1]! + t * (w[2]! + t * w[3]!));

describe.each(variants)('the kernel $title', ({ kernel, exponent }) => {
  const value = (r2: number) => kernel.value(r2, exponent);
  const slope = (r2: number) => kernel.slope(r2, exponent);
  const edge = kernel.support ** 2;

  it('falls, and its slope is the difference of its value', () => {
    for (const r2 of [1e-4, 0.01, 0.3, 0.9, 1.7, 40, 1e4]) {
      const h = 1e-4 * r2;
      const difference =
        (8 * (value(r2 + h) - value(r2 - h)) - (value(r2 + 2 * h) - value(r2 - 2 * h))) / (12 * h);
      if (Math.abs(r2 - edge) < 2 * h) continue;
      expect(Math.abs(slope(r2) - difference)).toBeLessThanOrEqual(
        1e-9 * Math.abs(slope(r2)) + (1e-11 * value(r2)) / r2,
      );
      expect(slope(r2)).toBeLessThanOrEqual(0);
    }
  });

  it('is nothing beyond its support, and something within', () => {
    expect(value(edge < Infinity ? edge : 1e300)).toBeLessThan(1e-100 ** (exponent < 4 ? 0.5 : 1));
    expect(value(0.9 * Math.min(edge, 100))).toBeGreaterThan(0);
    expect(kernel.homogeneity === 0 ? value(0) : 1).toBe(1);
  });

  it('scales as its homogeneity says', () => {
    if (kernel.homogeneity === 0) return;
    for (const c of [0.01, 3, 1e4]) {
      expect(value(c * c * 0.7) / (c ** kernel.homogeneity * value(0.7))).toBeCloseTo(1, 13);
    }
  });

  it(`integrates lines as quadrature does, on the axis, beyond ends, far and long (seed ${SEED})`, () => {
    const out = new Float64Array(3);
    const short = new Float64Array(3);
    for (const frame of frames()) {
      const { rho2, alpha, beta } = frame;
      frame.floor2 = kernel.floor2.line;
      // singular on the axis itself
      if (kernel.homogeneity < 0 && alpha <= 0 && beta >= 0 && rho2 === 0) continue;
      const rim = Math.sqrt(Math.max(edge - rho2, 0));
      const near = Math.sqrt(rho2) + 1e-3;
      // each interval a few times as far from the peak as it is wide
      const away = [0, ...Array.from({ length: 7 }, (_, i) => near * 5 ** i)];
      const marks = [rim, -rim, ...away, ...away.map((mark) => -mark)];
      const ends = withMarks(alpha, beta, marks);
      const over = (f: (tau: number) => number) => integrate(f, ends);
      const truth = [
        over((t) => weightAt(frame, t - alpha) * value(rho2 + t * t)),
        over((t) => weightAt(frame, t - alpha) * slope(rho2 + t * t)),
        over((t) => -2 * t * weightAt(frame, t - alpha) * slope(rho2 + t * t)),
      ];
      const scale = [
        over((t) => Math.abs(weightAt(frame, t - alpha)) * value(rho2 + t * t)),
        over((t) => Math.abs(weightAt(frame, t - alpha) * slope(rho2 + t * t))),
        over((t) => Math.abs(2 * t * weightAt(frame, t - alpha) * slope(rho2 + t * t))),
      ];
      kernel.line(Object.assign(frame, { exponent, slopes: true }), out);
      kernel.line(Object.assign(frame, { slopes: false }), short);
      expect(short[0]).toBe(out[0]);
      for (let i = 0; i < 3; i++) {
        const miss = Math.abs(out[i]! - truth[i]!) / (scale[i]! || 1);
        if (!(miss < 1e-10)) expect(miss, `${i} of ${JSON.stringify({ ...frame })}`).toBeLessThan(1e-10);
      }
    }
  });

  it('integrates whole lines and planes', () => {
    for (const r2 of [0.01, 0.4, 0.99, 7, 400]) {
      const r = Math.sqrt(r2);
      if (kernel.wholeLine) {
        // τ = r sinh x; to where nothing is left, also for exponents near 1
        const rim = Math.asinh(Math.sqrt(Math.max(edge - r2, 0)) / r);
        const ends = withMarks(0, Math.min(rim, 340), [1, 2, 4, 8, 16, 32, 64, 128]);
        const f = (x: number) => 2 * r * Math.cosh(x) * value(r2 * Math.cosh(x) ** 2);
        const truth = integrate(f, ends);
        expect(Math.abs(kernel.wholeLine(r2, exponent) - truth)).toBeLessThanOrEqual(1e-12 * truth);
      }
      const plane = kernel.wholePlane?.(r2, exponent) ?? Infinity;
      if (plane < Infinity) {
        const f = (x: number) => Math.PI * value(Math.exp(x)) * Math.exp(x);
        const ends = withMarks(
          Math.log(r2),
          Math.min(Math.log(edge), 300),
          [-2, 0, 1, 2, 4, 8, 16, 32, 64, 128],
        );
        const truth = r2 < edge ? integrate(f, ends) : 0;
        expect(Math.abs(plane - truth)).toBeLessThanOrEqual(1e-12 * truth);
      }
    }
  });

  it('is finite on the skel', () => {
    const out = new Float64Array(3);
    for (const alpha of [-1, -0.5, 0]) {
      const frame = Object.assign(new LineFrame(), { alpha, beta: alpha + 1, length: 1, exponent });
      frame.floor2 = kernel.floor2.line;
      frame.weights[0] = 1;
      kernel.line(frame, out);
      expect([...out].every(Number.isFinite)).toBe(true);
      expect(out[0]).toBeGreaterThan(0);
    }
  });
});

describe('the registry', () => {
  it('knows each by its name', () => {
    expect(new Set(kernels.map(({ name }) => name)).size).toBe(kernels.length);
    for (const kernel of kernels) expect(kernelNamed(kernel.name)).toBe(kernel);
    expect(kernelNamed('metaball')).toBeUndefined();
  });
});
