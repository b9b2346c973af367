/** Skels drawn by lot: one maker a kind, by weights and by radii. */
import type { AnySkel } from '../../src/field/expand.ts';
import { cos, sin, TAU } from '../../src/math/trig.ts';
import type { Vec2, Vec3 } from '../../src/math/vec.ts';
import type { Lot } from './lot.ts';

/** The weight with which a skel of `dimension` has a field near 1, in any unit. */
export type Mass = (dimension: number) => number;

const places = (lot: Lot, count: number): Vec3[] => lot.many(count, () => lot.place());
const radii = (lot: Lot, count: number): number[] => lot.many(count, () => lot.length());
const weights = (lot: Lot, count: number, mass: Mass): number[] =>
  lot.many(count, () => lot.between(0.2, 2) * mass(1));
/** coarse: what is asked of a tree does not depend on how closely curves are followed */
const fidelity = (lot: Lot) => ({ fieldError: 1, distance: 1.5 * lot.unit });

const MAKERS: readonly ((lot: Lot, mass: Mass) => AnySkel)[] = [
  (lot, mass) => ({ type: 'point', at: lot.place(), weight: lot.between(-1, 3) * mass(0) }),
  (lot) => ({ type: 'point', at: lot.place(), radius: lot.length() }),
  segment,
  (lot) => ({ type: 'segment', a: lot.place(), b: lot.place(), radii: [lot.length(), lot.length()] }),
  polygon,
  (lot, mass) => ({ ...line(lot), weights: weights(lot, 4, mass) }),
  (lot) => ({ ...line(lot), radii: radii(lot, 4) }),
  (lot, mass) => ({ ...nurbs(lot), weights: weights(lot, 5, mass) }),
  (lot) => ({ ...nurbs(lot), radii: radii(lot, 5) }),
  (lot, mass) => {
    const ordinates = weights(lot, 7, mass);
    return { type: 'profile', points: places(lot, 3), curve: { type: 'bezier', ordinates } };
  },
  (lot, mass) => ({ ...arc(lot), weights: [mass(1), 0.5 * mass(1)] }),
  (lot) => ({ ...arc(lot), radii: [lot.length(), lot.length()] }),
  (lot, mass) => ({
    type: 'quadratic',
    points: places(lot, 5),
    weights: weights(lot, 3, mass),
    ...fidelity(lot),
  }),
];

export const randomSkel = (lot: Lot, mass: Mass): AnySkel => lot.one(MAKERS)(lot, mass);

const line = (lot: Lot) => ({ type: 'polyline', points: places(lot, 4), closed: lot.is(0.5) }) as const;
const nurbs = (lot: Lot) =>
  ({ type: 'nurbs', points: places(lot, 5), density: 3, rational: [1, 2, 1, 0.5, 1] }) as const;
const arc = (lot: Lot) =>
  ({
    type: 'arc',
    centre: lot.place(),
    start: lot.place(),
    axis: lot.direction(),
    angle: lot.between(1, 6),
    ...fidelity(lot),
  }) as const;

/** Of any degree. */
function segment(lot: Lot, mass: Mass): AnySkel {
  const degree = lot.one([0, 1, 2, 3]);
  const own = lot.many(degree + 1, (k) => (lot.between(-0.5, 1) * mass(1 + k)) / 3 ** k);
  return { type: 'segment', a: lot.place(), b: lot.place(), weights: own };
}

/** A star about the origin of its plane, with or without a hole; one in four crosses itself. */
function polygon(lot: Lot, mass: Mass): AnySkel {
  const turns = lot.is(0.25) ? 2 : 1;
  const corners = 7;
  const at = (i: number): Vec2 => {
    const radius = lot.unit * lot.between(1, 3);
    const angle = (i * turns * TAU) / corners;
    return [radius * cos(angle), radius * sin(angle)];
  };
  const k = 0.3 * lot.unit;
  const hole: Vec2[] = [
    [k, 0],
    [0, k],
    [-k, -k],
  ];
  const loops = [lot.many(corners, at), ...(lot.is(0.4) ? [hole] : [])];
  const plane = { origin: lot.place(), u: lot.direction(), v: lot.direction() };
  return { type: 'polygon', ...plane, loops, weight: lot.between(0.2, 1.5) * mass(2) };
}
