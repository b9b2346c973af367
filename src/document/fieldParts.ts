/** The parts of a document that fields have the surface of. */
import type { FieldNode } from '../field/node.ts';
import { type BodyPart, type Document, isImplicit } from './document.ts';
import { partsWithDraft } from './draftPart.ts';
import { nodeOf } from './solidNode.ts';

/** A part that a field has the surface of. */
export interface NamedNode extends Pick<BodyPart, 'id' | 'name' | 'placement' | 'hidden'> {
  readonly node: FieldNode;
}

/** Those of a document; the unfinished form is among them where it is a solid. */
export function bodiesOf(document: Document): readonly NamedNode[] {
  return partsWithDraft(document)
    .filter(isImplicit)
    .map((part) => {
      const { id, name, placement, hidden } = part;
      return { id, name, placement, hidden, node: nodeOf(part) };
    });
}
