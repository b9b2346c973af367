/** A tree with every node, skel, shape and section there is, and every field of each. */

import type { AnySkel } from '../../src/field/expand.ts';
import type { FieldNode, SkelsNode, Term } from '../../src/field/node.ts';
import type { Warp } from '../../src/field/warp.ts';
import { kernels } from '../../src/kernel/index.ts';
import { type Shape, shapes } from '../../src/shape/index.ts';

const line = {
  type: 'polyline',
  points: [
    [0, 0, 0],
    [4, 1, 0],
    [6, 5, 1],
  ],
  closed: false,
} as const;
const curve = {
  type: 'nurbs',
  points: [
    [0, 0, 0],
    [3, 0, 0],
    [3, 3, 0],
    [6, 3, 2],
  ],
  density: 2,
} as const;
const arc = {
  type: 'arc',
  centre: [0, 0, 0],
  start: [5, 0, 0],
  axis: [0, 1, 0],
  angle: 2,
  fieldError: 0.5,
  distance: 1,
} as const;
const square = [
  [-2, -2],
  [2, -2],
  [2, 2],
  [-2, 2],
] as const;

export const SKELS: readonly AnySkel[] = [
  { type: 'point', at: [1, 2, 3], weight: 2 },
  { type: 'point', at: [1, 2, 3], radius: 2 },
  { type: 'segment', a: [0, 0, 0], b: [5, 0, 0], weights: [1, 0.1, 0.01, 0.001] },
  { type: 'segment', a: [0, 0, 0], b: [5, 0, 0], radii: [2, 1] },
  { type: 'polygon', origin: [0, 0, 0], u: [1, 0, 0], v: [0, 0, 1], loops: [square], weight: 1 },
  { ...line, weights: [1, 2, 1] },
  { ...line, radii: [1, 2, 1] },
  { ...curve, weights: [1, 1, 2, 1], rational: [1, 2, 2, 1], knots: [0, 0, 0, 0, 1, 1, 1, 1] },
  { ...curve, radii: [1, 1, 2, 1] },
  {
    type: 'profile',
    points: [
      [0, 0, 0],
      [5, 0, 0],
    ],
    curve: {
      type: 'keys',
      keys: [
        { at: 0, weight: 1, tension: 0.5, continuity: -0.5, bias: 0.1 },
        { at: 1, weight: 2 },
      ],
    },
  },
  {
    type: 'profile',
    points: [
      [0, 0, 0],
      [5, 0, 0],
    ],
    curve: { type: 'bezier', ordinates: [1, 2, 2, 1] },
  },
  { ...arc, weights: [1, 2] },
  { ...arc, radii: [1, 2] },
  {
    type: 'quadratic',
    points: [
      [0, 0, 0],
      [3, 3, 0],
      [6, 0, 0],
    ],
    weights: [1, 2],
    fieldError: 0.5,
    distance: 1,
  },
];

const SECTIONS: readonly Warp['section'][] = [
  { type: 'round' },
  { type: 'superQuadric', exponent: 4 },
  { type: 'extrusion', exponent: 8 },
  { type: 'polar', radii: Array.from({ length: 24 }, (_, i) => 1 + 0.2 * (i % 2)) },
];

const bent = (section: Warp['section']): Term => ({
  skel: { type: 'segment', a: [0, 0, 0], b: [8, 0, 0], weights: [2] },
  factor: 0.5,
  warp: { section, scale: [1, 1.5], up: [0, 1, 0], along: [1, 0, 0] },
  colour: [0, 0.5, 1],
});

/** The kernel's parameters at their defaults, all of them said. */
const sumOf = ({ name, params }: (typeof kernels)[number]): SkelsNode => ({
  type: 'skels',
  kernel: name,
  params: Object.fromEntries(params.map((spec) => [spec.name, spec.default])),
  threshold: 0.5,
  skels: [{ skel: { type: 'point', at: [0, 0, 0], weight: 5 } }],
});

const SUM: SkelsNode = {
  type: 'skels',
  kernel: 'cauchy',
  params: { s: 0.5 },
  threshold: 0.5,
  skels: [...SKELS.map((skel): Term => ({ skel })), ...SECTIONS.map(bent)],
  colour: [0.9, 0.2, 0.1],
};

const bodyOf = (shape: Shape): FieldNode => ({ type: 'shape', shape, colour: [0.1, 0.2, 0.3] });

export const EVERY_NODE: FieldNode = {
  type: 'union',
  form: 'smooth',
  parts: [
    SUM,
    {
      type: 'intersection',
      form: 'hard',
      parts: Object.values(shapes).map(({ examples }) => bodyOf(examples[0]!)),
    },
    { type: 'subtraction', form: 'hard', parts: kernels.map(sumOf) },
    { type: 'blend', a: bodyOf({ type: 'sphere', radius: 3 }), b: SUM, a0: 1, a1: 2, a2: 3 },
    {
      type: 'morph',
      from: { type: 'shape', shape: { type: 'box', half: [1, 2, 3] } },
      to: { type: 'affine', matrix: [1, 0, 0, 5, 0, 2, 0, 0, 0, 0.1, 1, 0], node: SUM },
      t: 0.25,
    },
  ],
};
