/** What became of the leaves of a tree: plain data is compared, what is the same object is the same. */
import { boundTerms } from './bind.ts';
import type { Changes, LeafChange } from './near.ts';
import type { FieldNode, SkelsNode, Term } from './node.ts';

/** By the numbers of the leaves; null where the trees are not built alike, so that leaves have no counterparts. */
export function treeChanges(before: FieldNode, after: FieldNode): Changes | null {
  const comparing = new Comparing();
  return comparing.pair(before, after, false) ? comparing.changes : null;
}

class Comparing {
  readonly changes = new Map<number, LeafChange>();
  #leaf = 0;

  /** `isMoved`: a matrix above is another one. False where the nodes are not alike. */
  pair(before: FieldNode, after: FieldNode, isMoved: boolean): boolean {
    if (before === after && !isMoved) {
      this.#leaf += leavesOf(before);
      return true;
    }
    switch (before.type) {
      case 'skels':
        if (after.type !== 'skels') return false;
        this.#sum(before, after, isMoved);
        return true;
      case 'shape':
        if (after.type !== 'shape') return false;
        this.#note(isMoved || !isSame(before, after) ? null : undefined);
        return true;
      case 'affine':
        return (
          after.type === 'affine' &&
          this.pair(before.node, after.node, isMoved || !isSame(before.matrix, after.matrix))
        );
      case 'blend':
        return (
          after.type === 'blend' &&
          isSame([before.a0, before.a1, before.a2], [after.a0, after.a1, after.a2]) &&
          this.#pairs([before.a, before.b], [after.a, after.b], isMoved)
        );
      case 'morph':
        return (
          after.type === 'morph' &&
          before.t === after.t &&
          this.#pairs([before.from, before.to], [after.from, after.to], isMoved)
        );
      default:
        return (
          after.type === before.type &&
          after.form === before.form &&
          this.#pairs(before.parts, after.parts, isMoved)
        );
    }
  }

  #pairs(before: readonly FieldNode[], after: readonly FieldNode[], isMoved: boolean): boolean {
    return before.length === after.length && before.every((node, i) => this.pair(node, after[i]!, isMoved));
  }

  #sum(before: SkelsNode, after: SkelsNode, isMoved: boolean): void {
    const body = ({ kernel, params, threshold, colour }: SkelsNode) => [kernel, params, threshold, colour];
    if (isMoved || !isSame(body(before), body(after))) {
      this.#note(null);
      return;
    }
    const bound = (terms: readonly Term[], node: SkelsNode) =>
      terms.flatMap((term) => boundTerms(term, node));
    const removed = bound(without(before.skels, after.skels), before);
    const added = bound(without(after.skels, before.skels), after);
    this.#note(removed.length + added.length > 0 ? { removed, added } : undefined);
  }

  #note(change: LeafChange | undefined): void {
    if (change !== undefined) this.changes.set(this.#leaf, change);
    this.#leaf++;
  }
}

/** Those that are not among `others`, be it as an object of its own. */
function without(terms: readonly Term[], others: readonly Term[]): readonly Term[] {
  const same = new Set(others);
  const left = terms.filter((term) => !same.has(term));
  if (left.length === 0) return left;
  const equal = new Set(others.filter((term) => !terms.includes(term)).map((term) => JSON.stringify(term)));
  return left.filter((term) => !equal.has(JSON.stringify(term)));
}

function leavesOf(node: FieldNode): number {
  switch (node.type) {
    case 'skels':
    case 'shape':
      return 1;
    case 'affine':
      return leavesOf(node.node);
    case 'blend':
      return leavesOf(node.a) + leavesOf(node.b);
    case 'morph':
      return leavesOf(node.from) + leavesOf(node.to);
    default:
      return node.parts.reduce((sum, part) => sum + leavesOf(part), 0);
  }
}

const isSame = (a: unknown, b: unknown): boolean => JSON.stringify(a) === JSON.stringify(b);
