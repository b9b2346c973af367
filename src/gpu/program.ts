/**
 * A field tree as a flat program: steps in the order of evaluation, so that a tree of any form runs in one pipeline.
 *
 * A step takes a leaf and joins it to the result so far; only a subtree on the right of an operation puts that aside. The
 * heavier operand comes first (Sethi & Ullman 1970), so that n leaves need log₂ n places on the stack at most.
 *
 * Tried instead: straight-line WGSL generated for each structure (tests/bench/straightTree.ts). It is up to 1.4 times as fast on
 * SwiftShader and no faster on lavapipe, and compiles again whenever a part comes or goes: with 32 bodies for 11 s and 160 s,
 * where the program takes 0.2 s and 0.7 s, once (docs/performance.md).
 */
import { type Affine, composed, IDENTITY, inverted, stretches } from '../field/affine.ts';
import { bindField, PLAIN } from '../field/bind.ts';
import type { FieldNode, SetNode, ShapeNode } from '../field/node.ts';
import type { RecordValue } from '../math/record.ts';
import { bindShape, kindOf } from '../shape/index.ts';
import { Heap } from './heap.ts';
import { type Ingredients, type Named, noIngredients, numberOf } from './ingredients.ts';
import { PLACE, PROGRAM, SHAPE, STEP } from './structs.ts';
import { addSum } from './sum.ts';

/** Where a step has its value from. */
export const TAKE = { SUM: 0, SHAPE: 1, STACK: 2 } as const;
/** What becomes of it: the first result, a result that puts the one before aside, an operand. */
export const ROLE = { FIRST: 0, PUSH: 1, JOIN: 2 } as const;
/** as many smooth sides as a shape has at most, and one more */
export const SIDES = 8;
/** places: enough for any tree of 2¹⁷ leaves */
export const STACK = 16;

export interface Program {
  readonly records: ArrayBuffer;
  readonly ingredients: Ingredients;
  /** what lies in the records, for who wants to look */
  readonly steps: readonly Step[];
}

/** The program of a tree; throws FieldError for what bindField refuses. */
export function programOf(node: FieldNode): Program {
  bindField(node);
  const heap = new Heap();
  const program = heap.add(PROGRAM, { first: 0, end: 0 });
  const writer: Writer = { heap, used: noIngredients(), branches: { next: 0, blended: null } };
  const { steps, weight } = write(writer, node, IDENTITY);
  if (weight - 1 > STACK) throw new RangeError('the tree has too many branches for the graphics device');
  const first = heap.next;
  for (const step of steps) heap.add(STEP, step);
  heap.put(PROGRAM, program, { first, end: heap.next });
  return { records: heap.bytes(), ingredients: writer.used, steps };
}

export interface Writer {
  readonly heap: Heap;
  readonly used: ReturnType<typeof noIngredients>;
  /** the next leaf; the branch of the blend or morph around, which is one: that of its first leaf, where Near.branch has the set's own */
  readonly branches: { next: number; blended: number | null };
}

export type Step = RecordValue<(typeof STEP)['members']>;

interface Code {
  readonly steps: Step[];
  /** places on the stack, the result's own included; none for a lone leaf */
  readonly weight: number;
}

/** An operation as steps know it. */
type Join = Pick<Step, 'operation' | 'amounts' | 'outer' | 'sign'>;

function write(writer: Writer, node: FieldNode, matrix: Affine): Code {
  switch (node.type) {
    case 'skels':
      return leaf(TAKE.SUM, addSum(writer, node), addPlace(writer.heap, matrix, false), sidesOf(writer, 1));
    case 'shape':
      return leaf(
        TAKE.SHAPE,
        addShape(writer, node),
        addPlace(writer.heap, matrix, true),
        sidesOf(writer, sideCount(node)),
      );
    case 'union':
    case 'intersection':
    case 'subtraction': {
      const join = joinOf(writer, node.form === 'hard' ? 'hardUnion' : 'smoothUnion', [0, 0, 0], node.type);
      return node.parts.map((part) => write(writer, part, matrix)).reduce((a, b) => joined(a, b, join));
    }
    case 'blend': {
      const join = joinOf(writer, 'blendUnion', [node.a0, node.a1, node.a2]);
      return blended(writer, () =>
        joined(write(writer, node.a, matrix), write(writer, node.b, matrix), join),
      );
    }
    case 'morph': {
      const join = joinOf(writer, 'morph', [node.t, 0, 0]);
      return blended(writer, () =>
        joined(write(writer, node.from, matrix), write(writer, node.to, matrix), join),
      );
    }
    case 'affine':
      return write(writer, node.node, composed(matrix, node.matrix));
  }
}

function joinOf(
  { used }: Writer,
  name: Named<'operations'>,
  amounts: readonly number[],
  kind: SetNode['type'] = 'union',
): Join {
  used.operations.add(name);
  const outer = kind === 'union' ? 1 : -1;
  return { operation: numberOf('operations', name), amounts, outer, sign: kind === 'intersection' ? -1 : 1 };
}

const NEUTRAL = {
  role: ROLE.FIRST,
  amounts: [0, 0, 0],
  operation: 0,
  outer: 1,
  sign: 1,
  swapped: 0,
  sides: 0,
} as const;

function leaf(take: number, at: number, place: number, sides: number): Code {
  return { steps: [{ ...NEUTRAL, take, at, place, sides }], weight: 0 };
}

/** The steps of the first operand go on with those of the second. */
function joined(a: Code, b: Code, join: Join): Code {
  const swapped = b.weight > a.weight;
  const [early, late] = swapped ? [b, a] : [a, b];
  const how = { ...join, swapped: Number(swapped), role: ROLE.JOIN };
  const [first, ...rest] = late.steps;
  if (rest.length === 0) {
    early.steps.push({ ...first!, ...how });
  } else {
    early.steps.push({ ...first!, role: ROLE.PUSH });
    for (const step of rest) early.steps.push(step);
    early.steps.push({ ...how, take: TAKE.STACK, at: 0, place: 0, sides: 0 });
  }
  return { steps: early.steps, weight: Math.max(early.weight, late.weight + 1) };
}

const sideCount = ({ shape }: ShapeNode): number => bindShape(shape).facets?.count ?? 1;

function sidesOf({ branches }: Writer, count: number): number {
  // as branchOf in field/near.ts has them
  const first = SIDES * branches.next++;
  return branches.blended === null ? SIDES * first + count : SIDES * branches.blended + 1;
}

/** What is written within is one smooth field. */
function blended(writer: Writer, write: () => Code): Code {
  const { branches } = writer;
  const outer = branches.blended;
  branches.blended ??= SIDES * branches.next;
  const code = write();
  branches.blended = outer;
  return code;
}

/** 0 where the matrix moves nothing. */
function addPlace(heap: Heap, matrix: Affine, isDistance: boolean): number {
  if (matrix.every((entry, i) => entry === IDENTITY[i])) return 0;
  const back = inverted(matrix);
  const column = (k: number) => [back[k]!, back[4 + k]!, back[8 + k]!];
  const origin = [matrix[3], matrix[7], matrix[11]];
  const rounded = origin.map(Math.fround);
  const lost = rounded.map((x, i) => x - origin[i]!);
  const low = [0, 4, 8].map((row) => lost.reduce((sum, x, i) => sum + back[row + i]! * x, 0));
  return heap.add(PLACE, {
    inverse: [0, 1, 2].flatMap(column),
    origin: rounded,
    scale: isDistance ? stretches(matrix).least : 1,
    low,
  });
}

function addShape({ heap, used }: Writer, { shape, colour }: ShapeNode): number {
  used.shapes.add(shape.type);
  const numbers = [...kindOf(shape).numbers(shape), ...new Array<number>(12).fill(0)];
  return heap.add(SHAPE, {
    colour: colour ?? PLAIN,
    kind: numberOf('shapes', shape.type),
    a: numbers.slice(0, 4),
    b: numbers.slice(4, 8),
    c: numbers.slice(8, 12),
  });
}
