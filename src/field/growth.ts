/** Where a body may be after an edit: where it was before, and in these. */
import type { Changes } from './near.ts';
import type { FieldNode } from './node.ts';
import type { Numbered } from './numbered.ts';

/** Of two trees whose nodes have the numbers of each other; `changes` lead from one to the other. */
export function growth(before: Numbered, after: Numbered, changes: Changes): readonly FieldNode[] {
  if (!changes.has(after.number)) return [];
  const { node } = after;
  const isSet = before.number === after.number && before.node.type === node.type && after.parts.length > 0;
  if (!isSet) return [node];
  const within = (part: Numbered): readonly FieldNode[] => {
    const old = before.parts.find(({ number }) => number === part.number);
    return old ? growth(old, part, changes) : [part.node];
  };
  if (node.type === 'union') return after.parts.flatMap(within);
  if (node.type === 'affine' && before.node.type === 'affine' && node.matrix === before.node.matrix) {
    return within(after.parts[0]!).map((part) => ({ ...node, node: part }));
  }
  if (node.type !== 'subtraction') return [node];
  // where something was taken away before
  const holes = before.parts.slice(1).filter(({ number }) => changes.has(number));
  const first = after.parts[0]!;
  const filled = holes.map(
    ({ node: hole }): FieldNode => ({
      type: 'intersection',
      form: 'hard',
      parts: [first.node, hole],
    }),
  );
  return [...within(first), ...filled];
}
