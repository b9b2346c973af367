/**
 * Between sections (thesis 5.5.1): outlines at their own u, in the frame of their chords, are mixed with weights that depend
 * on u alone, constant beyond the first and the last; on closed surfaces the last goes over into the first.
 *
 * Linear as the thesis has it, and cubic (its future work): Hermite pieces on the uneven u, slopes by the parabola through three
 * sections. So that nothing overshoots, a slope is as much shorter as its two sides disagree (the cosine of the angle
 * between the changes of the whole outline), at most three times the smaller of them (Fritsch and Carlson's bound), and 0 at
 * the first and last, which go on constant. Tried: that rule for every point alone; where a point's two changes disagree
 * its slope stops at 0, and the line across between points that do and do not becomes a crease.
 */

export type Between = 'cubic' | 'linear' | 'plain';

/** What a section contributes at one u, and how that changes with u. */
export interface Share {
  readonly section: number;
  readonly weight: number;
  readonly rate: number;
}

/** Shares at u, their weights summing to 1; `side`: at a section's own u, before (−1) or after (1) it. */
export type Mix = (u: number, side: -1 | 1) => readonly Share[];

/** A vector a section: many points of its outline, at the same v on all. */
export type Forms = readonly (readonly number[])[];

/** `us` ascending, one a form. `closed`: u = 1 is u = 0. */
export function mixOf(us: readonly number[], forms: Forms, between: Between, closed: boolean): Mix {
  const count = us.length;
  if (count === 1) return () => [{ section: 0, weight: 1, rate: 0 }];
  if (between === 'linear') {
    // a spline runs over the kink at a section with the mean of both sides
    const sided = mixOf(us, forms, 'plain', closed);
    const half = ({ section, weight, rate }: Share): Share => ({
      section,
      weight: weight / 2,
      rate: rate / 2,
    });
    return (u, side) => (us.includes(u) ? [...sided(u, -1), ...sided(u, 1)].map(half) : sided(u, side));
  }
  const slopes = us.map((_, k) => (between === 'cubic' ? slopeAt(us, forms, k, closed) : []));
  return (u, side) => {
    const step = stepAt(us, u, side, closed);
    if (step.alone !== undefined) return [{ section: step.alone, weight: 1, rate: 0 }];
    return between === 'cubic' ? hermite(step, slopes[step.from]!, slopes[step.to]!) : straight(step);
  };
}

function straight({ from, to, width, t }: Step): Share[] {
  return [
    { section: from, weight: 1 - t, rate: -1 / width },
    { section: to, weight: t, rate: 1 / width },
  ];
}

interface Step {
  readonly from: number;
  readonly to: number;
  readonly width: number;
  readonly t: number;
  /** beyond the first or last: the only section */
  readonly alone?: number;
}

function stepAt(us: readonly number[], u: number, side: -1 | 1, closed: boolean): Step {
  const last = us.length - 1;
  const [first, end] = [us[0]!, us[last]!];
  const before = side === 1 ? u < first : u <= first;
  const after = side === 1 ? u >= end : u > end;
  if (before || after) {
    const width = first + 1 - end;
    const t = ((before ? u + 1 : u) - end) / width;
    const seam = { from: last, to: 0, width, t };
    return closed ? seam : { ...seam, alone: before ? 0 : last };
  }
  let from = 0;
  while (side === 1 ? u >= us[from + 1]! : u > us[from + 1]!) from++;
  const width = us[from + 1]! - us[from]!;
  return { from, to: from + 1, width, t: (u - us[from]!) / width };
}

/** A slope as a sum of sections. */
type Slope = readonly { readonly section: number; readonly share: number }[];

function slopeAt(us: readonly number[], forms: Forms, k: number, closed: boolean): Slope {
  const count = us.length;
  if (!closed && (k === 0 || k === count - 1)) return [];
  const [i, j] = [(k + count - 1) % count, (k + 1) % count];
  const before = us[k]! - us[i]! + (k === 0 ? 1 : 0);
  const after = us[j]! - us[k]! + (k === count - 1 ? 1 : 0);
  const a = forms[k]!.map((x, n) => (x - forms[i]![n]!) / before);
  const b = forms[j]!.map((x, n) => (x - forms[k]![n]!) / after);
  const [wa, wb] = [after / (before + after), before / (before + after)];
  const middle = a.map((x, n) => wa * x + wb * b[n]!);
  const [sizeA, sizeB, size] = [norm(a), norm(b), norm(middle)];
  if (!(sizeA * sizeB * size > 0)) return [];
  const agreement = Math.max(a.reduce((sum, x, n) => sum + x * b[n]!, 0) / (sizeA * sizeB), 0);
  const scale = agreement * Math.min(1, (3 * Math.min(sizeA, sizeB)) / size);
  return [
    { section: i, share: (-scale * wa) / before },
    { section: k, share: scale * (wa / before - wb / after) },
    { section: j, share: (scale * wb) / after },
  ];
}

function hermite({ from, to, width, t }: Step, first: Slope, second: Slope): Share[] {
  const s = 1 - t;
  const bend = (6 * s * t) / width;
  return [
    { section: from, weight: s * s * (1 + 2 * t), rate: -bend },
    { section: to, weight: t * t * (3 - 2 * t), rate: bend },
    ...first.map(({ section, share }) => ({
      section,
      weight: share * width * s * s * t,
      rate: share * s * (1 - 3 * t),
    })),
    ...second.map(({ section, share }) => ({
      section,
      weight: -share * width * t * t * s,
      rate: share * t * (1 - 3 * s),
    })),
  ];
}

function norm(x: readonly number[]): number {
  return Math.sqrt(x.reduce((sum, value) => sum + value * value, 0));
}
