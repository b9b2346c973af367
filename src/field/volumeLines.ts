/** Zhu et al.'s bounding volumes (fig. 4) as lines: three circles of a sphere, rims and sides of a cylinder, the edges of a prism. */

import { type Placement, place3 } from '../math/placement.ts';
import { cos, PI, sin } from '../math/trig.ts';
import { add3, cross3, dot3, scale3, sub3 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import { type Affine, composed, IDENTITY } from './affine.ts';
import type { FieldNode } from './node.ts';
import { boundingVolumes, type Cylinder, type Prism, type Volume } from './zhuVolumes.ts';

/** chords of a circle */
const CHORDS = 24;
/** lines along a cylinder */
const SIDES = 8;

type Line = readonly [from: Vec3, to: Vec3];

/** Of all sums of a tree, six numbers a line, mm; skels with cross sections have none, and neither have shapes. */
export function volumeLines(node: FieldNode, placement: Placement): Float32Array<ArrayBuffer> {
  const lines = linesIn(node, IDENTITY);
  return Float32Array.from(lines.flatMap((line) => line.flatMap((end) => place3(placement, end))));
}

function linesIn(node: FieldNode, matrix: Affine): readonly Line[] {
  switch (node.type) {
    case 'skels': {
      const skels = node.skels.filter(({ warp }) => !warp);
      const lines = skels.length > 0 ? boundingVolumes({ ...node, skels }).flatMap(linesOf) : [];
      return lines.map(([a, b]) => [mapped(matrix, a), mapped(matrix, b)]);
    }
    case 'shape':
      return [];
    case 'affine':
      return linesIn(node.node, composed(matrix, node.matrix));
    case 'blend':
      return [node.a, node.b].flatMap((part) => linesIn(part, matrix));
    case 'morph':
      return [node.from, node.to].flatMap((part) => linesIn(part, matrix));
    default:
      return node.parts.flatMap((part) => linesIn(part, matrix));
  }
}

/** Those without end have none. */
export function linesOf(volume: Volume): readonly Line[] {
  if (!(volume.radius < Infinity)) return [];
  switch (volume.type) {
    case 'sphere': {
      const [x, y, z] = [[1, 0, 0] as const, [0, 1, 0] as const, [0, 0, 1] as const];
      const pairs = [[x, y] as const, [y, z] as const, [z, x] as const];
      return pairs.flatMap(([u, v]) => closed(circle(volume.centre, u, v, volume.radius, CHORDS)));
    }
    case 'cylinder':
      return ofCylinder(volume);
    case 'prism':
      return ofPrism(volume);
  }
}

function ofCylinder({ a, b, radius }: Cylinder): readonly Line[] {
  const axis = sub3(b, a);
  if (axis.every((along) => along === 0)) return [];
  const least = axis.map(Math.abs).indexOf(Math.min(...axis.map(Math.abs)));
  const u = unit(cross3(axis, [0, 1, 2].map((i) => (i === least ? 1 : 0)) as unknown as Vec3));
  const v = unit(cross3(axis, u));
  const [start, end] = [circle(a, u, v, radius, CHORDS), circle(b, u, v, radius, CHORDS)];
  const sides = start.flatMap((from, i): Line[] => (i % (CHORDS / SIDES) === 0 ? [[from, end[i]!]] : []));
  return [...closed(start), ...closed(end), ...sides];
}

function ofPrism({ origin, u, v, loops, radius }: Prism): readonly Line[] {
  const up = scale3(cross3(u, v), radius);
  return loops.flatMap((loop) => {
    const flat = loop.map(([x, y]) => add3(origin, add3(scale3(u, x), scale3(v, y))));
    const [above, below] = [flat.map((corner) => add3(corner, up)), flat.map((corner) => sub3(corner, up))];
    return [...closed(above), ...closed(below), ...above.map((from, i): Line => [from, below[i]!])];
  });
}

const circle = (centre: Vec3, u: Vec3, v: Vec3, radius: number, chords: number): readonly Vec3[] =>
  Array.from({ length: chords }, (_, i) => {
    const angle = (2 * PI * i) / chords;
    return add3(centre, add3(scale3(u, radius * cos(angle)), scale3(v, radius * sin(angle))));
  });

const closed = (corners: readonly Vec3[]): readonly Line[] =>
  corners.map((corner, i) => [corner, corners[(i + 1) % corners.length]!]);

const unit = (a: Vec3): Vec3 => scale3(a, 1 / Math.sqrt(dot3(a, a)));

const mapped = (m: Affine, [x, y, z]: Vec3): Vec3 => [
  m[0] * x + m[1] * y + m[2] * z + m[3],
  m[4] * x + m[5] * y + m[6] * z + m[7],
  m[8] * x + m[9] * y + m[10] * z + m[11],
];
