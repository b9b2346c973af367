/**
 * What the field page can be set to: one table of numbers, one of choices. Sliders, the address and the defaults all come from
 * these tables, so a new control is a line here and its use in tree.ts.
 */
import { kernels } from '../../kernel/index.ts';
import type { ParamSpec } from '../../kernel/kernel.ts';
import { shapes } from '../../shape/index.ts';

export interface NumberSpec {
  readonly label: string;
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  readonly default: number;
  /** the slider is even in the logarithm */
  readonly log?: boolean;
  /** values are its multiples; three digits count where there is none */
  readonly step?: number;
}

export interface ChoiceSpec {
  readonly label: string;
  readonly options: readonly (readonly [id: string, name: string])[];
  readonly default: string;
}

const number = (label: string, min: number, max: number, value: number, unit = ''): NumberSpec => ({
  label,
  unit,
  min,
  max,
  default: value,
});
const log = (...of: Parameters<typeof number>): NumberSpec => ({ ...number(...of), log: true });
const stepped = (step: number, ...of: Parameters<typeof number>): NumberSpec => ({ ...number(...of), step });

/** More than three decades are nothing a slider can show: it spans this factor to both sides of the default. */
const SPAN = 50;

/** A slider for a parameter, from what its kernels allow. */
function parameter(name: ParamSpec['name'], label: string, unit: string): NumberSpec {
  const spec = kernels.flatMap(({ params }) => params).find((param) => param.name === name)!;
  if (spec.max / spec.min < 1000) return number(label, spec.min, spec.max, spec.default, unit);
  return log(label, spec.default / SPAN, spec.default * SPAN, spec.default, unit);
}

export const NUMBERS = {
  radius: log('Radius', 2, 60, 16, 'mm'),
  radiusEnd: log('Radius at the other end', 2, 60, 8, 'mm'),
  weight: log('Weight', 1e-4, 1e9, 1),
  weight1: number('Weight, 2nd ordinate', 0, 3, 0.6, '×'),
  weight2: number('Weight, 3rd ordinate', 0, 3, 0.3, '×'),
  weight3: number('Weight, 4th ordinate', 0, 3, 1, '×'),
  s: parameter('s', 'Sharpness s', '1/mm'),
  // larger than any preset's radius
  R: log('Support R', 1, 500, 40, 'mm'),
  n: parameter('n', 'Smoothness n', ''),
  // at 10 a body of the default radius is as steep as the distance of a shape, with which it may be blended
  T: stepped(0.25, 'Threshold T', 0.25, 20, 10),
  carve: stepped(0.05, 'Factor λ', -5, 0, 0),
  carveRadius: log('Radius', 2, 60, 12, 'mm'),
  carveX: stepped(1, 'Along x', -80, 80, 20, 'mm'),
  carveY: stepped(1, 'Along y', -80, 80, 10, 'mm'),
  alpha: log('Exponent α', 0.3, 100, 4),
  edge: log('Exponent α', 2, 100, 8),
  betaX: log('Scale βx', 0.2, 5, 1, '×'),
  betaY: log('Scale βy', 0.2, 5, 1, '×'),
  thickness: log('Half the thickness, βy', 1, 60, 8, 'mm'),
  a0: stepped(0.25, 'Amount a₀', -15, 15, 6),
  a1: log('Reach a₁ at the body', 0.1, 50, 6),
  a2: log('Reach a₂ at the shape', 0.1, 50, 6),
  t: stepped(0.01, 'Time t', 0, 1, 0.5),
  example: stepped(1, 'Example', 0, 9, 0),
  shapeSize: log('Size', 0.1, 10, 3, '×'),
  shapeX: stepped(1, 'Along x', -100, 100, 30, 'mm'),
  shapeTurn: stepped(5, 'Turned about z', -180, 180, 30, '°'),
  shapeTilt: stepped(5, 'Turned about x', -180, 180, 60, '°'),
  resolution: stepped(8, 'Cells along the longest side', 16, 256, 104),
} as const satisfies Record<string, NumberSpec>;

export const CHOICES = {
  skeleton: {
    label: 'Skeleton',
    options: [
      ['animal', 'Animal'],
      ['point', 'Point'],
      ['segment', 'Segment'],
      ['crossed', 'Crossed'],
      ['tree', 'Tree'],
      ['ring', 'Ring'],
      ['curve', 'NURBS'],
      ['spline', 'Spline'],
      ['arc', 'Arc'],
      ['profile', 'Weight curve'],
      ['concave', 'Concave'],
      ['holed', 'Hole'],
    ],
    default: 'animal',
  },
  kernel: {
    label: 'Kernel',
    options: kernels.map(({ name, label }) => [name, label] as const),
    default: kernels[0]!.name,
  },
  by: {
    label: 'Thickness by',
    options: [
      ['radius', 'Radius'],
      ['weight', 'Weight'],
    ],
    default: 'radius',
  },
  degree: {
    label: 'Degree of the weight',
    options: [
      ['0', '0'],
      ['1', '1'],
      ['2', '2'],
      ['3', '3'],
    ],
    default: '0',
  },
  width: {
    label: 'Width of the kernel',
    options: [
      ['fitted', 'From the radius'],
      ['own', 'Set here'],
    ],
    default: 'fitted',
  },
  section: {
    label: 'Cross section',
    options: [
      ['round', 'Round'],
      ['superQuadric', 'Super-quadric'],
      ['extrusion', 'Extrusion'],
      ['polar', 'Drawn'],
    ],
    default: 'round',
  },
  profile: {
    label: 'Drawn profile',
    options: [
      ['ellipse', 'Ellipse'],
      ['square', 'Square'],
      ['star', 'Star'],
    ],
    default: 'star',
  },
  operation: {
    label: 'Operation',
    options: [
      ['none', 'None'],
      ['union', 'Union'],
      ['intersection', 'Intersect'],
      ['subtraction', 'Subtract'],
      ['blend', 'Blend'],
      ['morph', 'Morph'],
    ],
    default: 'none',
  },
  form: {
    label: 'Form',
    options: [
      ['hard', 'Hard'],
      ['smooth', 'Smooth'],
    ],
    default: 'smooth',
  },
  shape: {
    label: 'Shape',
    options: Object.values(shapes).map(({ name, label }) => [name, label] as const),
    default: 'torus',
  },
  style: {
    label: 'Style',
    options: [
      ['toon', 'Toon'],
      ['hbed-lines', 'Lines'],
      ['hbed-ink', 'Ink'],
      ['gouraud', 'Shaded'],
    ],
    default: 'toon',
  },
  where: {
    label: 'Made by',
    options: [
      ['cpu', 'CPU'],
      ['gpu', 'GPU'],
    ],
    default: 'cpu',
  },
  surface: {
    label: 'Seen',
    options: [
      ['mesh', 'Triangles'],
      ['exact', 'Rays'],
    ],
    default: 'mesh',
  },
  rays: {
    label: 'Rays',
    options: [
      ['bricks', 'By bricks'],
      ['zhu', 'Zhu’s, compared'],
    ],
    default: 'bricks',
  },
  volumes: {
    label: 'Bounding volumes',
    options: [
      ['hidden', 'Hidden'],
      ['shown', 'Shown'],
    ],
    default: 'hidden',
  },
} as const satisfies Record<string, ChoiceSpec>;

export type NumberKey = keyof typeof NUMBERS;
export type ChoiceKey = keyof typeof CHOICES;
export type FieldState = Readonly<Record<NumberKey, number> & Record<ChoiceKey, string>>;

export const NUMBER_KEYS = Object.keys(NUMBERS) as NumberKey[];
export const CHOICE_KEYS = Object.keys(CHOICES) as ChoiceKey[];

const defaults = <K extends string>(keys: readonly K[], of: Record<K, { readonly default: unknown }>) =>
  keys.map((key) => [key, of[key].default]);

export const DEFAULT_STATE = Object.fromEntries([
  ...defaults(NUMBER_KEYS, NUMBERS),
  ...defaults(CHOICE_KEYS, CHOICES),
]) as FieldState;

/** As a slider leaves it: within the range, with as many digits as one reads. */
export function rounded({ min, max, step }: NumberSpec, value: number): number {
  const kept = step ? Number((Math.round(value / step) * step).toFixed(4)) : Number(value.toPrecision(3));
  return Math.min(Math.max(kept, min), max);
}

/** 0–1, where a value is on its slider. */
export function toSlider({ min, max, log: even }: NumberSpec, value: number): number {
  return even ? Math.log(value / min) / Math.log(max / min) : (value - min) / (max - min);
}

export function fromSlider(spec: NumberSpec, place: number): number {
  const { min, max, log: even } = spec;
  return rounded(spec, even ? min * (max / min) ** place : min + (max - min) * place);
}
