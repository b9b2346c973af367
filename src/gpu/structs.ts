/**
 * The records of a field on the GPU, declared once: packed by heap.ts, generated into WGSL as record/segment and so on, each
 * with its loader. All lie in one buffer (typed arrays are 1.7 times as fast on SwiftShader, but trees would need more bindings than
 * WebGPU promises); what refers to another record holds the number of the 16 bytes it begins at.
 */
import { record } from '../math/record.ts';

/** What the kernel wants to know besides the frame; `scale`: kernel units in a mm. */
const KERNEL_MEMBERS = { exponent: 'f32', floor2: 'f32', scale: 'f32' } as const;

export const POINT = record('Point', { at: 'vec3f', weight: 'f32', ...KERNEL_MEMBERS });

export const SEGMENT = record('Segment', {
  a: 'vec3f',
  length: 'f32',
  b: 'vec3f',
  degree: 'u32',
  u: 'vec3f',
  ...KERNEL_MEMBERS,
  weights: 'vec4f',
});

/** Lengths but the origin's are in kernel units. */
export const POLYGON = record('Polygon', {
  /** the middle, rounded; mm */
  origin: 'vec3f',
  /** of the plane above the rounded origin */
  lift: 'f32',
  u: 'vec3f',
  weight: 'f32',
  v: 'vec3f',
  /** of the circle around the origin that holds the polygon */
  radius: 'f32',
  n: 'vec3f',
  support: 'f32',
  /** of its edges, and beyond the last */
  first: 'u32',
  end: 'u32',
  ...KERNEL_MEMBERS,
});

export const EDGE = record('Edge', { start: 'vec2f', end: 'vec2f', u: 'vec2f', length: 'f32' });

/** A skel in a sum. */
export const TERM = record('Term', {
  colour: 'vec3f',
  factor: 'f32',
  skel: 'u32',
  /** 0 for plain skels */
  warp: 'u32',
  /** numbers of ingredients */
  kernel: 'u32',
  primitive: 'u32',
});

/** A cross section of a skel's own; `axes` are the columns x, y, z of its frame. */
export const WARP = record('Warp', {
  origin: 'vec3f',
  exponent: 'f32',
  axes: 'mat3x3f',
  scale: 'vec2f',
  section: 'u32',
  /** a Profile, for drawn sections */
  profile: 'u32',
});

/** The 24 inner radii of a drawn section, four of them each. */
export const PROFILE = record('Profile', {
  a: 'vec4f',
  b: 'vec4f',
  c: 'vec4f',
  d: 'vec4f',
  e: 'vec4f',
  f: 'vec4f',
});

/** Σ λ F − T. The colour is for where no skel reaches. */
export const SUM = record('Sum', { colour: 'vec3f', threshold: 'f32', first: 'u32', end: 'u32' });

/** The numbers in the order in which the shape's function takes them. */
export const SHAPE = record('Shape', {
  colour: 'vec3f',
  kind: 'u32',
  a: 'vec4f',
  b: 'vec4f',
  c: 'vec4f',
});

/** Where a leaf is: local = inverse · (p − origin) + low, `low` being what rounding the origin lost; value by `scale`. */
export const PLACE = record('Place', {
  inverse: 'mat3x3f',
  origin: 'vec3f',
  scale: 'f32',
  low: 'vec3f',
});

/** One step of a program: take a leaf or what was put aside, and do something with it (program.ts). */
export const STEP = record('Step', {
  take: 'u32',
  /** the Sum or Shape */
  at: 'u32',
  /** 0 where it was not moved */
  place: 'u32',
  role: 'u32',
  /** a0, a1, a2 of a blend; t of a morph */
  amounts: 'vec3f',
  operation: 'u32',
  /** −1 for what is a union of the operands turned inside out */
  outer: 'f32',
  /** of the second operand */
  sign: 'f32',
  /** 1 where the second operand was evaluated first */
  swapped: 'u32',
  /** of a leaf the number of its first smooth side, SIDES times, and how many it has (branches.wgsl) */
  sides: 'u32',
});

/** What culling knows of a step's leaf (bricks/bounds.ts): a table beside the steps, after all other records. */
export const LEAF = record('Leaf', {
  /** by which its frame stretches lengths at most */
  stretch: 'f32',
  /** of sums: what may be missed of the field for a millimetre that the surface may be off */
  slope: 'f32',
  /** and at all */
  most: 'f32',
  /** of its terms, in their order */
  bounds: 'u32',
  /** n of (core + r²)^(−n/2), where all terms are points or lines of that kernel, each with a weight of one sign; else 0 */
  power: 'f32',
  core: 'f32',
  /** whole rows */
  unused: 'vec2f',
});

/** What bounds on a term know of it, once; kernel units. */
export const BOUND = record('Bound', {
  /** of |λ w| */
  most: 'f32',
  /** 1 or −1 where λ w has one sign, else 0 */
  sign: 'f32',
  /** length or area, as often as it is gone round; 1 for points */
  size: 'f32',
  turns: 'f32',
  /** CHANGE (bricks/termBound.ts) */
  change: 'u32',
  dimension: 'u32',
  /** (core + r²)^(−power/2) */
  core: 'f32',
  power: 'f32',
  /** of the line or plane without ends at core + r² = 1 */
  whole: 'f32',
  /** nearer than that singular kernels are clamped, or float32 cannot tell */
  least: 'f32',
  support: 'f32',
  /** of a millimetre */
  per: 'f32',
  /** |w⁽ʲ⁾| l^j / j! in parts of the largest |w| */
  bends: 'vec4f',
  /** of a cross section that is not round: how its map bends (section.ts); of a drawn one the largest |R′|, the least and the largest R */
  section: 'vec4f',
});

/** The first record of a field: its steps, and beyond the last; for pairs its terms. */
export const PROGRAM = record('Program', { first: 'u32', end: 'u32' });

export const RECORDS = {
  point: POINT,
  segment: SEGMENT,
  polygon: POLYGON,
  edge: EDGE,
  term: TERM,
  warp: WARP,
  profile: PROFILE,
  sum: SUM,
  shape: SHAPE,
  place: PLACE,
  step: STEP,
  program: PROGRAM,
  leaf: LEAF,
  bound: BOUND,
} as const;
