/** The structs of skels, declared once: packed in records.ts, generated into WGSL as record/point, record/segment, …. */
import { record } from '../math/record.ts';

/** Which kernel, and what it wants to know besides the frame; `scale`: kernel units in a mm. */
const KERNEL_MEMBERS = { kernel: 'u32', exponent: 'f32', floor2: 'f32', scale: 'f32' } as const;

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
  /** of its edges, and one beyond the last */
  first: 'u32',
  end: 'u32',
  ...KERNEL_MEMBERS,
});

export const EDGE = record('Edge', { start: 'vec2f', end: 'vec2f', u: 'vec2f', length: 'f32' });

/** As `type` of a skel says; the place in the list is the number in WGSL. */
export const PRIMITIVES = ['point', 'segment', 'polygon'] as const;
export type Primitive = (typeof PRIMITIVES)[number];
