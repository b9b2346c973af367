/** Who makes the meshes of bodies: the seam between `rotund mesh` and what computes. */
import { type Body, makeBody } from '../document/bodies.ts';
import type { FieldNode } from '../field/node.ts';
import { Problem } from './problem.ts';
import type { Backend } from './values.ts';

/** Makes a body in so many cells along its longest side, and keeps it for the exporter (`keepBody`). */
export type BodyMaker = (node: FieldNode, cells: number) => Promise<Body>;

export function bodyMaker(backend: Backend): BodyMaker {
  if (backend === 'cpu') return async (node, cells) => makeBody(node, cells);
  throw new Problem('--backend gpu does not exist yet; meshes are computed on the cpu');
}
