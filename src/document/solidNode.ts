/**
 * From the strokes of a solid to the tree of its field: a sum a component, and the union of those. All is cached by reference, and terms that
 * are the same before and after a change are the same objects, so that of an edited body only what changed is made anew.
 *
 * Each group has the kernel's width that suits its limbs (silhouettes are fitted once, whatever they blend with), and the fields add up. Weights
 * are made for the usual threshold: another one that a person sets makes all of a component thinner or thicker.
 */
import type { AnySkel } from '../field/expand.ts';
import type { FieldNode, SkelsNode, Term } from '../field/node.ts';
import type { Warp } from '../field/warp.ts';
import { kernelNamed } from '../kernel/index.ts';
import type { Kernel, KernelParams } from '../kernel/kernel.ts';
import { cross3 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { hasRadii, weighted } from '../skeleton/radii.ts';
import { FieldError } from '../skeleton/skeleton.ts';
import type { Curve } from '../stroke/curve.ts';
import type { Sample, Stroke } from '../stroke/stroke.ts';
import { curveOfStroke } from './curves.ts';
import type { BodyPart, SolidPart } from './document.ts';
import { forms, type Ink, type Shaped, type Sum } from './form/index.ts';
import { linearRgb } from './paint.ts';
import { onPlane } from './skelPlane.ts';
import { type Component, DEFAULT_COMPONENT, type Group } from './solid.ts';

const nodes = new WeakMap<readonly Component[], FieldNode>();

/** What the surface of a part is made from. */
export function nodeOf(part: BodyPart | SolidPart): FieldNode {
  if (part.kind === 'body') return part.node;
  const known = nodes.get(part.components);
  if (known) return known;
  const sums = part.components.map(sumNode);
  // a component that only carves has no surface, and would be nothing in a union
  const node: FieldNode = sums.length === 1 ? sums[0]! : { type: 'union', form: 'hard', parts: sums };
  const found = sums.length > 0 ? node : NOTHING;
  nodes.set(part.components, found);
  return found;
}

/** A sum has to have a term; this one adds nothing. */
const NONE: readonly Term[] = [{ skel: { type: 'point', at: [0, 0, 0], weight: 0 } }];
const NOTHING: FieldNode = { type: 'skels', ...DEFAULT_COMPONENT, params: {}, skels: NONE };

const FITTED = DEFAULT_COMPONENT.threshold;

const sums = new WeakMap<Component, SkelsNode>();

function sumNode(component: Component): SkelsNode {
  const known = sums.get(component);
  if (known) return known;
  const { kernel, threshold } = component;
  const skels = component.groups
    .filter(({ hidden }) => !hidden)
    .flatMap((group) => termsOf(group, component));
  const node: SkelsNode = {
    type: 'skels',
    kernel,
    params: {},
    threshold,
    skels: skels.length > 0 ? skels : NONE,
  };
  sums.set(component, node);
  return node;
}

/** Kernel, width and threshold that the skels of a group are made for; null where nothing can be made of it. */
function sumOf(group: Group, { kernel: name }: Pick<Component, 'kernel'>): Sum | null {
  const kernel = kernelNamed(name);
  const params = kernel && widthOfGroup(group, kernel);
  return kernel && params ? { kernel, params, threshold: FITTED } : null;
}

function widthOfGroup(group: Group, kernel: Kernel): KernelParams | null {
  const ink = inkOf(group);
  if (!ink) return null;
  const kept = keptOf(group);
  const key = keyOf(group, kernel.name);
  const known = kept.widths.find((width) => width.key === key);
  if (known) return known.params;
  const params = tried(() => forms[group.form].width(ink, kernel));
  kept.widths = [{ key, params }, ...kept.widths].slice(0, KEPT);
  return params;
}

const terms = new WeakMap<Group, { readonly shaped: Shaped; readonly terms: readonly Term[] }>();

function termsOf(group: Group, component: Component): readonly Term[] {
  const sum = sumOf(group, component);
  const shaped = sum && shapedFor(group, sum);
  if (!shaped) return [];
  const { kernel } = sum;
  const params = shaped.params ?? sum.params;
  const known = terms.get(group);
  if (known?.shaped === shaped) return known.terms;
  const { plane } = group.strokes[0]!;
  const warp = warpOf(group);
  const { weight } = group.shape;
  const term = (skel: AnySkel): Term => ({
    skel: onPlane(hasRadii(skel) ? weighted(skel, kernel, params, FITTED) : skel, plane),
    params,
    ...(weight !== 1 && { factor: weight }),
    ...(warp && { warp }),
    colour: linearRgb(group.brush.colour),
  });
  // radii that the kernel does not reach are those of nothing
  const made = tried(() => shaped.skels.map(term)) ?? [];
  terms.set(group, { shaped, terms: made });
  return made;
}

/** Off the plane is the section's y; extrusions are as thick as the brush. */
function warpOf({ shape, brush, strokes }: Group): Warp | null {
  const { breadth, depth, section, exponent } = shape;
  if (section === 'round' && breadth === 1 && depth === 1) return null;
  const { x, y } = strokes[0]!.plane;
  return {
    section: section === 'round' ? { type: 'round' } : { type: section, exponent },
    scale: [breadth, section === 'extrusion' ? depth * brush.radius : depth],
    up: cross3(x, y),
    along: x,
  };
}

interface Kept {
  widths: readonly { readonly key: string; readonly params: KernelParams | null }[];
  shaped: readonly { readonly key: string; readonly shaped: Shaped | null }[];
}

/** by the samples of the first stroke, which stay when a group is moved, named or coloured */
const kept = new WeakMap<readonly Sample[], Kept>();
/** sliders go back and forth, and copies share their strokes */
const KEPT = 6;

function keptOf({ strokes }: Group): Kept {
  const { samples } = strokes[0]!;
  const known = kept.get(samples) ?? { widths: [], shaped: [] };
  kept.set(samples, known);
  return known;
}

const numbers = new WeakMap<object, number>();
let latest = 0;

function numberOf(object: object): number {
  const known = numbers.get(object) ?? ++latest;
  numbers.set(object, known);
  return known;
}

/** All that skels on the plane depend on beside the sum. */
function keyOf(group: Group, rest: string): string {
  const { form, strokes, brush, shape, skeleton, isRough } = group;
  const { radius, pressure, filter, levels } = brush;
  const { profile, density, knots } = shape;
  const ink = strokes.map(({ samples, view }) => [numberOf(samples), view.height]);
  // soft bodies follow their outline, whatever the brush's radius
  const pen = form === 'soft' ? [] : [radius, pressure, profile, density, knots];
  const own = [form, ink, filter, levels, ...pen, isRough ?? false];
  return JSON.stringify([...own, skeleton && numberOf(skeleton), rest]);
}

/** Skeleton and skels of a group on its plane; null: nothing can be made of it. */
export function shapedOf(group: Group, component: Pick<Component, 'kernel'>): Shaped | null {
  const sum = sumOf(group, component);
  return sum && shapedFor(group, sum);
}

function shapedFor(group: Group, sum: Sum): Shaped | null {
  const ink = inkOf(group);
  if (!ink) return null;
  const kept = keptOf(group);
  const key = keyOf(group, JSON.stringify([sum.kernel.name, sum.params, sum.threshold]));
  const known = kept.shaped.find((shaped) => shaped.key === key);
  if (known) return known.shaped;
  const shaped = tried(() => forms[group.form].make(ink, sum));
  kept.shaped = [{ key, shaped }, ...kept.shaped].slice(0, KEPT);
  return shaped;
}

function inkOf(group: Group): Ink | null {
  const { form, strokes, brush, shape, skeleton, isRough = false } = group;
  const drawn = strokes.map(
    (stroke) => curveOfStroke(stroke, brush) ?? (form === 'point' ? dotOf(stroke) : null),
  );
  const curves = drawn.filter((curve) => curve !== null);
  return curves.length > 0 ? { curves, brush, shape, skeleton, isRough } : null;
}

/** A pen that was still is nowhere else than there. */
function dotOf({ samples }: Stroke): Curve | null {
  const [first] = samples;
  if (!first) return null;
  const at: Vec2 = [first.x, first.y];
  return {
    closed: false,
    length: 0,
    corners: [],
    point: () => at,
    tangent: () => [1, 0],
    pressure: () => first.pressure,
  };
}

/** Kernels do not do everything: what they cannot is nothing. */
function tried<T>(make: () => T | null): T | null {
  try {
    return make();
  } catch (error) {
    if (!(error instanceof FieldError)) throw error;
    return null;
  }
}
