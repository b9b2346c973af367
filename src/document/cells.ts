/**
 * In how many cells bodies are made: of about the same size all over a document, so that a hundred small bodies take no longer than
 * a large one; and in finer ones where a body is thinner than they are.
 */

import { bindField } from '../field/bind.ts';
import { longest, unite } from '../field/boxes.ts';
import { fitting } from '../field/fitBox.ts';
import { RESOLUTION } from '../field/lattice.ts';
import { Tally } from '../field/near.ts';
import type { FieldNode } from '../field/node.ts';
import { PAGE } from '../field/polygonize.ts';
import type { Thin } from '../field/thin.ts';
import type { TreeField } from '../field/treeField.ts';
import { finished } from '../math/finished.ts';
import { place3 } from '../math/placement.ts';
import { type Box, FieldError } from '../skeleton/skeleton.ts';
import { type Body, CELLS } from './bodies.ts';
import { shapeOf } from './build.ts';
import { type Document, isImplicit, type Part } from './document.ts';
import { boxOfMesh } from './extent.ts';
import { nodeOf } from './solidNode.ts';

/** Of a small body: its own longest side has so many at least, or it would be a crumb. */
const FEWEST = 32;
/** Bodies have whole ones of these parts of all cells: a part that is moved a little leaves the others as they are. */
const STEPS = 8;
/** not just as thick as what is thin */
const ENOUGH = 1.01;
/** times as many cells, for the sake of thin places: four times the work, and only of those bodies that have some */
const MORE = 2;

/** Cells along the longest side of each body when the whole document, hidden parts too, has `cells`. */
export function cellsOfBodies(document: Document, cells: number = CELLS): (node: FieldNode) => number {
  if (document.parts.length < 2) return () => cells;
  let whole = -1;
  return (node) => {
    if (whole < 0) whole = sideOf(document);
    const box = boxOfBody(node);
    // the box of a part that was turned is smaller or larger than its own
    const share = box && longest(box) < whole ? longest(box) / whole : 1;
    const steps = Math.ceil(STEPS * share * (1 - 1e-9));
    return Math.max(Math.round((cells * steps) / STEPS), Math.min(cells, FEWEST));
  };
}

function sideOf({ parts }: Document): number {
  const boxes = parts.map(placedBoxOf).filter((box) => box !== null);
  return boxes.length > 0 ? longest(boxes.reduce(about)) : 0;
}

/** Cells that show all of a body, or as many as are made unasked; those it has where nothing of it is thin. */
export function finerCells({ cells, mesh: { thin } }: Body): number {
  // gaps beside what touches are as narrow as one likes: more cells only move where they close
  if (!thin || thin.gaps === thin.places) return cells;
  const enough = cells * wanting(thin);
  return Math.min(Math.ceil(enough / STEPS) * STEPS, MORE * cells, RESOLUTION.max);
}

/** How much smaller cells have to be to show what is thin. */
export const wanting = ({ finer }: Pick<Thin, 'finer'>): number => ENOUGH * finer;

const about = (a: Box, b: Box): Box => unite(a, b)!;
const ends: Box = { min: [-PAGE, -PAGE, -PAGE], max: [PAGE, PAGE, PAGE] };
const known = new WeakMap<FieldNode, Box | null>();

/** Looks for the box of a body, which takes some milliseconds, before all of a document's are asked for at once. */
export function measureBody(node: FieldNode): void {
  boxOfBody(node);
}

/** Null: it has no surface. What has no end is cut off. */
function boxOfBody(node: FieldNode): Box | null {
  const before = known.get(node);
  if (before !== undefined) return before;
  const field = boundField(node);
  if (!field) {
    // whoever wants the body itself is told why there is none
    known.set(node, null);
    return null;
  }
  const isBounded = [...(field.box?.min ?? []), ...(field.box?.max ?? [Infinity])].every(Number.isFinite);
  const box = isBounded && field.box ? finished(fitting(field.near(new Tally()), field.box)) : ends;
  known.set(node, box);
  return box;
}

function boundField(node: FieldNode): TreeField | null {
  try {
    return bindField(node);
  } catch (error) {
    if (!(error instanceof FieldError)) throw error;
    return null;
  }
}

function placedBoxOf(part: Part): Box | null {
  const box = isImplicit(part) ? boxOfBody(nodeOf(part)) : boxOfSurface(part);
  if (!box) return null;
  const corners = Array.from({ length: 8 }, (_, i) => {
    const end = (axis: 0 | 1 | 2) => ((i >> axis) & 1 ? box.max : box.min)[axis];
    return place3(part.placement, [end(0), end(1), end(2)]);
  });
  return corners.map((at) => ({ min: at, max: at })).reduce(about);
}

function boxOfSurface(part: Part): Box | null {
  try {
    const mesh = shapeOf(part);
    return mesh && mesh.indices.length > 0 ? boxOfMesh(mesh) : null;
  } catch {
    // whoever wants the surface itself is told why there is none
    return null;
  }
}
