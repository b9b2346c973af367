/** What a field on the GPU is made of: pipelines are made for these, and everything else is data. */
import { kernels } from '../kernel/index.ts';
import { type ShapeName, shapes } from '../shape/index.ts';

/** Of each kind all that there are; the place in a list is the number in WGSL. */
export const REGISTRY = {
  kernels: kernels.map(({ name }) => name),
  /** as `type` of a skel says */
  primitives: ['point', 'segment', 'polygon'],
  /** as `type` of a warp's section says */
  sections: ['round', 'superQuadric', 'extrusion', 'polar'],
  shapes: Object.keys(shapes) as ShapeName[],
  operations: ['hardUnion', 'smoothUnion', 'blendUnion', 'morph'],
} as const;

type Registry = typeof REGISTRY;
export type Ingredient = keyof Registry;
export type Named<K extends Ingredient> = Registry[K][number];

export type Ingredients = { readonly [K in Ingredient]: ReadonlySet<Named<K>> };

/** A set of each kind, to be filled. */
export const noIngredients = () => ({
  kernels: new Set<Named<'kernels'>>(),
  primitives: new Set<Named<'primitives'>>(),
  sections: new Set<Named<'sections'>>(),
  shapes: new Set<Named<'shapes'>>(),
  operations: new Set<Named<'operations'>>(),
});

export const KINDS = Object.keys(REGISTRY) as Ingredient[];

/** The number in WGSL. */
export const numberOf = <K extends Ingredient>(kind: K, name: Named<K>): number =>
  (REGISTRY[kind] as readonly Named<K>[]).indexOf(name);

/** Each once, in the order of the registry: fields of the same make ask for the same pipeline. */
export const namesOf = <K extends Ingredient>(ingredients: Ingredients, kind: K): readonly Named<K>[] =>
  (REGISTRY[kind] as readonly Named<K>[]).filter((name) => ingredients[kind].has(name as never));

/** The same for the same names of every kind. */
export const keyOf = (ingredients: Ingredients): string =>
  KINDS.map((kind) => namesOf(ingredients, kind).join(' ')).join(', ');
