/** Motions, sizes, sums and bounds, for every skel with every kernel. */
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../src/math/vec.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import type { SkelField } from '../../src/skeleton/skeleton.ts';
import type { PolygonSkel, SegmentSkel, Skel } from '../../src/skeleton/skels.ts';
import { eachSpecimen, evaluated, expectSame, SEED, scaleOf, some } from './compare.ts';
import { pointsAround, SPECIMENS } from './specimens.ts';

describe.each(some)('with the kernel $title', (variant) => {
  const { kernel, params } = variant;
  const bound = (skel: Skel) => bindSkel(skel, kernel, params);

  it(`the value alone is the same (seed ${SEED})`, () => {
    eachSpecimen((skel, p) => {
      const field = bound(skel);
      // 0 and −0 are the same
      expect(field.value(...p) === evaluated(field, p)[0]).toBe(true);
    });
  });

  it(`a rigid motion moves the field along (seed ${SEED})`, () => {
    // a rotation of whole fractions and a shift by a thousand radii: exact but for the last bits
    const rotated = ([x, y, z]: Vec3): Vec3 => [0.6 * x - 0.8 * z, y, 0.8 * x + 0.6 * z];
    eachSpecimen((skel, p, what) => {
      const turned = moved(skel, rotated, rotated);
      const [found, wanted] = [evaluated(bound(turned), rotated(p)), evaluated(bound(skel), p)];
      const gradient = rotated([wanted[1]!, wanted[2]!, wanted[3]!]);
      const { size, width } = scaleOf(skel, variant, p);
      expectSame(found, [wanted[0]!, ...gradient], { size: 10 * size, width }, what);
      const shifted = ([x, y, z]: Vec3): Vec3 => [x + 1024, y - 512, z + 2048];
      const far = evaluated(bound(moved(skel, shifted, (v) => v)), shifted(p));
      // coordinates have lost 11 bits
      const closeness = { size: 1e3 * (size + Math.abs(wanted[0]!)), width: 1e-3 * width };
      expectSame(far, wanted, { ...closeness, width: Math.min(closeness.width, 1e-3) }, what);
    });
  });

  for (const c of [2 ** -20, 2 ** 20]) {
    it(`everything ${c} times as large has a field of the same form (seed ${SEED})`, () => {
      const larger = ([x, y, z]: Vec3): Vec3 => [c * x, c * y, c * z];
      const { s, R, ...others } = params;
      const scaled = { ...others, ...(s && { s: s / c }), ...(R && { R: R * c }) };
      eachSpecimen((skel, p, what) => {
        const grown = moved(skel, larger, (v) => v, c);
        const dimension = skel.type === 'point' ? 0 : skel.type === 'segment' ? 1 : 2;
        const factor = c ** (dimension + kernel.homogeneity);
        const found = evaluated(bindSkel(grown, kernel, scaled), larger(p));
        const wanted = evaluated(bound(skel), p).map((x, i) => (i === 0 ? x : x / c) * factor);
        const { size, width } = scaleOf(skel, variant, p);
        expectSame(found, wanted, { size: size * factor, width: width * c }, what);
      });
    });
  }

  it(`adds what it is asked, any factor, to what is there (seed ${SEED})`, () => {
    eachSpecimen((skel, p, what) => {
      const field = bound(skel);
      const out = Float64Array.of(1, 2, 3, 4);
      field.add(...p, -0.5, out);
      const wanted = evaluated(field, p).map((x, i) => i + 1 - 0.5 * x);
      const { size, width } = scaleOf(skel, variant, p);
      expectSame(out, wanted, { size: size + 1, width: Math.min(width, 1) }, what);
    });
  });

  it(`is below a threshold beyond the offset for it (seed ${SEED})`, () => {
    eachSpecimen((skel, p) => {
      const field = bound(skel);
      // what edge sums leave of nothing far away is no field
      const size = Math.max(Math.abs(field.value(...p)), 1e-9);
      for (const threshold of [0.3 * size, size, 3 * size]) {
        const offset = field.offset(threshold);
        for (const scale of [1, 1.5, 6]) {
          const q = outside(field, p, offset * scale);
          const value = Math.abs(field.value(...q));
          if (!(value <= threshold * (1 + 1e-9))) expect(value, JSON.stringify(skel)).toBeLessThan(threshold);
        }
      }
    });
  });

  it(`a segment cut in two has the same field (seed ${SEED})`, () => {
    for (const skel of SPECIMENS.segment) {
      for (const p of pointsAround(skel, SEED)) {
        const whole = evaluated(bound(skel), p);
        const sum = summed(cut(skel, 0.375).map(bound), p);
        const { size, width } = scaleOf(skel, variant, p);
        // the halves of r^−n reach farther than the whole beside its cut
        expectSame(
          sum,
          whole,
          { size: size + Math.abs(whole[0]!), width: Math.min(width, 0.1) },
          `cut at ${p}`,
        );
      }
    }
  });

  it(`a polygon cut in two, or a hole filled, is the same field (seed ${SEED})`, () => {
    const [square, , , holed] = SPECIMENS.polygon as readonly [
      PolygonSkel,
      PolygonSkel,
      PolygonSkel,
      PolygonSkel,
    ];
    const rectangle = (x0: number, x1: number): PolygonSkel => ({
      ...square,
      loops: [
        [
          [x0, -1],
          [x1, -1],
          [x1, 1],
          [x0, 1],
        ],
      ],
    });
    const [outline, hole] = holed.loops;
    const filled = [
      { ...holed, loops: [outline!] },
      { ...holed, loops: [[...hole!].reverse()], weight: -1 },
    ];
    for (const p of pointsAround(square, SEED)) {
      const scale = scaleOf(square, variant, p);
      const halves = [rectangle(-1, 0.125), rectangle(0.125, 1)].map(bound);
      expectSame(summed(halves, p), evaluated(bound(square), p), scale, `halves at ${p}`);
      expectSame(summed(filled.map(bound), p), evaluated(bound(holed), p), scale, `filled at ${p}`);
    }
  });

  it(`is linear in its weights (seed ${SEED})`, () => {
    eachSpecimen((skel, p, what) => {
      if (skel.type === 'segment') {
        const parts = skel.weights.map((weight, k) => ({ ...skel, weights: [...Array(k).fill(0), weight] }));
        const scale = scaleOf(skel, variant, p);
        const whole = evaluated(bound(skel), p);
        const most = parts.reduce((sum, part) => sum + Math.abs(bound(part).value(...p)), scale.size);
        expectSame(
          summed(parts.map(bound), p),
          whole,
          { size: most, width: Math.min(scale.width, 0.1) },
          what,
        );
      } else {
        const doubled = evaluated(bound({ ...skel, weight: -2 * skel.weight }), p);
        const wanted = evaluated(bound(skel), p).map((x) => -2 * x);
        expectSame(doubled, wanted, scaleOf(skel, variant, p), what);
      }
    });
  });

  it('a symmetric skel has a symmetric field', () => {
    const segment = bound({ type: 'segment', a: [-1, 0, 0], b: [1, 0, 0], weights: [1] });
    const plate = bound(SPECIMENS.polygon[0]!);
    const [cx, cy, cz] = SPECIMENS.polygon[0]!.origin;
    for (const [x, y, z] of [
      [0.5, 0.25, 0.125],
      [1.75, 0.5, -0.25],
      [0.125, -2, 1],
    ] as const) {
      const size = Math.abs(segment.value(x, y, z));
      for (const [sx, sy] of [
        [-1, 1],
        [1, -1],
        [-1, -1],
      ] as const) {
        expect(Math.abs(segment.value(sx * x, sy * y, z) - segment.value(x, y, z))).toBeLessThanOrEqual(
          1e-13 * size,
        );
        const wanted = plate.value(cx + x, cy + y, cz + z);
        const found = plate.value(cx + sx * x, cy + sy * y, cz - z);
        expect(Math.abs(found - wanted)).toBeLessThanOrEqual(1e-13 * (wanted + plate.value(cx, cy, cz + z)));
      }
    }
  });
});

function summed(fields: readonly SkelField[], [x, y, z]: Vec3): Float64Array {
  const out = new Float64Array(4);
  for (const field of fields) field.add(x, y, z, 1, out);
  return out;
}

/** Both parts of a segment, the weight expanded about the cut. */
function cut({ a, b, weights, type }: SegmentSkel, at: number): readonly SegmentSkel[] {
  const point = (axis: 0 | 1 | 2) => a[axis] + at * (b[axis] - a[axis]);
  const middle: Vec3 = [point(0), point(1), point(2)];
  const t = Math.hypot(middle[0] - a[0], middle[1] - a[1], middle[2] - a[2]);
  const [w0 = 0, w1 = 0, w2 = 0, w3 = 0] = weights;
  const shifted = [w0 + t * (w1 + t * (w2 + t * w3)), w1 + t * (2 * w2 + 3 * t * w3), w2 + 3 * t * w3, w3];
  return [
    { type, a, b: middle, weights },
    { type, a: middle, b, weights: shifted },
  ];
}

/** A point at least `distance` from the box, in the direction of p. */
function outside({ box }: SkelField, p: Vec3, distance: number): Vec3 {
  const clear = distance * (1 + 1e-12) + 1e-300;
  const axis = ([0, 1, 2] as const).find((i) => p[i] > box.max[i] || p[i] < box.min[i]) ?? 0;
  const q: [number, number, number] = [...p];
  q[axis] = p[axis] > 0.5 * (box.min[axis] + box.max[axis]) ? box.max[axis] + clear : box.min[axis] - clear;
  return q;
}

function moved(skel: Skel, at: (p: Vec3) => Vec3, turn: (v: Vec3) => Vec3, scale = 1): Skel {
  switch (skel.type) {
    case 'point':
      return { ...skel, at: at(skel.at) };
    case 'segment':
      return { ...skel, a: at(skel.a), b: at(skel.b), weights: skel.weights.map((w, k) => w / scale ** k) };
    case 'polygon': {
      const loops = skel.loops.map((loop) => loop.map(([x, y]) => [scale * x, scale * y] as const));
      return { ...skel, origin: at(skel.origin), u: turn(skel.u), v: turn(skel.v), loops };
    }
  }
}
