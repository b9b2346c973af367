/**
 * Reference vectors: fields of points, segments and polygons with values and gradients that quadrature found, a family a
 * file. The scale that errors are relative to is the field of the unbounded skel at no distance, where there is one.
 */
import * as v from 'valibot';
import { checked } from '../document/check.ts';
import { readJson } from '../document/json.ts';
import { kernelNamed } from '../kernel/index.ts';
import type { Kernel, KernelParams } from '../kernel/kernel.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Skel } from '../skeleton/skels.ts';

/** What the files call kernels that have another name here. */
const NAMES: Readonly<Record<string, string>> = {
  inverse1: 'inverse',
  inverse2: 'inverseSquared',
  inverse3: 'inverseCubic',
  inverse5: 'inverseQuintic',
};

export interface VectorCase {
  readonly family: 'point' | 'segment' | 'polygon';
  /** as the file calls it */
  readonly kernelName: string;
  readonly kernel: Kernel;
  readonly params: KernelParams;
  readonly skel: Skel;
  readonly p: Vec3;
  readonly value: number;
  readonly gradient: Vec3;
  /** file, number in it from 0, and the tag, if it has one */
  readonly file: string;
  readonly index: number;
  readonly tag: string;
  readonly scale: Scale;
}

/** What errors are relative to. */
export interface Scale {
  readonly value: number;
  readonly gradient: number;
}

/** Other fields are left alone: files may say more. A field that is missing is named by what it should be. */
const object = <const E extends v.ObjectEntries>(entries: E, what: string) =>
  v.object(entries, ({ path }) => {
    const entry = entries[String(path?.[0]?.key)] as { readonly message?: unknown } | undefined;
    return typeof entry?.message === 'string' ? entry.message : what;
  });

const number = v.pipe(v.number('a number'), v.finite('a finite number'));
const three = v.pipe(v.tuple([number, number, number], 'three numbers'), v.readonly());
const two = v.pipe(v.tuple([number, number], 'two numbers'), v.readonly());

const common = {
  kernel: v.pipe(
    v.string('the name of a kernel'),
    v.check((name) => kernelNamed(NAMES[name] ?? name) !== undefined, 'the name of a kernel'),
  ),
  params: v.record(v.string(), number, 'an object of numbers'),
  p: three,
  value: number,
  gradient: three,
  tag: v.optional(v.string('a text'), ''),
};

const FAMILIES = {
  point: object({ ...common, q: three, weight: number }, 'a case of the family point'),
  segment: object(
    {
      ...common,
      a: three,
      b: three,
      weights: v.pipe(
        v.array(number, 'a list of numbers'),
        v.minLength(1, 'one to four numbers'),
        v.maxLength(4, 'one to four numbers'),
      ),
    },
    'a case of the family segment',
  ),
  polygon: object(
    {
      ...common,
      origin: three,
      u: three,
      v: three,
      loops: v.array(
        v.pipe(v.array(two, 'a list of points'), v.minLength(3, 'at least three points')),
        'a list of loops',
      ),
    },
    'a case of the family polygon',
  ),
};

type Family = keyof typeof FAMILIES;
type Raw<F extends Family> = v.InferOutput<(typeof FAMILIES)[F]>;

const fileOf = (family: Family) =>
  object(
    {
      family: v.picklist(Object.keys(FAMILIES) as Family[], 'point, segment or polygon'),
      cases: v.pipe(
        v.array(FAMILIES[family] as v.GenericSchema, 'a list of cases'),
        v.minLength(1, 'at least one case'),
      ),
    },
    'an object with family and cases',
  );

/** Throws FileError. */
export function readVectors(text: string, file: string): readonly VectorCase[] {
  const data = readJson(text, file, 'a file of reference vectors');
  const named = (data as { readonly family?: unknown }).family;
  const family = Object.keys(FAMILIES).find((known) => known === named) as Family | undefined;
  const { cases } = checked(fileOf(family ?? 'point'), data, { file });
  return cases.map((raw, index) => {
    const { kernel: kernelName, params, p, value, gradient, tag } = raw as Raw<Family>;
    const skel = skelOf(family!, raw);
    const kernel = kernelNamed(NAMES[kernelName] ?? kernelName)!;
    const about = { family: family!, kernelName, kernel, params, skel, p, value, gradient, file, index, tag };
    return { ...about, scale: scaleOf(about) };
  });
}

function skelOf(family: Family, raw: unknown): Skel {
  if (family === 'point') {
    const { q, weight } = raw as Raw<'point'>;
    return { type: 'point', at: q, weight };
  }
  if (family === 'segment') {
    const { a, b, weights } = raw as Raw<'segment'>;
    return { type: 'segment', a, b, weights };
  }
  const { origin, u, v: second, loops } = raw as Raw<'polygon'>;
  return { type: 'polygon', origin, u, v: second, loops, weight: 1 };
}

function scaleOf(about: Omit<VectorCase, 'scale'>): Scale {
  const { kernel, params, skel, p, value, gradient } = about;
  const height = skel.type === 'polygon' ? heightOver(skel, p) : 0;
  const unit = kernel.unit(params, height);
  const steep = Math.hypot(...gradient);
  const most = unboundedField(skel, kernel, params.n ?? 4, unit);
  return {
    value: Math.max(Math.abs(value), most),
    gradient: Math.max(steep, most > 0 ? most / unit : 0),
  };
}

/** At no distance; at its own height over a polygon for singular kernels; 0 where that is infinite. */
function unboundedField(skel: Skel, kernel: Kernel, exponent: number, unit: number): number {
  const isSingular = kernel.homogeneity < 0;
  if (skel.type === 'polygon') {
    const plate = kernel.wholePlane?.(isSingular ? 1 : 0, exponent) ?? 0;
    return plate < Infinity ? plate * unit ** (2 + kernel.homogeneity) : 0;
  }
  if (isSingular) return 0;
  if (skel.type === 'point') return Math.abs(skel.weight);
  const { a, b, weights } = skel;
  const length = Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  const most = weights.reduce((sum, weight, k) => sum + Math.abs(weight) * length ** k, 0);
  return most * unit * (kernel.wholeLine?.(0, exponent) ?? 0);
}

function heightOver({ origin, u, v: w }: Extract<Skel, { readonly type: 'polygon' }>, p: Vec3): number {
  const n = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]] as const;
  const along = n[0] * (p[0] - origin[0]) + n[1] * (p[1] - origin[1]) + n[2] * (p[2] - origin[2]);
  return Math.abs(along) / Math.hypot(...n);
}
