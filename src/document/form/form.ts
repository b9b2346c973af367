/**
 * What strokes become in a solid: one file a form. A form makes a skeleton, circles on the plane of the strokes and how they are linked, and the skels
 * that follow it; a skeleton that was edited by hand takes the place of the one from the strokes.
 */
import type { AnySkel } from '../../field/expand.ts';
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import type { MedialGraph } from '../../skeleton/medial/axis.ts';
import { widthFor } from '../../skeleton/weight.ts';
import type { Curve } from '../../stroke/curve.ts';
import type { Brush } from '../document.ts';
import type { GroupShape } from '../solid.ts';
import { profileAt } from './profile.ts';

/** What a form is made from. */
export interface Ink {
  /** filtered, at least one */
  readonly curves: readonly Curve[];
  readonly brush: Brush;
  readonly shape: GroupShape;
  /** by hand; null: as the strokes say */
  readonly skeleton: MedialGraph | null;
  /** while the pen moves: at once, and roughly */
  readonly isRough: boolean;
}

/** What skels are made for: the kernel of the component, the width that suits the group, and the usual threshold. */
export interface Sum {
  readonly kernel: Kernel;
  readonly params: KernelParams;
  readonly threshold: number;
}

/** How well skels follow their outline. */
export interface Figures {
  /** mm, where it is off most, to first order */
  readonly most: number;
  /** share of the weights at a bound, 0–1 */
  readonly atBound: number;
  /** of relative weights of neighbours, the largest */
  readonly ratio: number;
}

export interface Shaped {
  /** as it may be edited */
  readonly skeleton: MedialGraph;
  /** in the plane z = 0, mm */
  readonly skels: readonly AnySkel[];
  readonly figures?: Figures;
  /** where the kernel's width is found together with the skels */
  readonly params?: KernelParams;
}

export interface FormKind {
  /** How wide it would like the kernel to be; null: nothing can be made of it. */
  width(ink: Ink, kernel: Kernel): KernelParams | null;
  /** null: nothing can be made of it. FieldError for what the kernel cannot do. */
  make(ink: Ink, sum: Sum): Shaped | null;
}

/** Parameters that a kernel has beside its width. */
export const PLAIN: KernelParams = {};

/** mm: radius of a curve at u. Pen pressure counts as for tubes: the brush's own radius at half of it. */
export const radiusAt = ({ brush, shape }: Ink, curve: Curve, u: number): number =>
  brush.radius * profileAt(shape, u) * (brush.pressure ? 0.25 + 1.5 * curve.pressure(u) : 1);

/** of the smallest radius: kernels without an end are made for so much thinner ones, or tubes would end as needles; s R = 2 for Cauchy */
const SHARPER = 2.5;
/** of the largest radius: kernels with an end have to reach it (the quartic one is 1.34 of it wide) */
const REACHING = 0.9;

/** Width with which lines and plates of these radii are as thick as they say; null for none. */
export function widthForRadii(kernel: Kernel, radii: readonly number[]): KernelParams | null {
  if (radii.length === 0) return null;
  const least = radii.reduce((a, b) => Math.min(a, b)) / SHARPER;
  const most = kernel.support < Infinity ? REACHING * radii.reduce((a, b) => Math.max(a, b)) : 0;
  return widthFor(kernel, PLAIN, Math.max(least, most));
}

export const radiiOf = ({ nodes }: MedialGraph): readonly number[] => nodes.map(({ radius }) => radius);
