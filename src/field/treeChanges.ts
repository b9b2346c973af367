/** What became of the leaves of a tree: plain data is compared, what is the same object is the same. */
import type { Box } from '../skeleton/skeleton.ts';
import { boundTerms } from './bind.ts';
import type { BoundTerm } from './boundTerm.ts';
import { grown, unite } from './boxes.ts';
import type { Changes, LeafChange } from './near.ts';
import type { FieldNode, SkelsNode, Term } from './node.ts';

export interface TreeChanges {
  /** by the numbers of the leaves */
  readonly leaves: Changes;
  /** terms and shapes that went or came */
  readonly touched: number;
  /** mm: what came is likely to be in here; null where that is not known */
  readonly reach: Box | null;
}

/** Null where the trees are not built alike, so that leaves have no counterparts. */
export function treeChanges(before: FieldNode, after: FieldNode): TreeChanges | null {
  const comparing = new Comparing();
  if (!comparing.pair(before, after, false)) return null;
  const { changes, touched, reaches } = comparing;
  const reach = reaches && reaches.length > 0 ? reaches.reduce((a, b) => unite(a, b)!) : null;
  return { leaves: changes, touched, reach };
}

/** of T: what a term alone comes to where its body is likely to end, others adding theirs */
const REACH = 3;

class Comparing {
  readonly changes = new Map<number, LeafChange>();
  touched = 0;
  /** of terms that came; null where something else did */
  reaches: Box[] | null = [];
  #depth = 0;
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
        this.#note(isMoved || !isSame(before, after) ? null : undefined, 1);
        return true;
      case 'affine': {
        if (after.type !== 'affine') return false;
        this.#depth++;
        const isAlike = this.pair(before.node, after.node, isMoved || !isSame(before.matrix, after.matrix));
        this.#depth--;
        return isAlike;
      }
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
    const all = Math.max(before.skels.length, after.skels.length);
    if (isMoved || !isSame(body(before), body(after))) {
      this.#note(null, all);
      return;
    }
    const gone = without(before.skels, after.skels);
    const come = without(after.skels, before.skels);
    // a colour moves no surface: what is near would be kept as it was
    const isPainted = !isSame(gone.map(colourOf), come.map(colourOf)) && [...gone, ...come].some(colourOf);
    const bound = (terms: readonly Term[], node: SkelsNode) =>
      terms.flatMap((term) => boundTerms(term, node));
    const change = isPainted ? null : { removed: bound(gone, before), added: bound(come, after) };
    if (change && this.#depth === 0) {
      const reach = ({ field, factor }: BoundTerm) =>
        grown(field.box, field.offset(after.threshold / (REACH * Math.abs(factor))));
      this.reaches?.push(...change.added.map(reach));
    } else if (gone.length + come.length > 0) this.reaches = null;
    const touched = Math.max(gone.length, come.length);
    this.#note(touched > 0 ? change : undefined, isPainted ? all : touched);
  }

  #note(change: LeafChange | undefined, touched: number): void {
    if (change === null) this.reaches = null;
    if (change !== undefined) {
      this.changes.set(this.#leaf, change);
      this.touched += touched;
    }
    this.#leaf++;
  }
}

const colourOf = ({ colour }: Term) => colour;

/** Those that are not among `others`, each of which stands for one. */
function without(terms: readonly Term[], others: readonly Term[]): readonly Term[] {
  const left = new Map<string, number>();
  for (const term of others) {
    const key = JSON.stringify(term);
    left.set(key, (left.get(key) ?? 0) + 1);
  }
  return terms.filter((term) => {
    const key = JSON.stringify(term);
    const count = left.get(key) ?? 0;
    left.set(key, count - 1);
    return count <= 0;
  });
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
