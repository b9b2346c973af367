import { describe, expect, test } from 'vitest';
import { cross3, dot3, length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec2, Vec3 } from '../../src/math/vec.ts';
import { functionCurve, polylineCurve } from '../../src/stroke/arcLength.ts';
import { bezierCurve } from '../../src/stroke/bezierCurve.ts';
import type { Curve } from '../../src/stroke/curve.ts';
import type { Plane } from '../../src/stroke/stroke.ts';
import { type BendInput, deform, isBendable } from '../../src/surface/deform.ts';
import type { Sheet } from '../../src/surface/sheet.ts';
import { sideView } from '../../src/surface/sideView.ts';
import { line, reversed } from './curves.ts';
import {
  arc,
  type Centre,
  cubic,
  ellipses,
  evenly,
  normalIn,
  pointIn,
  pointOf,
  upright,
  wavy,
} from './sheets.ts';

/** from the right: x of the view is −z, y is up */
const SIDE: Plane = { origin: [0, 0, 0], x: [0, 0, -1], y: [0, 1, 0] };
const FRONT: Plane = { origin: [3, -4, 5], x: [1, 0, 0], y: [0, 1, 0] };
const ABOVE: Plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 0, -1] };
/** a view from the side, `tilt` radians off, and rolled */
function tilted(tilt: number, roll = 0.3): Plane {
  const [c, s] = [Math.cos(tilt), Math.sin(tilt)];
  const [right, up]: [Vec3, Vec3] = [
    [s, 0, -c],
    [0, 1, 0],
  ];
  const [a, b] = [Math.cos(roll), Math.sin(roll)];
  const mixed = (p: Vec3, q: Vec3, x: number, y: number): Vec3 => [
    x * p[0] + y * q[0],
    x * p[1] + y * q[1],
    x * p[2] + y * q[2],
  ];
  return { origin: [1, 2, 3], x: mixed(right, up, a, b), y: mixed(right, up, -b, a) };
}

const radius = (u: number): number => 8 + 3 * Math.sin(5 * u);
const US = evenly(40);
const VS = evenly(12);

/** By arc length to 1e-13 or so, with exact tangents. */
const bezier = (...points: Vec2[]): Curve => bezierCurve([[points]], false, false, () => 0.5);
const BEND: readonly [Vec2, Vec2, Vec2, Vec2] = [
  [-20, 0],
  [70, 20],
  [-60, 60],
  [10, 110],
];

/** What a person draws who changes nothing: l(u) of that way in the view. */
function drawnOver(points: readonly Vec2[], plane: Plane): Curve {
  const view = sideView(plane);
  return bezier(...points.map(([x, y]) => view.point([x, y, 0])));
}

/** The arc with its exact length. */
function exactArc(centre: Vec2, size: number, from: number, turn: number): Curve {
  const at = (u: number) => from + turn * Math.min(Math.max(u, 0), 1);
  return {
    closed: false,
    length: size * Math.abs(turn),
    corners: [],
    point: (u) => [centre[0] + size * Math.cos(at(u)), centre[1] + size * Math.sin(at(u))],
    tangent: (u) => [-Math.sign(turn) * Math.sin(at(u)), Math.sign(turn) * Math.cos(at(u))],
    pressure: () => 0.5,
  };
}

function largest(a: Sheet, b: Sheet, of: 'points' | 'normals'): number {
  let most = 0;
  a.rows.forEach((row, i) => {
    row[of].forEach((x, k) => {
      most = Math.max(most, Math.abs(x - b.rows[i]![of][k]!));
    });
  });
  return most;
}

/** The largest angle (radians) between normals and the bent surface, by central differences in u and v. */
function normalError(centre: Centre, bends: readonly BendInput[], us: readonly number[]): number {
  const h = 1e-4;
  const vs = [0.03, 0.21, 0.4, 0.66, 0.85];
  let most = 0;
  for (const u of us) {
    const rows = [u - h, u, u + h];
    const columns = vs.flatMap((v) => [v - h, v, v + h]);
    const flat = ellipses(centre, radius, rows, columns);
    const flatRows = flat.rows.map((row) => ({ ...row, at: { u: row.at.u, side: 1 as const } }));
    const bent = bends.reduce(deform, { ...flat, rows: flatRows });
    vs.forEach((_, j) => {
      const at = (i: number, k: number): Vec3 => pointIn(bent.rows[i]!, 3 * j + 1 + k);
      const n = cross3(sub3(at(1, 1), at(1, -1)), sub3(at(2, 0), at(0, 0)));
      const given = normalIn(bent.rows[1]!, 3 * j + 1);
      most = Math.max(most, length3(cross3(n, given)) / length3(n), dot3(n, given) > 0 ? 0 : 1);
    });
  }
  return most;
}

describe('bends', () => {
  const arcs: readonly [string, Centre, Plane, Curve][] = [
    ['a straight way from its side', upright, SIDE, line([0, 0], [0, 100])],
    [
      'an arc of 120° in its own plane',
      arc(0.4, 2.1),
      { ...FRONT, origin: [0, 0, 0] },
      exactArc([0, 0], 60, 0.4, 2.1),
    ],
    ['a straight way, drawn backwards', upright, SIDE, line([0, 100], [0, 0])],
  ];
  for (const [name, centre, plane, curve] of arcs) {
    for (const keepsLength of [false, true]) {
      test(`d = l leaves ${name} as it is${keepsLength ? ', length kept' : ''}`, () => {
        const sheet = ellipses(centre, radius, US, VS);
        const bent = deform(sheet, { curve, plane, keepsLength });
        expect(largest(sheet, bent, 'points')).toBeLessThan(1e-9);
        expect(largest(sheet, bent, 'normals')).toBeLessThan(1e-9);
      });
    }
  }

  test('kept length is measured from where the pen was put down, from either end', () => {
    const sheet = ellipses(upright, radius, US, VS);
    const middle = (u: number, curve: Curve) =>
      deform(sheet, { curve, plane: SIDE, keepsLength: true }).spine.at(u, 1).centre;
    // the way is 100 long: what is short of the stroke, or beyond it, is at its far end
    for (const length of [60, 130]) {
      const forth = line([4, 10], [4, 10 + length]);
      expect(middle(0, forth)[1]).toBeCloseTo(10, 9);
      expect(middle(1, forth)[1]).toBeCloseTo(110, 9);
      const back = line([4, 90], [4, 90 - length]);
      expect(middle(1, back)[1]).toBeCloseTo(90, 9);
      expect(middle(0, back)[1]).toBeCloseTo(-10, 9);
    }
  });

  const views: readonly [string, Plane][] = [
    ['from the front', FRONT],
    ['askew', tilted(0.9)],
    ['nearly from the side', tilted(0.2)],
    ['from the side', SIDE],
  ];
  for (const [name, plane] of views) {
    test(`d = l leaves a winding way as it is, seen ${name}`, () => {
      const sheet = ellipses(cubic(...BEND), radius, US, VS);
      const bent = deform(sheet, { curve: drawnOver(BEND, plane), plane, keepsLength: false });
      expect(largest(sheet, bent, 'points')).toBeLessThan(1e-9);
      expect(largest(sheet, bent, 'normals')).toBeLessThan(1e-9);
    });
  }

  test('d = l leaves a ring as it is by a closed stroke', () => {
    const ring = arc(0.3, 2 * Math.PI, true);
    const view = sideView(tilted(0.9));
    const sheet = ellipses(ring, radius, US, VS);
    const curve = functionCurve((t) => view.point(ring.at(t)[0]), true);
    const bent = deform(sheet, { curve, plane: tilted(0.9), keepsLength: false });
    // functionCurve's own error inside its 4096 chords
    expect(largest(sheet, bent, 'points')).toBeLessThan(1e-4);
    expect(largest(sheet, bent, 'normals')).toBeLessThan(1e-4);
  });

  const bow = bezier([0, 0], [60, 20], [50, 70], [-5, 105]);
  test('normals are those of the bent surface', () => {
    for (const [centre, plane] of [
      [upright, SIDE],
      [wavy(20, 1.3), SIDE],
      [wavy(20, 1.3), tilted(0.2)],
      [wavy(20, 1.3), tilted(1.1)],
      [arc(0.4, 2.1), FRONT],
      [arc(0.4, 2.1), ABOVE],
    ] as const) {
      for (const keepsLength of [false, true]) {
        expect(
          normalError(centre, [{ curve: bow, plane, keepsLength }], [0.011, 0.23, 0.5, 0.77]),
        ).toBeLessThan(1e-3);
      }
    }
  });

  test('normals and ways of bends on bends', () => {
    const wave = bezier([0, 0], [40, 30], [-40, 60], [0, 90]);
    const bends: BendInput[] = [
      { curve: bow, plane: SIDE, keepsLength: false },
      { curve: wave, plane: tilted(0.7), keepsLength: true },
      { curve: bow, plane: FRONT, keepsLength: false },
    ];
    expect(normalError(wavy(10, 1), bends, [0.13, 0.42, 0.81])).toBeLessThan(1e-3);
  });

  test('the spine afterwards is that of the bent sheet', () => {
    const bent = [SIDE, tilted(0.7)].reduce(
      (sheet, plane) => deform(sheet, { curve: bow, plane, keepsLength: false }),
      ellipses(wavy(20, 1.3), radius, US, VS),
    );
    const h = 1e-5;
    for (const u of [0.2, 0.55, 0.9]) {
      const [a, here, b] = [u - h, u, u + h].map((x) => bent.spine.at(x, 1));
      const rate = sub3(b!.centre, a!.centre).map((x) => x / (2 * h)) as unknown as Vec3;
      expect(length3(sub3(rate, here!.rate)) / length3(rate)).toBeLessThan(1e-6);
      const turning = sub3(b!.normal, a!.normal).map((x) => x / (2 * h)) as unknown as Vec3;
      expect(length3(sub3(turning, cross3(here!.spin, here!.normal)))).toBeLessThan(
        1e-4 * (1 + length3(turning)),
      );
    }
  });

  test('stretched reaches the end of d, a kept length stops or runs on straight', () => {
    const sheet = ellipses(upright, radius, US, VS);
    const end = (curve: Curve, keepsLength: boolean): Vec3 =>
      deform(sheet, { curve, plane: SIDE, keepsLength }).spine.at(1, -1).centre;
    const long = line([0, 0], [0, 250]);
    const short = line([0, 0], [0, 50]);
    expect(end(long, false)[1]).toBeCloseTo(250, 9);
    expect(end(long, true)[1]).toBeCloseTo(100, 9);
    expect(end(short, false)[1]).toBeCloseTo(50, 9);
    expect(end(short, true)[1]).toBeCloseTo(100, 9);
  });

  test('a kept length is kept on a bow', () => {
    const { spine } = deform(ellipses(upright, radius, US, VS), {
      curve: bow,
      plane: SIDE,
      keepsLength: true,
    });
    for (const u of [0.1, 0.5, 0.9]) expect(length3(spine.at(u, 1).rate)).toBeCloseTo(100, 6);
  });

  test('sections stay as they are, perpendicular to d where they were to l', () => {
    const bent = deform(ellipses(upright, radius, US, VS), { curve: bow, plane: SIDE, keepsLength: false });
    for (const [i, row] of bent.rows.entries()) {
      const { centre, rate } = bent.spine.at(US[i]!, row.at.side);
      for (let j = 0; j < VS.length; j++) {
        const arm = sub3(pointIn(row, j), centre);
        expect(length3(arm)).toBeCloseTo(
          length3(sub3(pointOf(upright, radius, US[i]!, VS[j]!), [0, 100 * US[i]!, 0])),
          9,
        );
        expect(Math.abs(dot3(arm, rate)) / length3(rate)).toBeLessThan(1e-8);
      }
    }
  });

  test('the way d was drawn does not matter', () => {
    const sheet = ellipses(wavy(20, 1.3), radius, US, VS);
    const [a, b] = [bow, reversed(bow)].map((curve) =>
      deform(sheet, { curve, plane: SIDE, keepsLength: false }),
    );
    expect(largest(a!, b!, 'points')).toBeLessThan(1e-6);
  });

  test('a U bent from its side keeps both legs side by side', () => {
    const sheet = ellipses(arc(Math.PI, Math.PI), radius, US, VS);
    // the legs end at y = 0, the bend of the U is at y = −60
    const same = deform(sheet, { curve: line([0, -60], [0, 0]), plane: SIDE, keepsLength: false });
    expect(largest(sheet, same, 'points')).toBeLessThan(1e-9);
    const d = functionCurve((t) => [20 * t * t, -60 * t], false);
    const bent = deform(sheet, { curve: d, plane: SIDE, keepsLength: false });
    const [a, b] = [0.1, 0.9].map((u) => bent.spine.at(u, 1).centre);
    expect(a![0]).toBeCloseTo(-b![0], 9);
    expect(a![1]).toBeCloseTo(b![1], 9);
    expect(a![2]).toBeCloseTo(b![2], 9);
  });

  test('rings stay closed, in any view and with open or closed strokes', () => {
    const ring = arc(0, 2 * Math.PI, true);
    const flat = ellipses(ring, radius, US, VS);
    const last = flat.rows.length - 1;
    const closed: Sheet = {
      ...flat,
      rows: flat.rows.map((row, i) => (i === last ? { ...row, points: flat.rows[0]!.points } : row)),
    };
    const round = functionCurve((t) => [70 * Math.cos(6.2831853 * t), 40 * Math.sin(6.2831853 * t)], true);
    for (const curve of [bow, round, line([-60, 0], [0, 30], [60, 0])]) {
      for (const plane of [SIDE, FRONT, tilted(0.6)]) {
        const bent = deform(closed, { curve, plane, keepsLength: false });
        expect(bent.rows[bent.rows.length - 1]!.points).toEqual(bent.rows[0]!.points);
        expect(bent.rows.every(({ points, normals }) => [...points, ...normals].every(Number.isFinite))).toBe(
          true,
        );
        const [a, b] = [bent.spine.at(0, 1), bent.spine.at(1, -1)];
        expect(length3(sub3(a.centre, b.centre))).toBeLessThan(1e-6);
      }
    }
  });

  describe('corners of d', () => {
    const elbow = polylineCurve(
      [
        [0, 0],
        [0, 47],
        [44, 66],
      ],
      false,
    );
    const bend: BendInput = { curve: elbow, plane: SIDE, keepsLength: false };

    test('a crease is put in, its rows in one place to the last bit, in the bisecting plane', () => {
      const bent = deform(
        ellipses(upright, () => 8, US, VS),
        bend,
      );
      expect(bent.rows).toHaveLength(US.length + 2);
      const at = bent.rows.findIndex(({ joined }, i) => i > 0 && !joined);
      expect(bent.rows[at]!.points).toEqual(bent.rows[at - 1]!.points);
      const [t1, t2] = [elbow.tangent(0), elbow.tangent(1)];
      const across: Vec2 = [t1[0] + t2[0], t1[1] + t2[1]];
      for (let j = 0; j < VS.length; j++) {
        const [, y, z] = pointIn(bent.rows[at]!, j);
        expect(Math.abs(-z * across[0] + (y - 47) * across[1])).toBeLessThan(1e-6);
      }
    });

    test('points of straight legs stay on their cylinders, and rows do not cross', () => {
      const bent = deform(
        ellipses(upright, () => 8, US, VS),
        bend,
      );
      const legs: readonly [Vec2, Vec2][] = [
        [[0, 0], elbow.tangent(0)],
        [[0, 47], elbow.tangent(1)],
      ];
      const corner = bent.rows.findIndex(({ joined }, i) => i > 0 && !joined);
      bent.rows.forEach((row, i) => {
        const [from, along] = legs[i < corner ? 0 : 1]!;
        for (let j = 0; j < VS.length; j++) {
          const [x, y, z] = pointIn(row, j);
          const out = along[0] * (y - from[1]) - along[1] * (-z - from[0]);
          expect((x / 8) ** 2 + (out / 5.6) ** 2).toBeCloseTo(1, 6);
          if (i === 0 || !row.joined) continue;
          const [, yb, zb] = pointIn(bent.rows[i - 1]!, j);
          expect(along[1] * (y - yb) + along[0] * (zb - z)).toBeGreaterThan(0);
        }
      });
    });

    test('normals near them are those of the bent surface', () => {
      expect(normalError(wavy(3, 1), [bend], [0.3, 0.44, 0.47, 0.52, 0.58])).toBeLessThan(1e-3);
    });

    test('a bend on a bend with a corner', () => {
      const bent = deform(
        deform(
          ellipses(upright, () => 8, US, VS),
          bend,
        ),
        { ...bend, plane: FRONT },
      );
      expect(bent.rows.every(({ points, normals }) => [...points, ...normals].every(Number.isFinite))).toBe(
        true,
      );
      bent.rows.forEach((row, i) => {
        if (i > 0 && !row.joined) expect(row.points).toEqual(bent.rows[i - 1]!.points);
      });
    });
  });

  test('caps move stiffly and stay on their rims', () => {
    const sheet = ellipses(upright, radius, US, VS);
    const rim = sheet.rows[0]!;
    const down = Float64Array.from(VS.flatMap(() => [0, -1, 0]));
    const cap = { ...rim, normals: down, joined: true, at: { u: 0, side: 1, rigid: true } } as const;
    const first = { ...rim, joined: false };
    const bent = deform(
      { ...sheet, rows: [cap, first, ...sheet.rows.slice(1)] },
      { curve: bow, plane: SIDE, keepsLength: false },
    );
    expect(bent.rows[0]!.points).toEqual(bent.rows[1]!.points);
    const { rate } = bent.spine.at(0, 1);
    for (let j = 0; j < VS.length; j++) {
      expect(dot3(normalIn(bent.rows[0]!, j), rate) / length3(rate)).toBeCloseTo(-1, 9);
    }
  });

  test('a view along the way bends nothing, and says so', () => {
    const sheet = ellipses(upright, radius, US, VS);
    expect(isBendable(sheet.spine, ABOVE)).toBe(false);
    expect(isBendable(sheet.spine, SIDE)).toBe(true);
    expect(deform(sheet, { curve: bow, plane: ABOVE, keepsLength: false })).toBe(sheet);
    const dot = polylineCurve([[3, 3]], false);
    expect(deform(sheet, { curve: dot, plane: SIDE, keepsLength: false })).toBe(sheet);
  });
});
