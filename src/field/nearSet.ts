/**
 * Fields under an operation as they are within a cube: each part as it is there. Of a hard union (and of what is one inside out) only
 * those are left that may be the largest somewhere in the cube. What parts miss is stretched by the operations that it passes
 * through, so that their shares of the budget are smaller.
 */
import type { FieldValue } from '../skeleton/skeleton.ts';
import { colourOf, combinedValue, evaluateOf, type Kind, Scratch, signsOf } from './fold.ts';
import { hardUnion } from './hardUnion.ts';
import { CORNERS } from './hermite.ts';
import {
  type BrickCorners,
  branchOf,
  type Changes,
  isFaceOf,
  type Near,
  type NearLeaf,
  type Ray,
  type Way,
} from './near.ts';
import { type Colour, commonColour } from './node.ts';
import type { Operation } from './operation.ts';

/** of what a ray has before it: tries of blends, shorter each, until it is next to nothing */
const SHORTER = 0.5;
const SHORTEST = 1e-7;

const partRange = new Float64Array(2);
const blendRange = new Float64Array(2);

/** A part that was left out. */
interface Dropped {
  readonly part: Near;
  readonly way: Way;
}

/** Parts that were left out here, and in the cubes around. */
interface AllDropped {
  readonly here: readonly Dropped[];
  readonly outer: AllDropped | null;
}

function* each(dropped: AllDropped | null): Generator<Dropped> {
  for (let at = dropped; at; at = at.outer) yield* at.here;
}

export class NearSet implements Near {
  readonly low: number;
  readonly high: number;
  readonly error: number;
  readonly asked: number;
  readonly branches: number;
  readonly node: number;
  readonly steep: number;
  readonly mostMissed: number;
  readonly plain: Colour | null;
  readonly #parts: readonly Near[];
  readonly #dropped: AllDropped | null;
  readonly #operation: Operation;
  readonly #kind: Kind;
  readonly #scratch = new Scratch();
  /** the last look along a ray: the values of the parts, with their signs */
  readonly #seen: number[] = [];
  #reach = 0;

  constructor(
    parts: readonly Near[],
    dropped: AllDropped | null,
    operation: Operation,
    kind: Kind,
    node: number,
  ) {
    this.node = node;
    this.steep = parts.reduce((least, { steep }) => Math.min(least, steep), Infinity);
    this.mostMissed = parts.reduce((least, { mostMissed }) => Math.min(least, mostMissed), Infinity);
    this.#parts = parts;
    this.#dropped = dropped;
    this.#operation = operation;
    this.#kind = kind;
    this.error = this.#together(parts.map(({ error }) => error));
    this.asked = parts.reduce((sum, { asked }) => sum + asked, 0);
    // blends and morphs have edges of their own elsewhere than their parts, if at all
    this.branches = operation.isExtreme ? parts.reduce((sum, { branches }) => sum + branches, 0) : 1;
    this.plain = commonColour(parts.map(({ plain }) => plain));
    const range = this.#range();
    this.low = range[0]!;
    this.high = range[1]!;
  }

  value(x: number, y: number, z: number): number {
    return combinedValue(this.#parts, this.#operation, this.#kind, x, y, z);
  }

  evaluate(x: number, y: number, z: number, out: FieldValue): void {
    evaluateOf(this.#parts, this.#operation, this.#kind, x, y, z, out, this.#scratch);
  }

  errorAt(x: number, y: number, z: number): number {
    return this.#together(this.#parts.map((part) => part.errorAt(x, y, z)));
  }

  colour(x: number, y: number, z: number, out: Float64Array): number {
    return colourOf(this.#parts, this.#operation, this.#kind, x, y, z, out, this.#scratch);
  }

  branch(x: number, y: number, z: number): number {
    if (!this.#operation.isExtreme) return branchOf(this.node);
    if (this.#parts.length === 1) return this.#parts[0]!.branch(x, y, z);
    const [outer, sign] = signsOf(this.#kind);
    let [best, most] = [this.#parts[0]!, -Infinity];
    this.#parts.forEach((part, i) => {
      const value = (i === 0 ? outer : sign) * part.value(x, y, z);
      if (value > most) [best, most] = [part, value];
    });
    return best.branch(x, y, z);
  }

  holds(branch: number): boolean {
    if (!this.#operation.isExtreme) return isFaceOf(this.node, branch);
    return this.#parts.some((part) => part.holds(branch));
  }

  onBranch(branch: number, x: number, y: number, z: number, out: FieldValue): void {
    const at = this.#operation.isExtreme ? this.#parts.findIndex((part) => part.holds(branch)) : -1;
    if (at < 0) {
      this.evaluate(x, y, z, out);
      return;
    }
    this.#parts[at]!.onBranch(branch, x, y, z, out);
    // what is taken away is turned inside out
    if (this.#kind === 'subtraction' && at > 0) {
      for (let i = 0; i < 4; i++) out[i] = -out[i]!;
    }
  }

  look(ray: Ray, x: number, y: number, z: number, reach: number): number {
    const [outer, sign] = signsOf(this.#kind);
    const seen = this.#seen;
    this.#reach = reach;
    this.#parts.forEach((part, i) => {
      seen[i] = (i === 0 ? outer : sign) * part.look(ray, x, y, z, reach);
    });
    return outer * seen.reduce((a, b) => this.#operation.value(a, b));
  }

  /** What is 0 where the largest part is has the sign of that: below 0 all keep theirs, above it one is enough. */
  clear(): number {
    if (!this.#operation.isExtreme) return this.#clearBlend();
    const isAbove = this.#seen.some((value) => value > 0);
    const ways = this.#parts.map((part, i) => (isAbove === this.#seen[i]! > 0 ? part.clear() : 0));
    return isAbove ? Math.max(...ways) : Math.min(...ways);
  }

  /** Where the first of what is below 0 is above, or what alone is above is below while the others stay there. */
  reached(clear: number): number {
    if (!this.#operation.isExtreme) return Infinity;
    const above = this.#parts.filter((_, i) => this.#seen[i]! > 0);
    if (above.length === 0) return Math.min(...this.#parts.map((part) => part.reached(clear)));
    if (above.length > 1) return Infinity;
    const reached = above[0]!.reached(clear);
    return this.#parts.every((part) => part === above[0] || part.clear() > reached) ? reached : Infinity;
  }

  around(): number {
    if (!this.#operation.isExtreme) return 0;
    const isAbove = this.#seen.some((value) => value > 0);
    const ways = this.#parts.map((part, i) => (isAbove === this.#seen[i]! > 0 ? part.around() : 0));
    return isAbove ? Math.max(...ways) : Math.min(...ways);
  }

  ahead(t: number, out: Float64Array): void {
    this.#combine((part) => {
      part.ahead(t, partRange);
      return { low: partRange[0]!, high: partRange[1]! };
    }, out);
  }

  #clearBlend(): number {
    for (let t = this.#reach; t > SHORTEST * this.#reach; t *= SHORTER) {
      this.ahead(t, blendRange);
      if (blendRange[0]! > 0 || blendRange[1]! < 0) return t;
    }
    return 0;
  }

  within(x: number, y: number, z: number, half: number, missed: number): Near {
    const parts = this.#parts.map((part, i) => part.within(x, y, z, half, missed * this.#shareOf(i)));
    // of a + b + √(a² + b²) no part goes without a trace: what is b < 0 moves the value by some a²/2|b|, though never its sign
    if (this.#operation !== hardUnion) {
      return new NearSet(parts, this.#dropped, this.#operation, this.#kind, this.node);
    }
    const { kept, dropped } = largestOf(parts, this.#kind);
    const all = dropped.length > 0 ? { here: dropped, outer: this.#dropped } : this.#dropped;
    return new NearSet(kept, all, this.#operation, this.#kind, this.node);
  }

  /**
   * That of each part is followed from edit to edit as long as the cubes around hold it, too: what they leave out may change without an effect, and
   * what is left of the set would no longer be what it was.
   */
  effect(newer: Near, changes: Changes, x: number, y: number, z: number, half: number): number {
    if (!(newer instanceof NearSet) || newer.node !== this.node) return Infinity;
    const effects = this.#parts.map((part) => {
      const other = newer.#part(part.node);
      return other ? part.effect(other, changes, x, y, z, half) : Infinity;
    });
    if (changes.has(this.node)) effects.push(this.#byCome(newer, changes, x, y, z, half));
    return this.#together(effects);
  }

  /** By what did not matter here or was not there: by as much as it may be above the field that was. */
  #byCome(newer: NearSet, changes: Changes, x: number, y: number, z: number, half: number): number {
    const [outer, sign] = signsOf(this.#kind);
    const [least] = turned(this, outer);
    return newer.#parts
      .filter(({ node }) => changes.has(node) && !this.#part(node))
      .reduce((most, part) => Math.max(most, turned(part.within(x, y, z, half, 0), sign)[1]! - least!), 0);
  }

  #part(node: number): Near | null {
    return this.#parts.find((part) => part.node === node) ?? null;
  }

  corners(nodes: BrickCorners, out: Float64Array): number {
    const [outer, sign] = signsOf(this.#kind);
    const other = new Float64Array(CORNERS);
    const wasRough = nodes.roughly;
    // of blends and morphs the sign is not that of a part
    nodes.roughly = wasRough && this.#operation.isExtreme;
    const slacks = this.#parts.map((part, i) => {
      if (i === 0) return part.corners(nodes, out);
      const slack = part.corners(nodes, other);
      for (let c = 0; c < CORNERS; c++) {
        out[c] = outer * this.#operation.value(outer * out[c]!, sign * other[c]!);
      }
      return slack;
    });
    nodes.roughly = wasRough;
    return this.#together(slacks);
  }

  eachLeaf(visit: (leaf: NearLeaf) => void): void {
    for (const part of this.#parts) part.eachLeaf(visit);
    for (const { part, way } of each(this.#dropped)) part.eachDropped(way, visit);
  }

  eachDropped(way: Way, visit: (leaf: NearLeaf) => void): void {
    const other = way === 'low' ? 'high' : 'low';
    this.#parts.forEach((part, i) => {
      part.eachDropped(i > 0 && this.#kind === 'subtraction' ? other : way, visit);
    });
    for (const dropped of each(this.#dropped)) dropped.part.eachDropped(dropped.way, visit);
  }

  /** What errors of the parts come to. */
  #together(errors: readonly number[]): number {
    if (this.#operation === hardUnion) return Math.max(...errors);
    return errors.reduce((sum, error, i) => sum + (error > 0 ? error * this.#stretched(i) : 0), 0);
  }

  #shareOf(i: number): number {
    return this.#operation === hardUnion ? 1 : 1 / (this.#parts.length * this.#stretched(i));
  }

  /** By the operations that part i passes through. */
  #stretched(i: number): number {
    const passed = i === 0 ? this.#parts.length - 1 : this.#parts.length - i;
    let product = 1;
    for (let k = 0; k < passed && product < 1e30; k++) product *= this.#operation.stretch;
    return product;
  }

  #range(): Float64Array {
    const range = new Float64Array(2);
    this.#combine((part) => part, range);
    return range;
  }

  /** From the range of each part that of all. */
  #combine(rangeOf: (part: Near) => Range, out: Float64Array): void {
    const [outer, sign] = signsOf(this.#kind);
    const [first, ...rest] = this.#parts;
    const range = turned(rangeOf(first!), outer);
    for (const part of rest) this.#operation.range(range, turned(rangeOf(part), sign), range);
    out.set(turned({ low: range[0]!, high: range[1]! }, outer));
  }
}

type Range = Pick<Near, 'low' | 'high'>;

function turned({ low, high }: Range, sign: number): Float64Array {
  return sign > 0 ? Float64Array.of(low, high) : Float64Array.of(-high, -low);
}

/** The parts that may be the largest, their signs counted. The first of a subtraction stays: it is the only one of its sign. */
function largestOf(parts: readonly Near[], kind: Kind) {
  const [outer, sign] = signsOf(kind);
  const ranges = parts.map((part, i) => turned(part, i === 0 ? outer : sign));
  const least = ranges.reduce((most, [low]) => Math.max(most, low!), -Infinity);
  const isKept = parts.map((_, i) => ranges[i]![1]! >= least || (i === 0 && kind === 'subtraction'));
  if (!isKept.includes(true)) return { kept: parts, dropped: [] };
  const way: Way = kind === 'intersection' ? 'high' : 'low';
  return {
    kept: parts.filter((_, i) => isKept[i]),
    dropped: parts.filter((_, i) => !isKept[i]).map((part): Dropped => ({ part, way })),
  };
}
