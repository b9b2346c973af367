/** Any surface there can be in a document: strokes of hands and of nobody's, sections, redraws, backs, bends. */
import fc from 'fast-check';
import { DEFAULT_BRUSH, type SurfacePart } from '../../src/document/document.ts';
import {
  BACKS,
  BETWEENS,
  type Bend,
  kindOfStrokes,
  type Section,
  type SectionStroke,
  type SurfaceForm,
  withSection,
} from '../../src/document/surfacePart.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import { cross3, length3, scale3 } from '../../src/math/tuple.ts';
import type { Vec2, Vec3 } from '../../src/math/vec.ts';
import type { Plane, Stroke } from '../../src/stroke/stroke.ts';
import { PLANE, strokeAlong } from './strokes.ts';

/** Evenly: of all doubles between two numbers nearly every one is next to nothing. */
const number = (min: number, max: number) =>
  fc.integer({ min: 0, max: EVEN }).map((i) => min + ((max - min) * i) / EVEN);
const EVEN = 1 << 24;
const place: fc.Arbitrary<Vec2> = fc.tuple(number(-80, 80), number(-80, 80));

/** A way from place to place with waves on it, and the trembling of a hand. */
const way = (from: fc.Arbitrary<Vec2>, to: fc.Arbitrary<Vec2>): fc.Arbitrary<Vec2[]> =>
  fc
    .tuple(from, to, fc.array(number(-25, 25), { minLength: 3, maxLength: 3 }), number(0, 0.4), fc.integer())
    .map(([[ax, ay], [bx, by], waves, tremble, seed]) =>
      Array.from({ length: 24 }, (_, i): Vec2 => {
        const t = i / 23;
        const off = waves.reduce(
          (sum, wave, k) => sum + (wave * Math.sin((k + 1) * Math.PI * t)) / (k + 1),
          0,
        );
        const jitter = tremble * Math.sin(seed + 37 * i);
        const length = Math.hypot(bx - ax, by - ay) || 1;
        const across: Vec2 = [(ay - by) / length, (bx - ax) / length];
        return [ax + (bx - ax) * t + across[0] * off + jitter, ay + (by - ay) * t + across[1] * off];
      }),
    );

/** Corners, loops, places twice; or one place alone. */
const zigzag: fc.Arbitrary<Vec2[]> = fc.array(place, { minLength: 1, maxLength: 6 });

const strokeOf = (points: readonly Vec2[], plane: Plane, closed: boolean): Stroke =>
  strokeAlong(
    (t) => points[Math.round(t * (points.length - 1))]!,
    { plane, closed },
    Math.max(points.length, 2),
  );

const line = (from: fc.Arbitrary<Vec2>, to: fc.Arbitrary<Vec2>) =>
  fc.oneof({ weight: 6, arbitrary: way(from, to) }, { weight: 1, arbitrary: zigzag });

const loop: fc.Arbitrary<Vec2[]> = fc
  .tuple(place, number(3, 50), number(3, 50), number(-0.4, 0.4), fc.boolean())
  .map(([[x, y], a, b, wave, isBack]) =>
    Array.from({ length: 40 }, (_, i): Vec2 => {
      const angle = ((isBack ? -1 : 1) * 2 * Math.PI * i) / 40;
      const r = 1 + wave * Math.cos(3 * angle);
      return [x + a * r * Math.cos(angle), y + b * r * Math.sin(angle)];
    }),
  );

const near = (x: number, y: number, by = 12): fc.Arbitrary<Vec2> =>
  fc.tuple(number(x - by, x + by), number(y - by, y + by));

/** One or two, open or closed alike. */
const strokes: fc.Arbitrary<Stroke[]> = fc
  .oneof(
    {
      weight: 6,
      arbitrary: fc.tuple(line(near(-20, -50), near(-20, 50)), line(near(20, 50), near(20, -50))),
    },
    { weight: 2, arbitrary: fc.tuple(line(near(0, -50), near(0, 50))) },
    { weight: 1, arbitrary: fc.tuple(line(place, place), line(place, place)) },
  )
  .map((ways) => ways.map((points) => strokeOf(points, PLANE, false)));
const loops: fc.Arbitrary<Stroke[]> = fc
  .array(loop, { minLength: 1, maxLength: 2 })
  .map((ways) => ways.map((points) => strokeOf(points, PLANE, true)));

const drawnAcross: fc.Arbitrary<SectionStroke> = line(near(-20, 0), near(20, 0)).map((points) => ({
  stroke: strokeOf(points, PLANE, false),
  half: null,
}));
const onSection = fc
  .tuple(line(near(-15, 10), near(15, 10)), number(2, 40), fc.boolean())
  .map(([points, half, closed]) => ({ stroke: strokeOf(points, PLANE, closed), half }));

const section: fc.Arbitrary<Section> = fc
  .record({
    u: number(0, 1),
    front: fc.option(fc.oneof(drawnAcross, onSection)),
    back: fc.option(drawnAcross),
    redraws: fc.array(onSection, { maxLength: 2 }),
    follows: fc.integer({ min: 0, max: 5 }),
  })
  .map(({ follows, ...plain }) =>
    follows === 0 ? { ...plain, front: null, back: null, follows: true as const } : plain,
  );

const direction: fc.Arbitrary<Vec3> = fc
  .tuple(number(-1, 1), number(-1, 1), number(-1, 1))
  .filter((v) => length3(v) > 0.1)
  .map((v) => scale3(v, 1 / length3(v)));

/** Mostly from the side. */
const sideways: fc.Arbitrary<Plane> = fc.oneof(
  fc.constant<Plane>({ origin: [0, 0, 0], x: [0, 0, -1], y: [0, 1, 0] }),
  fc
    .tuple(direction, direction)
    .filter(([a, b]) => length3(cross3(a, b)) > 0.1)
    .map(([a, b]): Plane => {
      const n = cross3(a, b);
      const y = cross3(n, a);
      return { origin: [1, 2, 3], x: a, y: scale3(y, 1 / length3(y)) };
    }),
);

const bend: fc.Arbitrary<Bend> = fc
  .tuple(line(near(0, -50), near(20, 50)), sideways, fc.boolean(), fc.boolean())
  .map(([points, plane, keepsLength, isOff]) => ({
    stroke: strokeOf(points, plane, false),
    keepsLength,
    isOff: isOff && keepsLength,
  }));

const form: fc.Arbitrary<SurfaceForm> = fc
  .record({
    strokes: fc.oneof({ weight: 4, arbitrary: strokes }, { weight: 1, arbitrary: loops }),
    sections: fc.array(section, { maxLength: 4 }),
    back: fc.constantFrom(...BACKS),
    between: fc.constantFrom(...BETWEENS),
    bends: fc.oneof(
      { weight: 3, arbitrary: fc.constant([]) },
      { weight: 1, arbitrary: fc.array(bend, { maxLength: 2 }) },
    ),
    detail: fc.record({
      rows: fc.option(fc.integer({ min: 1, max: 12 })),
      columns: fc.integer({ min: 3, max: 10 }),
      u: fc.integer({ min: 0, max: 1 }),
      v: fc.integer({ min: 0, max: 1 }),
    }),
  })
  .map((found) => ({
    ...found,
    sections: found.sections.reduce((all, each) => withSection(all, each), [] as readonly Section[]),
  }));

const surface: fc.Arbitrary<SurfacePart> = fc
  .tuple(form, number(1, 20), fc.boolean(), fc.boolean())
  .map(([found, radius, pressure, caps]) => ({
    id: 'part-1',
    name: 'Any',
    ...found,
    kind: kindOfStrokes(found),
    brush: { ...DEFAULT_BRUSH, radius, pressure, caps },
    placement: UNMOVED,
    hidden: false,
  }));

/** Some of them of numbers at the ends of their ranges. */
export const anySurface: fc.Arbitrary<SurfacePart> = fc.oneof(
  { weight: 4, arbitrary: fc.noBias(surface) },
  { weight: 1, arbitrary: surface },
);

/** The strokes that these are made of. */
export const anyStrokes = {
  line: fc
    .oneof(
      { weight: 6, arbitrary: way(near(-15, -50, 30), near(15, 50, 30)) },
      { weight: 1, arbitrary: zigzag },
    )
    .map((points) => strokeOf(points, PLANE, false)),
  across: drawnAcross,
  onSection,
  bend,
};
