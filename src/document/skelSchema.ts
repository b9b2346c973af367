/** The terms of a convolution sum as files hold them: skels of every kind, cross sections, colours. */
import * as v from 'valibot';
import { kernels } from '../kernel/index.ts';
import { fields, finite, flag, list, number, numbers } from './fields.ts';
import { LIMITS } from './limits.ts';
import { cutInBounds, eitherOf } from './rules.ts';

const vec2 = numbers(2);
const vec3 = numbers(3);
const share = number({ min: 0, max: 1 });

/** light, linear */
export const colour = v.strictTuple([share, share, share], 'a colour, three numbers from 0 to 1');

const some = list(finite, LIMITS.samples, 'numbers');
const points = list(vec3, LIMITS.samples, 'points');

/** Kernels say which parameters there are. */
export const params = fields(
  Object.fromEntries(
    kernels.flatMap((kernel) => kernel.params.map(({ name }) => [name, v.exactOptional(finite)])),
  ),
);

const kind = <const T extends string, const E extends v.ObjectEntries>(type: T, data: E) =>
  fields({ type: v.literal(type, `"${type}"`), ...data });

/** What is given by weights or by radii, never both. */
const weighted = <const T extends string, const E extends v.ObjectEntries>(type: T, data: E) =>
  v.pipe(
    kind(type, { ...data, weights: v.exactOptional(some), radii: v.exactOptional(some) }),
    eitherOf('weights', 'radii'),
  );

const fidelity = { fieldError: finite, distance: finite };

const key = fields({
  at: finite,
  weight: finite,
  tension: v.exactOptional(finite),
  continuity: v.exactOptional(finite),
  bias: v.exactOptional(finite),
});

const curve = v.variant(
  'type',
  [kind('keys', { keys: list(key, LIMITS.samples, 'keys') }), kind('bezier', { ordinates: some })],
  'a weight curve: keys or bezier',
);

export const skel = v.variant(
  'type',
  [
    v.pipe(
      kind('point', { at: vec3, weight: v.exactOptional(finite), radius: v.exactOptional(finite) }),
      eitherOf('weight', 'radius'),
    ),
    weighted('segment', { a: vec3, b: vec3 }),
    kind('polygon', {
      origin: vec3,
      u: vec3,
      v: vec3,
      loops: list(list(vec2, LIMITS.samples, 'points'), LIMITS.samples, 'loops'),
      weight: finite,
    }),
    weighted('polyline', { points, closed: flag }),
    v.pipe(
      weighted('nurbs', {
        points,
        rational: v.exactOptional(some),
        knots: v.exactOptional(some),
        density: finite,
      }),
      cutInBounds(),
    ),
    kind('profile', { points, curve }),
    weighted('arc', { centre: vec3, start: vec3, axis: vec3, angle: finite, ...fidelity }),
    kind('quadratic', { points, weights: some, ...fidelity }),
  ],
  'a skel: point, segment, polygon, polyline, nurbs, profile, arc or quadratic',
);

const section = v.variant(
  'type',
  [
    kind('round', {}),
    kind('superQuadric', { exponent: finite }),
    kind('extrusion', { exponent: finite }),
    kind('polar', { radii: some }),
  ],
  'a cross section: round, superQuadric, extrusion or polar',
);

const warp = fields({
  section,
  scale: vec2,
  up: v.exactOptional(vec3),
  along: v.exactOptional(vec3),
});

export const term = fields({
  skel,
  params: v.exactOptional(params),
  factor: v.exactOptional(finite),
  warp: v.exactOptional(warp),
  colour: v.exactOptional(colour),
});
