import type { Document, Part } from '../document.ts';

/** Changes the parts with these ids; the same document when none of them changes. */
export function changeParts(
  document: Document,
  ids: readonly string[],
  change: (part: Part) => Part,
): Document {
  const chosen = new Set(ids);
  const parts = document.parts.map((part) => (chosen.has(part.id) ? change(part) : part));
  return parts.some((part, i) => part !== document.parts[i]) ? { ...document, parts } : document;
}

/** "Stem", or "3 parts". */
export function nameOf(document: Document, ids: readonly string[]): string {
  const chosen = new Set(ids);
  const named = document.parts.filter(({ id }) => chosen.has(id));
  return named.length === 1 ? named[0]!.name : `${named.length} parts`;
}
