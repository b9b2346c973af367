/** Where Zhu et al. look for bodies (field/zhuVolumes.ts), as lines over the picture. */
import type { Document } from '../document/document.ts';
import { bodiesOf } from '../document/fieldParts.ts';
import { volumeLines } from '../field/volumeLines.ts';

const drawn = new WeakMap<Document, Float32Array>();

/** Of all bodies that are seen, six numbers a line, mm; the same array for the same document. */
export function guidesOf(document: Document): Float32Array {
  const known = drawn.get(document);
  if (known) return known;
  const bodies = bodiesOf(document).filter(({ hidden }) => !hidden);
  const each = bodies.map(({ node, placement }) => volumeLines(node, placement));
  const all = new Float32Array(each.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const lines of each) {
    all.set(lines, at);
    at += lines.length;
  }
  drawn.set(document, all);
  return all;
}
