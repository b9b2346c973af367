/**
 * Where people expect a mirror: an ear comes to the other side of the head. The mirror stands upright across what one sees, faced to the nearest
 * axis, through the middle of the largest other thing there is: of the other groups of the solid, or of the other parts. What lies in that
 * middle itself, or alone, is flipped where it is.
 */
import { place3 } from '../math/placement.ts';
import { dot3, length3, rotate3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { toWorld } from '../stroke/plane.ts';
import type { View } from '../stroke/stroke.ts';
import { shapeOf } from './build.ts';
import { groupsIn, partsWith } from './chosen.ts';
import type { Mirror } from './command/mirrorParts.ts';
import { type Document, isImplicit, isSolid, type Part, type SolidPart } from './document.ts';
import { boxOfGroup, boxOfMesh, middleOfParts, seenParts } from './extent.ts';
import type { Group } from './solid.ts';

export interface MirrorAt extends Mirror {
  /** name of what it is the middle of; null: in place */
  readonly across: string | null;
}

/** of the width across the mirror: what is nearer to it lies in the middle */
const MIDDLE = 0.25;

interface Known {
  readonly ids: readonly string[];
  readonly normal: Vec3;
  readonly mirror: MirrorAt | null;
}

/** Of the last selection: whoever turns the view asks again and again. */
const known = new WeakMap<Document, Known>();

/** Null where nothing of it can be seen. */
export function mirrorOf(document: Document, ids: readonly string[], view: View): MirrorAt | null {
  const normal = nearestAxis(rotate3(view.rotation, [1, 0, 0]));
  const last = known.get(document);
  if (last?.ids === ids && last.normal === normal) return last.mirror;
  const mirror = found(document, ids, normal);
  // bodies that are not made yet are nowhere now
  if (document.parts.every((part) => !isImplicit(part) || shapeOf(part)))
    known.set(document, { ids, normal, mirror });
  return mirror;
}

function found(document: Document, ids: readonly string[], normal: Vec3): MirrorAt | null {
  const own = middleOfParts(seenParts(document, ids));
  if (!own) return null;
  const all = thingsOf(document, ids);
  const others = all.filter(({ isChosen }) => !isChosen);
  const largest = others.reduce<Thing | null>((a, b) => (a && size(a) >= size(b) ? a : b), null);
  if (!largest) return { about: own, normal, across: null };
  const width = span(
    all.filter(({ isChosen }) => isChosen).flatMap(({ corners }) => corners),
    normal,
  );
  const about = middle(largest);
  const away = dot3(sub3(own, about), normal);
  return Math.abs(away) < MIDDLE * width
    ? { about: own, normal, across: null }
    : { about, normal, across: largest.name };
}

interface Thing {
  readonly name: string;
  readonly isChosen: boolean;
  /** mm, where it is */
  readonly corners: readonly Vec3[];
}

/** What is compared: the groups of the one solid that all is in, or else parts. */
function thingsOf(document: Document, ids: readonly string[]): readonly Thing[] {
  const parts = new Set(partsWith(document, ids));
  const [only] = parts;
  if (parts.size === 1 && only && isSolid(only) && !ids.includes(only.id))
    return groupsIn(only)
      .filter(({ group }) => !group.hidden)
      .map(({ group, component }) => ({
        name: group.name,
        isChosen: ids.includes(group.id) || ids.includes(component.id),
        corners: cornersOfGroup(group, only),
      }));
  return document.parts
    .filter(({ hidden }) => !hidden)
    .flatMap((part) => {
      const corners = cornersOf(part);
      return corners.length > 0 ? [{ name: part.name, isChosen: parts.has(part), corners }] : [];
    });
}

function cornersOf(part: Part): readonly Vec3[] {
  const mesh = shapeOf(part);
  if (!mesh || mesh.positions.length === 0) return [];
  const { min, max } = boxOfMesh(mesh);
  return [min[0], max[0]].flatMap((x) =>
    [min[1], max[1]].flatMap((y) => [min[2], max[2]].map((z) => place3(part.placement, [x, y, z]))),
  );
}

function cornersOfGroup(group: Group, { placement }: SolidPart): readonly Vec3[] {
  const { min, max } = boxOfGroup(group);
  const { plane } = group.strokes[0]!;
  return [min[0], max[0]].flatMap((x) =>
    [min[1], max[1]].map((y) => place3(placement, toWorld(plane, [x, y]))),
  );
}

const size = ({ corners }: Thing): number => length3(sub3(corners.at(-1)!, corners[0]!));

const middle = ({ corners }: Thing): Vec3 =>
  scale3([0, 1, 2].map((k) => corners[0]![k]! + corners.at(-1)![k]!) as unknown as Vec3, 0.5);

function span(points: readonly Vec3[], along: Vec3): number {
  const at = points.map((p) => dot3(p, along));
  return points.length > 0 ? Math.max(...at) - Math.min(...at) : 0;
}

const AXES: readonly Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

const nearestAxis = (v: Vec3): Vec3 =>
  AXES.reduce((best, axis) => (Math.abs(dot3(v, axis)) > Math.abs(dot3(v, best)) ? axis : best));
