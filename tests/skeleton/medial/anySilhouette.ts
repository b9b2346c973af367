/** Outlines of all kinds, some of which nobody draws. */
import { untangle } from '../../../src/math/untangle.ts';
import type { Vec2 } from '../../../src/math/vec.ts';
import { random } from '../../fixtures/random.ts';
import { blob, box, disc, polar, shifted, stretched } from '../../fixtures/silhouettes.ts';

type Loops = readonly (readonly Vec2[])[];

/** The outline of a bar about a line of places, `half` to either side. */
function about(line: readonly Vec2[], half: number): readonly Vec2[] {
  const normals = line.map((_, i): Vec2 => {
    const [a, b] = [line[Math.max(i - 1, 0)]!, line[Math.min(i + 1, line.length - 1)]!];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    return [(half * (a[1] - b[1])) / length, (half * (b[0] - a[0])) / length];
  });
  const side = (k: number) => line.map(([x, y], i): Vec2 => [x + k * normals[i]![0], y + k * normals[i]![1]]);
  return [...side(-1), ...side(1).reverse()];
}

const KINDS: Readonly<Record<string, (next: () => number, seed: number) => Loops>> = {
  blob: (_, seed) => [blob(seed)],
  star: (next) => {
    const [arms, deep, turn] = [3 + Math.floor(6 * next()), 0.2 + 0.65 * next(), next()];
    return [polar((t) => 30 * (1 + deep * Math.cos(2 * Math.PI * (arms * t + turn))), 200)];
  },
  spiral: (next) => {
    const turns = 1 + 1.5 * next();
    const line = Array.from({ length: 120 }, (_, i): Vec2 => {
      const t = (2 * Math.PI * turns * i) / 119;
      return [(8 + 2 * t) * Math.cos(t), (8 + 2 * t) * Math.sin(t)];
    });
    return [about(line, 1 + 4 * next())];
  },
  comb: (next) => {
    const [teeth, wide, long] = [2 + Math.floor(5 * next()), 3 + 4 * next(), 8 + 25 * next()];
    const edge = Array.from({ length: teeth }, (_, i): Vec2[] => [
      [10 * i, 8],
      [10 * i, 8 + long],
      [10 * i + wide, 8 + long],
      [10 * i + wide, 8],
    ]).flat();
    return [[[10 * teeth - 10 + wide, 0], [0, 0], ...edge]];
  },
  'nearly touching': (next) => {
    const slit = 10 ** (-1 - 4 * next());
    const wide = 3 + 6 * next();
    const side = (radius: number) =>
      Array.from({ length: 80 }, (_, i): Vec2 => {
        const t = slit + (2 * Math.PI - 2 * slit) * (i / 79);
        return [radius * Math.cos(t), radius * Math.sin(t)];
      });
    return [[...side(25 + wide), ...side(25 - wide).reverse()]];
  },
  tiny: (_, seed) => [stretched(blob(seed), [1e-6, 1e-6])],
  huge: (next, seed) => [shifted(stretched(blob(seed), [1e5, 1e5]), [1e6 * next(), -1e6 * next()])],
  collinear: (next) => {
    const off = next() < 0.5 ? 0 : 10 ** (-6 - 8 * next());
    return [
      Array.from({ length: 3 + Math.floor(20 * next()) }, (): Vec2 => {
        const t = 50 * next();
        return [3 * t + off * next(), t + off * next()];
      }),
    ];
  },
  'with holes': (next, seed) => {
    const holes = Array.from({ length: 1 + Math.floor(4 * next()) }, (_, i) => {
      const [turn, far] = [next() + i, 6 * next()];
      return shifted(disc(1 + 4 * next()), [far * Math.cos(6 * turn), far * Math.sin(6 * turn)]);
    });
    return untangle(blob(seed), holes);
  },
  scribble: (next) =>
    untangle(Array.from({ length: 4 + Math.floor(12 * next()) }, (): Vec2 => [60 * next(), 60 * next()])),
  trembling: (next, seed) => untangle(blob(seed).map(([x, y]): Vec2 => [x + next() - 0.5, y + next() - 0.5])),
  needle: (next) => [box(100, 10 ** (1 - 4 * next()))],
  'few places': (next) =>
    untangle(Array.from({ length: Math.floor(5 * next()) }, (): Vec2 => [30 * next(), 30 * next()])),
  'no numbers': (next, seed) => [
    blob(seed).map((p): Vec2 => (next() < 0.02 ? [p[0], next() < 0.5 ? Number.NaN : Infinity] : p)),
  ],
};

export interface AnySilhouette {
  readonly kind: string;
  readonly loops: Loops;
}

/** Kinds in turn. */
export function anySilhouette(seed: number): AnySilhouette {
  const kinds = Object.keys(KINDS);
  const kind = kinds[seed % kinds.length]!;
  return { kind, loops: KINDS[kind]!(random(seed), seed) };
}
