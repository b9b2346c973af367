/**
 * What became of the nodes of a tree: what is the same object is the same (shared.ts). Terms of a sum and parts of a hard set come and go, and
 * the others keep their numbers; smooth sets, which every part matters to everywhere, have to have as many parts as before.
 */
import type { Box } from '../skeleton/skeleton.ts';
import { boundTerms } from './bind.ts';
import type { BoundTerm } from './boundTerm.ts';
import { grown, unite } from './boxes.ts';
import type { Changes, LeafChange } from './near.ts';
import type { FieldNode, SetNode, SkelsNode, Term } from './node.ts';
import { type Numbered, numbered, partsOf, type Supply } from './numbered.ts';

export interface TreeChanges {
  /** the tree after them */
  readonly tree: Numbered;
  readonly nodes: Changes;
  /** terms and shapes that went or came */
  readonly touched: number;
  /** most of the tree is as it was: otherwise most of the body is made again anyway */
  readonly isWorthIt: boolean;
  /** leaves and terms are where they were: none went, and none came but in place of another */
  readonly isInPlace: boolean;
  /** mm: what came is likely to be in here; null where that is not known */
  readonly reach: Box | null;
}

/** `next`: for what comes. Null where the trees are not built alike. */
export function treeChanges(before: Numbered, after: FieldNode, next: Supply): TreeChanges | null {
  if (!areAlike(before.node, after)) return null;
  const comparing = new Comparing(next);
  const tree = comparing.pair(before, after, false);
  const { changes: nodes, touched, isInPlace, reaches } = comparing;
  const reach = reaches && reaches.length > 0 ? reaches.reduce((a, b) => unite(a, b)!) : null;
  return { tree, nodes, touched, isWorthIt: touched <= EDIT * sizeOf(before.node), isInPlace, reach };
}

/** of all terms and shapes */
const EDIT = 0.3;

/** of T: what a term alone comes to where its body is likely to end, others adding theirs */
const REACH = 3;

/** Whether trees are built alike, so that what is left of the one is found in the other. */
export function areAlike(before: FieldNode, after: FieldNode): boolean {
  if (before === after) return true;
  if (before.type !== after.type || !isSame(amountsOf(before), amountsOf(after))) return false;
  const [old, young] = [partsOf(before), partsOf(after)];
  if (!isHard(before)) {
    return old.length === young.length && old.every((part, i) => areAlike(part, young[i]!));
  }
  // a set of one part is that part
  if (old.length === 1 || young.length === 1) {
    return old.length === young.length && areAlike(old[0]!, young[0]!);
  }
  return before.type !== 'subtraction' || areAlike(old[0]!, young[0]!);
}

/** What of a node is the same after an edit of it. */
function amountsOf(node: FieldNode): readonly unknown[] {
  if (node.type === 'blend') return [node.a0, node.a1, node.a2];
  if (node.type === 'morph') return [node.t];
  return 'form' in node ? [node.form] : [];
}

const isHard = (node: FieldNode): node is SetNode => 'form' in node && node.form === 'hard';

class Comparing {
  readonly changes = new Map<number, LeafChange>();
  touched = 0;
  isInPlace = true;
  /** of terms that came; null where something else did */
  reaches: Box[] | null = [];
  readonly #next: Supply;
  #depth = 0;

  constructor(next: Supply) {
    this.#next = next;
  }

  /** Of nodes that are alike. `isMoved`: a matrix above is another one. */
  pair(before: Numbered, after: FieldNode, isMoved: boolean): Numbered {
    if (before.node === after && !isMoved) return before;
    if (after.type === 'skels') {
      this.#note(before, this.#sum(before.node as SkelsNode, after, isMoved));
      return { ...before, node: after };
    }
    if (after.type === 'shape') {
      this.#note(before, null);
      this.touched++;
      return { ...before, node: after };
    }
    const isDeeper = after.type === 'affine';
    const isOther = isDeeper && before.node.type === 'affine' && after.matrix !== before.node.matrix;
    if (isDeeper) this.#depth++;
    const parts =
      isHard(after) && after.parts.length > 1
        ? this.#aligned(before, after, isMoved)
        : partsOf(after).map((part, i) => this.pair(before.parts[i]!, part, isMoved || isOther));
    if (isDeeper) this.#depth--;
    if (parts.some(({ number }) => this.changes.has(number))) this.#mark(before.number);
    return { ...before, node: after, parts };
  }

  /** The parts of a hard set: each stands for the same one before, or for the first of those left that it may be an edit of, or is new. */
  #aligned(before: Numbered, after: SetNode, isMoved: boolean): readonly Numbered[] {
    const left = [...before.parts];
    const take = (isIt: (part: Numbered) => boolean): Numbered | null => {
      const at = left.findIndex(isIt);
      return at < 0 ? null : left.splice(at, 1)[0]!;
    };
    // the first of a subtraction is of another sign than the others
    const first = after.type === 'subtraction' ? left.shift()! : null;
    const found = after.parts.map((part, i) => (i === 0 && first) || take(({ node }) => node === part));
    const parts = after.parts.map((part, i) => {
      const old = found[i] ?? take(({ node }) => areAlike(node, part));
      if (old !== before.parts[i]) this.isInPlace = false;
      return old ? this.pair(old, part, isMoved) : this.#came(part);
    });
    if (left.length > 0) this.isInPlace = false;
    for (const { node, number } of left) {
      this.touched += sizeOf(node);
      // the set is marked by what went, too
      this.#mark(number);
      this.#mark(before.number);
    }
    return parts;
  }

  #came(part: FieldNode): Numbered {
    const tree = numbered(part, this.#next);
    this.touched += sizeOf(part);
    this.reaches = null;
    this.#mark(tree.number);
    return tree;
  }

  /** Undefined: nothing. */
  #sum(before: SkelsNode, after: SkelsNode, isMoved: boolean): LeafChange | undefined {
    const gone = without(before.skels, after.skels);
    const come = without(after.skels, before.skels);
    if (!areInPlace(before, after, new Set(gone), new Set(come))) this.isInPlace = false;
    // a colour moves no surface: what is near would be kept as it was
    const isPainted = !isSame(gone.map(colourOf), come.map(colourOf)) && [...gone, ...come].some(colourOf);
    if (isMoved || isPainted || !isSame(bodyOf(before), bodyOf(after))) {
      this.touched += Math.max(before.skels.length, after.skels.length);
      return null;
    }
    if (gone.length + come.length === 0) return undefined;
    const bound = (terms: readonly Term[], node: SkelsNode) =>
      terms.flatMap((term) => boundTerms(term, node));
    const change = { removed: bound(gone, before), added: bound(come, after) };
    this.touched += Math.max(gone.length, come.length);
    if (this.#depth > 0) this.reaches = null;
    const reach = ({ field, factor }: BoundTerm) =>
      grown(field.box, field.offset(after.threshold / (REACH * Math.abs(factor))));
    this.reaches?.push(...change.added.map(reach));
    return change;
  }

  #note({ number }: Numbered, change: LeafChange | undefined): void {
    if (change === null) this.reaches = null;
    if (change !== undefined) this.changes.set(number, change);
  }

  /** A set, or what came or went. */
  #mark(number: number): void {
    if (!this.changes.has(number)) this.changes.set(number, null);
  }
}

const bodyOf = ({ kernel, params, threshold, colour }: SkelsNode) => [kernel, params, threshold, colour];

/** Whether each term is where it was, or where another of as many pieces was that went. */
function areInPlace(
  before: SkelsNode,
  after: SkelsNode,
  gone: ReadonlySet<Term>,
  come: ReadonlySet<Term>,
): boolean {
  const isBody = isSame(bodyOf(before), bodyOf(after));
  const pieces = (term: Term, node: SkelsNode) => boundTerms(term, node).length;
  return (
    before.skels.length === after.skels.length &&
    before.skels.every((term, i) => {
      const other = after.skels[i]!;
      if (term === other) return isBody || pieces(term, before) === pieces(other, after);
      return gone.has(term) && come.has(other) && pieces(term, before) === pieces(other, after);
    })
  );
}

const colourOf = ({ colour }: Term) => colour;

/** Those that are not among `others`, each of which stands for one. */
function without(terms: readonly Term[], others: readonly Term[]): readonly Term[] {
  const left = new Map<Term, number>();
  for (const term of others) left.set(term, (left.get(term) ?? 0) + 1);
  return terms.filter((term) => {
    const count = left.get(term) ?? 0;
    left.set(term, count - 1);
    return count <= 0;
  });
}

/** Terms and shapes. */
function sizeOf(node: FieldNode): number {
  if (node.type === 'skels') return node.skels.length;
  return partsOf(node).reduce((sum, part) => sum + sizeOf(part), node.type === 'shape' ? 1 : 0);
}

/** Of lists of objects of trees that share them, and of numbers. */
const isSame = (a: readonly unknown[], b: readonly unknown[]): boolean =>
  a.length === b.length && a.every((x, i) => x === b[i]);
