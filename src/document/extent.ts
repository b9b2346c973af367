/** Where parts are: boxes and middles, cached by reference like the meshes they are measured on. */
import { place3 } from '../math/placement.ts';
import { add3, scale3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { bounds } from '../mesh/measure.ts';
import type { Box, Mesh } from '../mesh/mesh.ts';
import { shapeOf } from './build.ts';
import type { Document, Part } from './document.ts';

const boxes = new WeakMap<Mesh, Box>();

export function boxOfMesh(mesh: Mesh): Box {
  const known = boxes.get(mesh);
  if (known) return known;
  const box = bounds(mesh);
  boxes.set(mesh, box);
  return box;
}

/** Those of the parts that can be seen and taken hold of, in the document's order. */
export function seenParts(document: Document, ids: readonly string[]): Part[] {
  if (ids.length === 0) return [];
  const wanted = new Set(ids);
  return document.parts.filter((part) => wanted.has(part.id) && !part.hidden && shapeOf(part));
}

/** The middle of the box a part had where it was drawn, moved and turned with it: always the same point of the part. */
export function middleOf(part: Part): Vec3 | null {
  const mesh = shapeOf(part);
  if (!mesh) return null;
  const { min, max } = boxOfMesh(mesh);
  return place3(part.placement, scale3(add3(min, max), 0.5));
}

/** Midway between the parts' middles, so that it moves and turns with them. */
export function middleOfParts(parts: readonly Part[]): Vec3 | null {
  const middles = parts.map(middleOf).filter((middle) => middle !== null);
  if (middles.length === 0) return null;
  return scale3(middles.reduce(add3), 1 / middles.length);
}
