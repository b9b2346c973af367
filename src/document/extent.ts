/** Where parts are: boxes and middles, cached by reference like the meshes they are measured on. */
import { place3 } from '../math/placement.ts';
import { add2, add3, scale2, scale3 } from '../math/tuple.ts';
import type { Vec2, Vec3 } from '../math/vec.ts';
import { bounds } from '../mesh/measure.ts';
import type { Box, Mesh } from '../mesh/mesh.ts';
import { toWorld } from '../stroke/plane.ts';
import type { Sample } from '../stroke/stroke.ts';
import { shapeOf } from './build.ts';
import { type Document, isSolid, type Part, type SolidPart } from './document.ts';
import type { Group } from './solid.ts';

const boxes = new WeakMap<Mesh, Box>();

export function boxOfMesh(mesh: Mesh): Box {
  const known = boxes.get(mesh);
  if (known) return known;
  const box = bounds(mesh);
  boxes.set(mesh, box);
  return box;
}

/** What a hand can take hold of: a part, or a group of a solid. */
export interface Held {
  readonly id: string;
  /** always the same point of it, mm */
  readonly middle: Vec3;
}

/** Those of the parts, and of the groups of solids, that can be seen and taken hold of, in the document's order. */
export function seenParts(document: Document, ids: readonly string[]): Held[] {
  if (ids.length === 0) return [];
  const wanted = new Set(ids);
  return document.parts
    .filter(({ hidden }) => !hidden)
    .flatMap((part) => {
      if (!wanted.has(part.id)) return isSolid(part) ? seenGroups(part, wanted) : [];
      const middle = middleOf(part);
      return middle ? [{ id: part.id, middle }] : [];
    });
}

function seenGroups(solid: SolidPart, wanted: ReadonlySet<string>): Held[] {
  return solid.components.flatMap(({ id: component, groups }) =>
    groups
      .filter(({ id, hidden }) => !hidden && (wanted.has(component) || wanted.has(id)))
      .map((group) => ({ id: group.id, middle: middleOfGroup(group, solid) })),
  );
}

const inks = new WeakMap<readonly Sample[], Rectangle>();

interface Rectangle {
  readonly min: Vec2;
  readonly max: Vec2;
}

/** Of the strokes on their plane: without waiting for a mesh, and whatever it blends with. */
export function boxOfGroup({ strokes }: Group): Rectangle {
  return strokes
    .map(({ samples }) => boxOfInk(samples))
    .reduce((a, b) => ({
      min: [Math.min(a.min[0], b.min[0]), Math.min(a.min[1], b.min[1])],
      max: [Math.max(a.max[0], b.max[0]), Math.max(a.max[1], b.max[1])],
    }));
}

function boxOfInk(samples: readonly Sample[]): Rectangle {
  const known = inks.get(samples);
  if (known) return known;
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { x, y } of samples)
    [x0, y0, x1, y1] = [Math.min(x0, x), Math.min(y0, y), Math.max(x1, x), Math.max(y1, y)];
  const box: Rectangle = { min: [x0, y0], max: [x1, y1] };
  inks.set(samples, box);
  return box;
}

function middleOfGroup(group: Group, { placement }: Pick<SolidPart, 'placement'>): Vec3 {
  const { min, max } = boxOfGroup(group);
  return place3(placement, toWorld(group.strokes[0]!.plane, scale2(add2(min, max), 0.5)));
}

/** The middle of the box a part had where it was drawn, moved and turned with it: always the same point of the part. */
export function middleOf(part: Part): Vec3 | null {
  const mesh = shapeOf(part);
  if (!mesh) return null;
  const { min, max } = boxOfMesh(mesh);
  return place3(part.placement, scale3(add3(min, max), 0.5));
}

/** Midway between the middles, so that it moves and turns with them. */
export function middleOfParts(parts: readonly Held[]): Vec3 | null {
  if (parts.length === 0) return null;
  return scale3(parts.map(({ middle }) => middle).reduce(add3), 1 / parts.length);
}
