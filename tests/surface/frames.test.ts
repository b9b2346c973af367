import { describe, expect, test } from 'vitest';
import { cross3, dot3, length3, scale3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { type Frame, rotationMinimizingFrames, type Station } from '../../src/surface/frames.ts';

type Path = (t: number) => Vec3;

const helix: Path = (t) => [3 * Math.cos(9 * t), 3 * Math.sin(9 * t), 4 * t];
const trefoil: Path = (t) => {
  const a = 2 * Math.PI * t;
  return [Math.sin(a) + 2 * Math.sin(2 * a), Math.cos(a) - 2 * Math.cos(2 * a), -Math.sin(3 * a)];
};

function unit(v: Vec3): Vec3 {
  return scale3(v, 1 / length3(v));
}

function tangent(path: Path, t: number): Vec3 {
  return unit(sub3(path(t + 1e-5), path(t - 1e-5)));
}

function stations(path: Path, count: number, closed: boolean): Station[] {
  return Array.from({ length: count }, (_, i) => {
    const t = i / (closed ? count : count - 1);
    return { point: path(t), tangent: tangent(path, t) };
  });
}

/** r′ = −(t′·r) t, the equation of rotation minimizing normals, by Heun's method in fine steps. */
function integrate(path: Path, start: Vec3, steps: number): Vec3 {
  let r = start;
  for (let i = 0; i < steps; i++) {
    const [t, u] = [tangent(path, i / steps), tangent(path, (i + 1) / steps)];
    const turn = sub3(u, t);
    const guess = sub3(r, scale3(t, dot3(turn, r)));
    const first = scale3(t, dot3(turn, r));
    const second = scale3(u, dot3(turn, guess));
    r = sub3(r, scale3([first[0] + second[0], first[1] + second[1], first[2] + second[2]], 0.5));
    r = unit(sub3(r, scale3(u, dot3(r, u))));
  }
  return r;
}

/** The turn about the tangent, to third order in the step. */
function turnBetween(a: Frame, b: Frame): number {
  const change = sub3(b.normal, a.normal);
  return (dot3(change, a.binormal) + dot3(change, b.binormal)) / 2;
}

/** The sum of turns about the tangent from station to station, radians: what is left beside the shortest turn. */
function twist(frames: readonly Frame[], closed: boolean): number {
  let sum = 0;
  frames.forEach((frame, i) => {
    const following = frames[i + 1] ?? (closed ? frames[0]! : null);
    if (following) sum += turnBetween(frame, following);
  });
  return sum;
}

function frenet(path: Path, count: number, closed: boolean): Frame[] {
  return stations(path, count, closed).map(({ tangent: t }, i) => {
    const at = i / (closed ? count : count - 1);
    const change = sub3(tangent(path, at + 1e-4), tangent(path, at - 1e-4));
    const normal = unit(sub3(change, scale3(t, dot3(change, t))));
    return { tangent: t, normal, binormal: cross3(t, normal) };
  });
}

describe('rotation minimizing frames', () => {
  test('are right-handed and orthonormal', () => {
    for (const [path, closed] of [
      [helix, false],
      [trefoil, true],
    ] as const) {
      for (const f of rotationMinimizingFrames(stations(path, 50, closed), [0, 0, 1], closed)) {
        expect(length3(f.normal)).toBeCloseTo(1, 12);
        expect(dot3(f.normal, f.tangent)).toBeCloseTo(0, 12);
        expect(length3(sub3(cross3(f.tangent, f.normal), f.binormal))).toBeLessThan(1e-12);
      }
    }
  });

  test('on a helix match the differential equation, with an error that falls with the fourth power', () => {
    const start = rotationMinimizingFrames(stations(helix, 2, false), [0, 0, 1], false)[0]!.normal;
    const truth = integrate(helix, start, 20_000);
    const error = (count: number): number => {
      const frames = rotationMinimizingFrames(stations(helix, count + 1, false), [0, 0, 1], false);
      return length3(sub3(frames[count]!.normal, truth));
    };
    expect(error(64)).toBeLessThan(1e-4);
    expect(error(16) / error(32)).toBeGreaterThan(12);
  });

  test('on a helix turn less than Frenet frames', () => {
    const frames = rotationMinimizingFrames(stations(helix, 200, false), [0, 0, 1], false);
    const torsion = (9 * 4 * Math.hypot(27, 4)) / (27 ** 2 + 4 ** 2);
    expect(Math.abs(twist(frenet(helix, 200, false), false))).toBeCloseTo(torsion, 1);
    expect(Math.abs(twist(frames, false))).toBeLessThan(1e-3);
  });

  test('on a closed knot: no seam, the rest spread evenly, less twist than Frenet', () => {
    const count = 400;
    const frames = rotationMinimizingFrames(stations(trefoil, count, true), [0, 0, 1], true);
    const open = rotationMinimizingFrames(stations(trefoil, count, true), [0, 0, 1], false);
    const steps = frames.map((f, i) => {
      const following = frames[(i + 1) % count]!;
      return turnBetween(f, following) / length3(sub3(trefoil((i + 1) / count), trefoil(i / count)));
    });
    // the seam's step is like all others
    for (const step of steps) expect(Math.abs(step - steps[7]!)).toBeLessThan(0.02 * Math.abs(steps[7]!));
    expect(Math.abs(twist(open, false))).toBeLessThan(1e-2);
    expect(Math.abs(twist(frames, true))).toBeLessThanOrEqual(Math.PI);
    expect(Math.abs(twist(frames, true))).toBeLessThan(Math.abs(twist(frenet(trefoil, count, true), true)));
  });

  test('in a plane keep its normal, round corners too', () => {
    const path = (
      [
        [0, 0],
        [1, 0],
        [1, 0],
        [1, 1],
        [1, 1],
      ] as const
    ).map(([x, y], i): Station => {
      const tangents: Vec3[] = [
        [1, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
        [0, 1, 0],
        [0, -1, 0],
      ];
      return { point: [x, y, 0], tangent: tangents[i]! };
    });
    for (const closed of [false, true]) {
      for (const f of rotationMinimizingFrames(path, [0, 0, 1], closed)) expect(f.normal).toEqual([0, 0, 1]);
    }
  });

  test('a start along the tangent is replaced by some perpendicular', () => {
    const [first] = rotationMinimizingFrames([{ point: [0, 0, 0], tangent: [0, 0, 1] }], [0, 0, 1], false);
    expect(dot3(first!.normal, [0, 0, 1])).toBe(0);
    expect(length3(first!.normal)).toBeCloseTo(1, 12);
  });
});
