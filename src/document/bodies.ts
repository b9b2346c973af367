/**
 * Meshes of bodies, kept by their trees. Making one takes from milliseconds to seconds, so that it is asked for: at once
 * (`makeBody`: command line, tests) or beside the page by a worker, which hands in what it made (`keepBody`), coarse first. A
 * part that is moved, hidden, named or coloured keeps its tree, and with it the mesh.
 */
import { bindField } from '../field/bind.ts';
import type { FieldMesh } from '../field/brickMesh.ts';
import type { FieldNode } from '../field/node.ts';
import { polygonize } from '../field/polygonize.ts';

/** Along the longest side of a body, where nobody asks for others. */
export const CELLS = 128;

export interface Body {
  readonly mesh: FieldMesh;
  /** along the longest side; 0: the mesh is that of another tree, which this one is an edit of */
  readonly cells: number;
  /** work of the polygonizer, evaluations of the field */
  readonly evaluations: number;
  /** something was kept of the body before an edit: not to the bit what is made at once, as files have to be */
  readonly isEdit?: boolean;
}

const made = new WeakMap<FieldNode, Body>();

/** What was made last; null: nothing yet. */
export const bodyMade = (node: FieldNode): Body | null => made.get(node) ?? null;

/** Of what was made last; where that is a stand-in, or nothing, those that are made unasked. */
export const cellsMade = (node: FieldNode): number => bodyMade(node)?.cells || CELLS;

export function keepBody(node: FieldNode, body: Body): void {
  made.set(node, body);
}

export function dropBody(node: FieldNode): void {
  made.delete(node);
}

/** Made now, if it is not there in this resolution. FieldError for a tree without a field, which no checked document has. */
export function makeBody(node: FieldNode, cells: number = CELLS): Body {
  const known = bodyMade(node);
  if (known?.cells === cells && !known.isEdit) return known;
  const { mesh, evaluations } = polygonize(bindField(node), cells);
  const body = { mesh, cells, evaluations };
  keepBody(node, body);
  return body;
}
