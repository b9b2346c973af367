/**
 * A flat plate with holes: a polygon skel a region (Zhu et al. 2011, §4.1), as thick as the brush says over its middle, its outline inset so that the
 * rounded rim comes to where the stroke is. How far depends on kernel, width and form, so it is measured: the field at the stroke says by how
 * many mm the rim is off, to first order, and places move by that, evened out along the loop, a few times over.
 */
import type { Kernel } from '../../kernel/kernel.ts';
import { add2, distance2, scale2 } from '../../math/tuple.ts';
import { crossingsOf, untangle } from '../../math/untangle.ts';
import type { Vec2 } from '../../math/vec.ts';
import { bindSkel } from '../../skeleton/index.ts';
import type { MedialGraph, MedialNode } from '../../skeleton/medial/axis.ts';
import { along, type Loop } from '../../skeleton/medial/outline.ts';
import { FieldError, type SkelField } from '../../skeleton/skeleton.ts';
import type { PolygonSkel } from '../../skeleton/skels.ts';
import { cyclesOf, graphOfLoops, type Region, regionsOf } from './cycles.ts';
import { fewOfLoop } from './few.ts';
import { type FormKind, type Ink, radiiOf, type Sum, widthForRadii } from './form.ts';
import { inset, type Rim, rimsOf } from './inset.ts';
import { loopsOf } from './soft.ts';

/** along a loop that was edited */
const PLACES = 200;
/** of half the thickness, mm that the rim may be off before a place moves again, and rounds of that */
const START = 0.45;
const ROUNDS = 5;
/** half thicknesses: places move no farther than this */
const FARTHEST = 1.5;
/** of the largest circle inside: what is narrow is no thicker than it is wide */
const THICKEST = 0.9;
/** of half the thickness, and of the size: what simplifying may lose */
const LOST = 0.06;
const LOST_OF_SIZE = 0.004;

interface Flat {
  readonly loops: Region;
  readonly radius: number;
}

interface Plate extends Flat {
  readonly weight: number;
}

export const plate: FormKind = {
  width(ink, kernel) {
    checkEdge(kernel);
    if (ink.skeleton)
      return widthForRadii(
        kernel,
        flatsOf(ink.skeleton).map(({ radius }) => radius),
      );
    return widthForRadii(kernel, regionsOf(loopsOf(ink)).length > 0 ? [ink.brush.radius] : []);
  },
  make(ink, sum) {
    checkEdge(sum.kernel);
    const { skeleton, brush } = ink;
    if (skeleton) {
      const plates = flatsOf(skeleton).map(({ loops, radius }) =>
        weighted(loops, radius, middleOf(dense(loops)), sum),
      );
      return plates.length > 0 ? { skeleton, skels: plates.map(skelOf) } : null;
    }
    const plates = regionsOf(loopsOf(ink)).map((region) => followed(region, brush.radius, sum, ink));
    if (plates.length === 0) return null;
    const nodes = plates.flatMap(({ loops, radius }) => loops.map((loop) => nodesOf(loop, radius)));
    return { skeleton: graphOfLoops(nodes), skels: plates.map(skelOf) };
  },
};

function checkEdge({ name, edge }: Kernel): void {
  if (!edge) throw new FieldError(`plates have no field of the kernel ${name}`);
}

/** A skeleton by hand: its cycles, as thick as their circles are in the mean. */
function flatsOf(skeleton: MedialGraph): readonly Flat[] {
  const cycles = cyclesOf(skeleton);
  const loops = cycles.map((cycle) => cycle.map(({ at }) => at));
  const radii = radiiOf({ nodes: cycles.flat(), links: [] });
  const radius = radii.reduce((a, b) => a + b, 0) / radii.length;
  return regionsOf(loops.length === 0 ? [] : simple(loops)).map((region) => ({ loops: region, radius }));
}

/** Inner loops stay holes, however they were turned. */
function simple(loops: readonly Loop[]): readonly Loop[] {
  if (crossingsOf(loops).length === 0) return loops;
  return regionsOf(loops).flatMap(([outer, ...holes]) => untangle(outer!, holes));
}

const nodesOf = (loop: Loop, radius: number): readonly MedialNode[] => loop.map((at) => ({ at, radius }));

const skelOf = ({ loops, weight }: Omit<Plate, 'radius'>): PolygonSkel => ({
  type: 'polygon',
  origin: [0, 0, 0],
  u: [1, 0, 0],
  v: [0, 1, 0],
  loops,
  weight,
});

/** As thick over its middle as it is to be. */
function weighted(loops: Region, radius: number, [x, y]: Vec2, { kernel, params, threshold }: Sum): Plate {
  const field = bindSkel(skelOf({ loops, weight: 1 }), kernel, params).value(x, y, radius);
  const weight = threshold / field;
  if (!(field > 0 && weight < Infinity)) {
    throw new FieldError(`no weight of the kernel ${kernel.name} makes a plate ${2 * radius} mm thick`);
  }
  return { loops, radius, weight };
}

/** Rims of as many places as strokes have, for what has few. */
function dense(loops: Region): readonly (readonly Rim[])[] {
  return rimsOf(loops.map((loop) => along([loop], lengthOf(loop) / PLACES)));
}

/** Of the largest circle inside. */
function middleOf(rims: readonly (readonly Rim[])[]): Vec2 {
  const { at, inward, inside } = rims.flat().reduce((best, rim) => (rim.inside > best.inside ? rim : best));
  return add2(at, scale2(inward, inside));
}

/** The plate whose rim is where the region's outline is. */
function followed(region: Region, wanted: number, sum: Sum, { isRough }: Ink): Plate {
  const rims = rimsOf(region);
  const widest = rims.flat().reduce((most, { inside }) => Math.max(most, inside), 0);
  const radius = Math.min(wanted, THICKEST * widest);
  const middle = middleOf(rims);
  let by = rims.map((loop) => loop.map(() => START * radius));
  let plate = weighted(fewer(inset(rims, by), radius), radius, middle, sum);
  for (let round = 0; round < (isRough ? 1 : ROUNDS); round++) {
    const field = bindSkel(skelOf(plate), sum.kernel, sum.params);
    by = rims.map((loop, l) => {
      const off = loop.map((rim) => outBy(field, rim, sum.threshold, radius));
      const even = evened(loop, off, radius);
      return loop.map((_, i) => clamp(by[l]![i]! + even[i]!, FARTHEST * radius));
    });
    plate = weighted(fewer(inset(rims, by), radius), radius, middle, sum);
  }
  return plate;
}

/** mm by which the rim lies outside the stroke at one of its places, to first order. */
function outBy(field: SkelField, { at, inward }: Rim, threshold: number, radius: number): number {
  const value = new Float64Array(4);
  field.add(at[0], at[1], 0, 1, value);
  const slope = value[1]! * inward[0] + value[2]! * inward[1];
  const most = 0.3 * radius;
  const off = (value[0]! - threshold) / slope;
  if (!(slope > 0)) return value[0]! > threshold ? most : -most;
  return clamp(off, most);
}

/** Means over as much of a loop to either side as the plate is half thick: what is narrower a rim cannot follow. */
function evened(loop: readonly Rim[], values: readonly number[], radius: number): readonly number[] {
  const n = loop.length;
  const length = (i: number, j: number) => distance2(loop[i]!.at, loop[j]!.at);
  return values.map((value, i) => {
    let [sum, count] = [value, 1];
    for (const side of [1, -1]) {
      let far = 0;
      for (let k = 1; k < n / 2; k++) {
        const j = (i + side * k + n * k) % n;
        far += length(j, (j - side + n) % n);
        if (far > 0.5 * radius) break;
        sum += values[j]!;
        count++;
      }
    }
    return sum / count;
  });
}

/** Loops of few places; of more, or of all, where they would cross. */
function fewer(loops: readonly Loop[], radius: number): readonly Loop[] {
  const size = loops.flat().reduce((most, [x, y]) => Math.max(most, Math.abs(x), Math.abs(y)), 0);
  for (let lost = Math.max(LOST * radius, LOST_OF_SIZE * size); lost > 1e-4 * size; lost *= 0.3) {
    const few = loops.map((loop) => fewOfLoop(nodesOf(loop, radius), lost).map((i) => loop[i]!));
    if (crossingsOf(few).length === 0) return few;
  }
  return loops;
}

const clamp = (value: number, most: number) => Math.min(Math.max(value, -most), most);

const lengthOf = (loop: Loop): number => loop.reduce((sum, p, i) => sum + distance2(p, loop.at(i - 1)!), 0);
