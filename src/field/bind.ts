/**
 * A tree becomes a field: everything that can be refused is refused here, with the place in the tree, so that drawing
 * never fails. Matrices go down to the leaves (see AffineNode), so nested ones cost one.
 */
import { kernelNamed } from '../kernel/index.ts';
import type { Kernel, KernelParams } from '../kernel/kernel.ts';
import { bindShape } from '../shape/index.ts';
import { checkedParams } from '../skeleton/binding.ts';
import { bindSkel } from '../skeleton/index.ts';
import { at } from '../skeleton/place.ts';
import { FieldError } from '../skeleton/skeleton.ts';
import { type Affine, composed, IDENTITY, inverted } from './affine.ts';
import { blendUnion } from './blendUnion.ts';
import type { BoundTerm } from './boundTerm.ts';
import { combined } from './combined.ts';
import { expanded } from './expand.ts';
import { hardUnion } from './hardUnion.ts';
import { coloured, moved } from './leaf.ts';
import { morph } from './morph.ts';
import type { Colour, FieldNode, SetNode, ShapeNode, SkelsNode, Term } from './node.ts';
import { checkThreshold, skelSum, type Widths } from './skelSum.ts';
import { smoothUnion } from './smoothUnion.ts';
import type { LeafField, TreeField } from './treeField.ts';
import { bindWarped, type Warp } from './warp.ts';

/** Of nodes that have none, linear: the grey of unpainted clay. */
export const PLAIN: Colour = [0.6, 0.6, 0.6];

/** Deeper trees are mistakes, and would overflow the stack of an evaluation. */
const DEEPEST = 200;

/** The field of a tree; FieldError names the place, as in `parts[1].node.skels[3]: …`. */
export function bindField(node: FieldNode): TreeField {
  return bindNode(node, IDENTITY, '', 0);
}

function bindNode(node: FieldNode, matrix: Affine, path: string, depth: number): TreeField {
  if (depth > DEEPEST) throw new FieldError(`the tree is deeper than ${DEEPEST} nodes`);
  const child = (inner: FieldNode, name: string) => bindNode(inner, matrix, join(path, name), depth + 1);
  const here = <T>(make: () => T) => at(path, make);
  switch (node.type) {
    case 'skels':
      return here(() => moved(bindSkels(node), matrix, false));
    case 'shape':
      return here(() => moved(bindShapeNode(node), matrix, true));
    case 'union':
    case 'intersection':
    case 'subtraction':
      return bindSet(node, path, child);
    case 'blend': {
      const operation = here(() => blendUnion(node));
      return combined([child(node.a, 'a'), child(node.b, 'b')], operation, 'union');
    }
    case 'morph': {
      const operation = here(() => morph(node.t));
      return combined([child(node.from, 'from'), child(node.to, 'to')], operation, 'union');
    }
    case 'affine': {
      here(() => inverted(node.matrix));
      return bindNode(node.node, composed(matrix, node.matrix), join(path, 'node'), depth + 1);
    }
    default:
      return here(() => {
        throw new FieldError(`unknown node '${(node as { type: string }).type}'`);
      });
  }
}

function bindSet(
  { type, form, parts }: SetNode,
  path: string,
  child: (part: FieldNode, name: string) => TreeField,
): TreeField {
  const operation = at(path, () => {
    if (form !== 'hard' && form !== 'smooth') throw new FieldError(`unknown form '${form}'`);
    if (parts.length === 0) throw new FieldError(`${type} has no parts`);
    return form === 'hard' ? hardUnion : smoothUnion;
  });
  const fields = parts.map((part, i) => child(part, `parts[${i}]`));
  return combined(fields, operation, type);
}

function bindShapeNode({ shape, colour }: ShapeNode): LeafField {
  const field = at('shape', () => bindShape(shape));
  return coloured(
    field,
    at('colour', () => checkedColour(colour ?? PLAIN)),
  );
}

function bindSkels(node: SkelsNode): LeafField {
  const kernel = kernelNamed(node.kernel);
  if (!kernel) throw new FieldError(`unknown kernel '${node.kernel}'`);
  at('params', () => checkParams(kernel, node.params));
  checkThreshold(node.threshold);
  at('colour', () => checkedColour(node.colour ?? PLAIN));
  const terms = node.skels.flatMap((term, i) => at(`skels[${i}]`, () => boundTerms(term, node)));
  return skelSum(terms, node.threshold, widthsOf(kernel, node));
}

/** Of the narrowest and of the widest term; null for kernels that have none. */
function widthsOf(kernel: Kernel, { params, skels }: SkelsNode): Widths | null {
  if (kernel.homogeneity !== 0) return null;
  const own = kernel.unit(checkedParams(kernel, params), 1);
  let [least, most] = [Infinity, 0];
  for (const term of skels) {
    const width = term.params ? kernel.unit(checkedParams(kernel, term.params), 1) : own;
    least = Math.min(least, width * narrowing(term));
    most = Math.max(most, width);
  }
  return { least, most };
}

/** The least that a cross section scales by, no more than 1. */
const narrowing = ({ warp }: Term): number => (warp ? Math.min(1, ...warp.scale, innermost(warp)) : 1);

/** Of a drawn section, by how much less than its scale it reaches somewhere. */
const innermost = ({ section, scale }: Warp): number =>
  section.type === 'polar' ? Math.min(...section.radii) * Math.min(...scale) : 1;

/** What was bound of a term, and of what body: trees that are edited in place share most of their terms. */
const bound = new WeakMap<Term, { readonly key: string; readonly pieces: readonly BoundTerm[] }>();

/** The same for the same term of a body with the same kernel, threshold and colour. */
export function boundTerms(
  term: Term,
  { kernel, params, threshold, colour }: SkelsNode,
): readonly BoundTerm[] {
  const key = JSON.stringify([kernel, params, threshold, colour ?? PLAIN]);
  const known = bound.get(term);
  if (known?.key === key) return known.pieces;
  const pieces = bindTerm(term, kernelNamed(kernel)!, { params, threshold, colour: colour ?? PLAIN });
  bound.set(term, { key, pieces });
  return pieces;
}

type Body = Required<Pick<SkelsNode, 'params' | 'threshold' | 'colour'>>;

function bindTerm(
  { skel, params: own, factor = 1, warp, colour }: Term,
  kernel: Kernel,
  { params: shared, threshold, colour: plain }: Body,
): BoundTerm[] {
  const params = own ?? shared;
  if (own) at('params', () => checkParams(kernel, own));
  if (!Number.isFinite(factor)) throw new FieldError(`factor must be a number, got ${factor}`);
  const painted = colour ? checkedColour(colour) : plain;
  return expanded(skel, kernel, params, threshold).map((piece) => {
    const bind = (local: typeof piece) => bindSkel(local, kernel, params);
    return { field: warp ? bindWarped(piece, warp, bind) : bind(piece), factor, colour: painted };
  });
}

function checkParams(kernel: Kernel, params: KernelParams): void {
  for (const { name, min, max, help } of kernel.params) {
    const value = params[name];
    if (value !== undefined && !(value >= min && value <= max)) {
      throw new FieldError(`${name} must be ${min}–${max} (${help}), got ${value}`);
    }
  }
  const unknown = Object.keys(params).find((name) => !kernel.params.some((spec) => spec.name === name));
  if (unknown) throw new FieldError(`kernel ${kernel.name} has no parameter '${unknown}'`);
}

function checkedColour(colour: Colour): Colour {
  if (colour.length === 3 && colour.every((x) => x >= 0 && x <= 1)) return colour;
  throw new FieldError(`a colour is three numbers 0–1, got ${colour}`);
}

export function join(path: string, name: string): string {
  return path === '' ? name : `${path}.${name}`;
}
