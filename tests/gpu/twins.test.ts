/** WGSL = TypeScript: seeded random and nasty cases, all kernels, inputs rounded to float32 before both see them. */
import { afterAll, it } from 'vitest';
import type { Vec2, Vec3 } from '../../src/math/vec.ts';
import { bindSkel } from '../../src/skeleton/index.ts';
import type { Skel } from '../../src/skeleton/skels.ts';
import { random } from '../fixtures/random.ts';
import { variants } from '../kernel/variants.ts';
import { closeDawn, describeGpu } from './dawn.ts';
import { type Case, expectAllowed, judged } from './judge.ts';

afterAll(closeDawn);

const COUNT = 24;

/** A skel and a point; `size` is what one unit of length becomes, `shift` where the origin goes. */
type Make = (draw: Draw) => { readonly skel: Skel; readonly p: Vec3 };

interface Draw {
  /** in [−1, 1) */
  signed(): number;
  /** in [0, 1) */
  uniform(): number;
  /** which of the cases of this place */
  readonly i: number;
  /** of f(c r) = c^homogeneity f(r) */
  readonly homogeneity: number;
  readonly place: Place;
}

interface Place {
  readonly name: string;
  readonly size: number;
  /** in widths of the kernel */
  readonly offset: number;
}

const PLACES: readonly Place[] = [
  { name: 'generic', size: 1, offset: 0 },
  { name: 'near the axis', size: 1, offset: 0 },
  { name: 'beyond an end', size: 1, offset: 0 },
  { name: 'on the axis beyond an end', size: 1, offset: 0 },
  { name: 'at an end', size: 1, offset: 0 },
  { name: 'far', size: 1, offset: 0 },
  { name: 'offset by 1e3', size: 1, offset: 1000 },
  { name: 'at 1e-6', size: 1e-6, offset: 0 },
  { name: 'at 1e6', size: 1e6, offset: 0 },
];

const round = (v: readonly number[]): Vec3 => [Math.fround(v[0]!), Math.fround(v[1]!), Math.fround(v[2]!)];

/** Somewhere near the origin of the place. */
const somewhere = ({ signed, place: { size, offset } }: Draw): Vec3 =>
  round([0, 1, 2].map(() => size * (signed() + offset)));

const point: Make = (draw) => {
  const { signed, uniform, place, homogeneity } = draw;
  const weight = Math.fround((uniform() + 0.5) * place.size ** -homogeneity);
  const far = place.name === 'far' ? 50 : 1;
  const at = somewhere(draw);
  const p = round(at.map((x) => x + far * place.size * signed()));
  return { skel: { type: 'point', at, weight }, p };
};

const segment: Make = (draw) => {
  const { signed, uniform, place, homogeneity, i } = draw;
  const { name, size } = place;
  const a = somewhere(draw);
  const b = round(a.map((x) => x + size * 10 ** signed() * signed()));
  const along = b.map((x, axis) => x - a[axis]!);
  const length = Math.hypot(...along);
  const side = [signed(), signed(), signed()];
  const share = along.reduce((sum, x, axis) => sum + x * side[axis]!, 0) / length ** 2;
  const perp = side.map((x, axis) => x - share * along[axis]!);
  const at = (t: number, distance: number) =>
    round(a.map((x, axis) => x + t * along[axis]! + distance * size * perp[axis]!));
  // Weights of one sign where errors are relative to the value: it must not cancel.
  const sign = homogeneity === 0 ? signed : uniform;
  const weights = Array.from({ length: 1 + (i % 4) }, (_, k) =>
    Math.fround((k === 0 ? 0.5 + uniform() : sign()) / length ** k / size ** (1 + homogeneity)),
  );
  const places: Record<string, () => Vec3> = {
    'near the axis': () => at(uniform(), 10 ** (-1 - 2 * uniform())),
    'beyond an end': () => at(1 + uniform(), uniform()),
    'on the axis beyond an end': () => at(-uniform(), 0),
    'at an end': () => at(1, 0.1 + uniform()),
    far: () => at(20 * signed(), 20 * uniform() + 5),
  };
  const p = places[name]?.() ?? at(1.6 * uniform() - 0.3, 0.05 + 2 * uniform());
  return { skel: { type: 'segment', a, b, weights }, p };
};

/** A concave outline with a hole, in any plane. */
const polygon: Make = (draw) => {
  const { signed, uniform, place, homogeneity, i } = draw;
  const { name, size } = place;
  const star = Array.from({ length: 7 }, (_, k): Vec2 => {
    const r = size * (k % 2 ? 0.6 + 0.3 * uniform() : 1 + uniform());
    return [r * Math.cos((k * 2 * Math.PI) / 7), r * Math.sin((k * 2 * Math.PI) / 7)];
  });
  const hole: Vec2[] = [
    [0.3, 0.1],
    [0.1, 0.3],
    [-0.1, -0.2],
  ].map(([x, y]) => [x! * size, y! * size]);
  const loops = [star, hole].map((loop) => loop.map(([x, y]): Vec2 => [Math.fround(x), Math.fround(y)]));
  // axes of which float32 holds all digits in half of the cases: tilted planes are rounded with their axes
  const tilted = i % 2 === 0;
  const u: Vec3 = tilted ? [0.6, signed(), 0.8] : [1, 0, 0];
  const v: Vec3 = tilted ? [signed(), 1, 0.3] : [0, 0, 1];
  const origin = somewhere(draw);
  const weight = Math.fround((0.5 + uniform()) * size ** -(2 + homogeneity));
  const skel: Skel = { type: 'polygon', origin, u, v, loops, weight };
  const [x, y] = name === 'at an end' ? star[i % 7]! : name === 'beyond an end' ? edgePoint(star, i) : [0, 0];
  const spread = name === 'far' ? 30 : name === 'at an end' || name === 'beyond an end' ? 0 : 2;
  const height = (0.05 + uniform()) * (i % 3 ? 1 : -1) * (name === 'far' ? 10 : 1);
  const [px, py] = [x + spread * size * signed(), y + spread * size * signed()];
  const p = place3(skel, px, py, height * size);
  return { skel, p };
};

/** on an edge's extension */
function edgePoint(loop: readonly Vec2[], i: number): Vec2 {
  const [[x0, y0], [x1, y1]] = [loop[i % 7]!, loop[(i + 1) % 7]!];
  return [x0 + 1.5 * (x1 - x0), y0 + 1.5 * (y1 - y0)];
}

function place3({ origin, u, v }: Extract<Skel, { type: 'polygon' }>, x: number, y: number, z: number): Vec3 {
  const first = u.map((c) => c / Math.hypot(...u));
  const share = v.reduce((sum, c, axis) => sum + c * first[axis]!, 0);
  const rest = v.map((c, axis) => c - share * first[axis]!);
  const second = rest.map((c) => c / Math.hypot(...rest));
  const normal = [0, 1, 2].map((k) => {
    const [i, j] = [(k + 1) % 3, (k + 2) % 3];
    return first[i]! * second[j]! - first[j]! * second[i]!;
  });
  return round(origin.map((c, k) => c + x * first[k]! + y * second[k]! + z * normal[k]!));
}

/** widths that kernels take */
const allowed = (width: number): number => Math.min(1e6, Math.max(1.0001e-6, Math.fround(width)));

function casesOf(make: Make, seed: number): Case[] {
  const uniform = random(seed);
  const signed = () => 2 * uniform() - 1;
  return variants.flatMap(({ title, kernel, params: written }) =>
    PLACES.flatMap((place) =>
      Array.from({ length: COUNT }, (_, i) => {
        const { skel, p } = make({ signed, uniform, i, homogeneity: kernel.homogeneity, place });
        // widths from 1/8 to 8
        const width = 8 ** signed();
        const params = {
          ...written,
          ...(written.s === undefined ? {} : { s: allowed(1 / (width * place.size)) }),
          ...(written.R === undefined ? {} : { R: allowed(width * place.size) }),
        };
        const truth = new Float64Array(4);
        bindSkel(skel, kernel, params).add(...p, 1, truth);
        return { title: `${title} ${place.name} ${i}`, skel, kernel, params, p, truth };
      }),
    ),
  );
}

describeGpu('WGSL and TypeScript', () => {
  for (const [family, make, seed] of [
    ['point', point, 21],
    ['segment', segment, 22],
    ['polygon', polygon, 23],
  ] as const) {
    it(`agree on a ${family}, random and nasty (seed ${seed})`, async () => {
      const cases = casesOf(make, seed);
      expectAllowed(family, cases, await judged(cases));
    });
  }
});
