/**
 * What a file may hold. Everything the program itself makes lies well inside; what lies outside is refused at the
 * border with its place, so that nothing further in has to ask. `docs/format.md` lists the same numbers.
 */
import { FARTHEST } from '../stroke/stroke.ts';
import { LONGEST_NAME } from './command/renamePart.ts';
import { RADII } from './radii.ts';

/** The smallest and the largest value allowed. */
export interface Range {
  readonly min: number;
  readonly max: number;
}

const around = (max: number): Range => ({ min: -max, max });

export const RANGES = {
  /** mm: samples, planes, placements */
  coordinate: around(FARTHEST),
  /** mm: what is looked at may lie beside what is drawn */
  pivot: around(1e9),
  /** mm visible */
  height: { min: 1e-9, max: 1e9 },
  /** degrees, beside 0 = orthographic */
  fov: { min: 1, max: 120 },
  /** mm */
  radius: RADII,
  /** of skeletons, mm */
  skeletonRadius: { min: 1e-6, max: FARTHEST },
  /** of groups: λ, and what breadth, depth and radii are multiplied by */
  weight: around(100),
  factor: { min: 0.01, max: 100 },
  /** α of cross sections */
  exponent: { min: 0.3, max: 100 },
  density: { min: 1, max: 64 },
  /** T */
  fieldThreshold: { min: 1e-6, max: 1e6 },
  levels: { min: 0, max: 6 },
  /** of finishes: factors of ambient and diffuse light, strength and exponent of the highlight */
  light: { min: 0, max: 2 },
  specular: { min: 0, max: 1 },
  shininess: { min: 1, max: 200 },
  /** along construction curves */
  u: { min: 0, max: 1 },
  /** mm: half a chord */
  half: { min: 1e-6, max: FARTHEST },
  /** spans of a control mesh, and how often they are halved */
  rows: { min: 1, max: 256 },
  columns: { min: 3, max: 256 },
  subdivisions: { min: 0, max: 5 },
  /** how many more of them */
  finer: { min: -5, max: 5 },
  pressure: { min: 0, max: 1 },
  /** degrees */
  tilt: around(90),
  /** ms; some pens report a sample before the touch that began the stroke */
  time: around(1e9),
  /** of creases and overlaps */
  threshold: { min: 0, max: 1 },
  nextId: { min: 1, max: Number.MAX_SAFE_INTEGER },
  /** a component of a unit vector or a unit quaternion */
  component: around(1.001),
} as const satisfies Record<string, Range>;

/** Planes and rotations may be off by this much, so that four digits written by hand are enough. */
export const UNIT_TOLERANCE = 1e-3;

export const LIMITS = {
  /** bytes of a file: a character may take four */
  bytes: 256 * 1024 * 1024,
  /** characters of a file */
  text: 64 * 1024 * 1024,
  /** lists and objects inside each other: a tree of 200 nodes takes two each, a script that loads a document 16 more */
  depth: 420,
  commands: 50_000,
  /** in a document */
  strokes: 10_000,
  /** in a sum of a body, or parts of one of its operations */
  skels: 100_000,
  /** circles of a skeleton that was edited */
  nodes: 2_000,
  /** of a surface, and strokes drawn over one of them */
  sections: 64,
  redraws: 64,
  bends: 16,
  /** factors of a profile */
  profile: 64,
  /** in a stroke: 7 minutes of a pen that reports 240 times a second */
  samples: 100_000,
  /** in a document, values of bodies among them: what is read can be saved, within the characters of a file, and be read again */
  samplesInAll: 400_000,
  /** characters: ids and names of parts */
  name: LONGEST_NAME,
  /** characters: names of drawings, as long as a file's may be */
  drawingName: 255,
} as const;
