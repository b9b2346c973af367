/**
 * The tree of a body as files hold it: every field that there is, with numbers that are numbers. What numbers must be for there to be
 * a field is known where fields are made: `bindable` asks there, and passes on what is refused, with its place in the tree.
 */
import * as v from 'valibot';
import type { FieldNode } from '../field/node.ts';
import { kernels } from '../kernel/index.ts';
import { type Shape, shapes } from '../shape/index.ts';
import { fields, finite, list, numbers, oneOf } from './fields.ts';
import { LIMITS } from './limits.ts';
import { bindable } from './rules.ts';
import { colour, params, term } from './skelSchema.ts';

/** A shape's first example says which fields it has: a number or a few. */
const shape = v.variant(
  'type',
  Object.values(shapes).map(({ name, examples: [example] }) => {
    const { type, ...sizes } = example as Shape;
    const entries = Object.entries(sizes as Readonly<Record<string, number | readonly number[]>>);
    const size = (value: number | readonly number[]) =>
      typeof value === 'number' ? finite : numbers(value.length);
    return fields({
      type: v.literal(type, `"${name}"`),
      ...Object.fromEntries(entries.map(([key, value]) => [key, size(value)])),
    });
  }),
  `one of ${Object.keys(shapes).join(', ')}`,
) as unknown as v.GenericSchema<unknown, Shape>;

/** Trees in trees. */
const child: v.GenericSchema<unknown, FieldNode> = {
  ...v.lazy(() => tree),
  ...{ message: 'a node of the tree' },
};

const kinds = [
  fields({
    type: v.literal('skels', '"skels"'),
    kernel: oneOf(kernels.map(({ name }) => name)),
    params,
    threshold: finite,
    skels: list(term, LIMITS.skels, 'skels'),
    colour: v.exactOptional(colour),
  }),
  fields({ type: v.literal('shape', '"shape"'), shape, colour: v.exactOptional(colour) }),
  fields({
    type: oneOf(['union', 'intersection', 'subtraction']),
    form: oneOf(['hard', 'smooth']),
    parts: list(child, LIMITS.skels, 'nodes'),
  }),
  fields({ type: v.literal('blend', '"blend"'), a: child, b: child, a0: finite, a1: finite, a2: finite }),
  fields({ type: v.literal('morph', '"morph"'), from: child, to: child, t: finite }),
  fields({ type: v.literal('affine', '"affine"'), matrix: numbers(12), node: child }),
] as const;

const WORDS = 'a node: skels, shape, union, intersection, subtraction, blend, morph or affine';

// that a skel has weights or radii, and neither both nor none, is a rule, which types do not follow
/** Of any node; what makes no field is none of its business. */
export const tree = v.variant('type', kinds, WORDS) as unknown as v.GenericSchema<unknown, FieldNode>;

/** The same tree, with keys in the order of the files. */
export const ordered = (node: FieldNode): FieldNode => v.parse(tree, node);

export const node = { ...v.pipe(child, bindable()), message: WORDS };
