/**
 * Radii instead of weights: what people and silhouettes speak of.
 *
 * An infinite line of weight w has its isosurface at radius r where w ∫ f = T, a lone point where w f(r) = T, a plate's
 * surface is a distance r away where w ∬ f = T. A finite skel is thinner: the ends of a uniform Cauchy segment have 0.58–0.79
 * of its middle's radius; with its length or area given, its own middle is at r. 1/r needs the length,
 * 1/r and 1/r² the area: of whole lines and planes their field is infinite. Tai et al. 2004 (22)–(24) leave out cross terms
 * that are not small, so their ends come out at 0.42–0.83 T; a fit of several weights is the medial
 * skeleton's business.
 */
import { type Kernel, type KernelParams, LineFrame } from '../kernel/kernel.ts';
import { exp } from '../math/exp.ts';
import { GAUSS } from '../math/gaussLegendre.ts';
import { log } from '../math/log.ts';
import { PI } from '../math/trig.ts';
import { checkedParams, reach, whole } from './binding.ts';
import { FieldError } from './skeleton.ts';

/** Weight of a lone point with its isosurface `threshold` at `radius` mm. */
export function pointWeight(kernel: Kernel, params: KernelParams, radius: number, threshold: number): number {
  const { unit, exponent } = checked(kernel, params, radius, threshold);
  const r = radius / unit;
  return quotient(kernel, threshold, kernel.value(r * r, exponent) * whole(unit, kernel.homogeneity), radius);
}

/** Constant weight of a line: infinite, or `length` mm long with `radius` right in its middle. */
export function lineWeight(
  kernel: Kernel,
  params: KernelParams,
  radius: number,
  threshold: number,
  length = Infinity,
): number {
  const { unit, exponent } = checked(kernel, params, radius, threshold);
  const rho2 = (radius / unit) * (radius / unit);
  const line =
    length < Infinity
      ? middleOfLine(kernel, rho2, length / unit, exponent)
      : kernel.wholeLine?.(rho2, exponent);
  if (line === undefined) throw diverges(kernel, 'lines', 'length');
  return quotient(kernel, threshold, line * whole(unit, 1 + kernel.homogeneity), radius);
}

/** Weight of a plate: infinite, or a disc of `area` mm² with `radius` right over its middle. */
export function plateWeight(
  kernel: Kernel,
  params: KernelParams,
  radius: number,
  threshold: number,
  area = Infinity,
): number {
  const { unit, exponent } = checked(kernel, params, radius, threshold);
  const z2 = (radius / unit) * (radius / unit);
  const plate =
    area < Infinity
      ? middleOfDisc(kernel, z2, area / (unit * unit), exponent)
      : kernel.wholePlane?.(z2, exponent);
  if (plate === undefined || plate === Infinity) throw diverges(kernel, 'planes', 'area');
  return quotient(kernel, threshold, plate * whole(unit, 2 + kernel.homogeneity), radius);
}

/** s times the smallest radius, of the Cauchy kernel: 0.6…1 fit silhouettes to 0.1–0.8 % */
const SHARPNESS = 0.8;
/** where the Cauchy kernel in its own unit is one half: √(√2 − 1) */
const CAUCHY_HALF = 0.6435942529055827;

/** Width for a group whose smallest radius is `radius` mm, at which the kernel is half as far as the Cauchy kernel is. */
export function widthFor(kernel: Kernel, params: KernelParams, radius: number): KernelParams {
  const { exponent } = checked(kernel, params, radius, 1);
  if (kernel.homogeneity !== 0) return params;
  const half = reach((r2) => kernel.value(r2, exponent), 0.5, kernel.support);
  const unit = (radius / SHARPNESS) * (CAUCHY_HALF / half);
  const entries = kernel.params.map(({ name, min, max }) => {
    if (name === 'n') return [name, exponent] as const;
    return [name, Math.min(Math.max(name === 's' ? 1 / unit : unit, min), max)] as const;
  });
  return Object.fromEntries(entries);
}

function checked(kernel: Kernel, params: KernelParams, radius: number, threshold: number) {
  for (const [what, number] of [
    ['radius', radius],
    ['threshold', threshold],
  ] as const) {
    if (!(number > 0 && number < Infinity))
      throw new FieldError(`the ${what} must be above 0, found ${number}`);
  }
  const all = checkedParams(kernel, params);
  return { unit: kernel.unit(all, radius), exponent: all.n ?? 4 };
}

function quotient({ name, support }: Kernel, threshold: number, field: number, radius: number): number {
  const weight = threshold / field;
  if (weight < Infinity) return weight;
  const where = support < Infinity ? 'its support: a larger R reaches it' : 'what doubles hold';
  throw new FieldError(
    `no weight of the kernel ${name} reaches a radius of ${radius}: it is beyond ${where}`,
  );
}

function diverges({ name }: Kernel, what: string, need: string): FieldError {
  return new FieldError(
    `${what} of the kernel ${name} need their ${need}: without end their field is infinite`,
  );
}

function middleOfLine(kernel: Kernel, rho2: number, length: number, exponent: number): number {
  const frame = new LineFrame();
  const out = new Float64Array(3);
  const ends = { alpha: -0.5 * length, beta: 0.5 * length, length };
  Object.assign(frame, { rho2, ...ends, exponent, slopes: false });
  frame.weights[0] = 1;
  kernel.line(frame, out);
  return out[0]!;
}

/** π ∫ f dr² from z² to z² + area/π, in the logarithm of r². */
function middleOfDisc(kernel: Kernel, z2: number, area: number, exponent: number): number {
  const { nodes, weights } = GAUSS[16];
  const low = log(z2);
  const high = log(Math.min(z2 + area / PI, Math.max(kernel.support * kernel.support, z2)));
  const panels = Math.max(1, Math.ceil(high - low));
  const half = (0.5 * (high - low)) / panels;
  let sum = 0;
  for (let panel = 0; panel < panels; panel++) {
    const middle = low + (2 * panel + 1) * half;
    for (let i = 0; i < 16; i++) {
      const r2 = exp(middle + half * nodes[i]!);
      sum += weights[i]! * half * r2 * kernel.value(r2, exponent);
    }
  }
  return PI * sum;
}
