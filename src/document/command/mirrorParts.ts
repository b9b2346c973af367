import { type Affine, composed } from '../../field/affine.ts';
import type { FieldNode } from '../../field/node.ts';
import { type Placement, place3, unplaced } from '../../math/placement.ts';
import { add3, dot3, scale3, sub3, unrotate3 } from '../../math/tuple.ts';
import type { Vec3 } from '../../math/vec.ts';
import type { Stroke } from '../../stroke/stroke.ts';
import { isBody, isSolid, type Part } from '../document.ts';
import { isFormInReach, isGroupInReach } from '../inReach.ts';
import { type Group, groupsOf, withGroups } from '../solid.ts';
import { type Section, type SectionStroke, withStrokes } from '../surfacePart.ts';
import { changeParts, nameOf } from './changeParts.ts';
import { withHand } from './hand.ts';
import type { CommandKind } from './index.ts';

export interface Mirror {
  /** a point of it, mm, and its unit normal */
  readonly about: Vec3;
  readonly normal: Vec3;
}

export interface Data extends Mirror {
  readonly ids: readonly string[];
}

/** Parts and groups as a mirror shows them. Strokes stay what was drawn; the axes of their planes are mirrored. */
export const mirrorParts: CommandKind<'mirrorParts', Data> = {
  type: 'mirrorParts',
  apply: (document, { ids, about, normal }) =>
    withHand(document, ids, (on, chosen) =>
      changeParts(
        on,
        chosen,
        (part) => mirrored(part, within({ about, normal }, part.placement)),
        (group, of) => {
          const next = mirroredGroup(group, within({ about, normal }, of.placement));
          return isGroupInReach(next) ? next : group;
        },
      ),
    ),
  describe: (document, { ids }) => `${nameOf(document, ids)} mirrored`,
};

/** The mirror as a placed part sees it: the part keeps its placement, and is mirrored before. */
const within = ({ about, normal }: Mirror, placement: Placement): Mirror => ({
  about: place3(unplaced(placement), about),
  normal: unrotate3(placement.rotation, normal),
});

function mirrored(part: Part, mirror: Mirror): Part {
  if (isBody(part)) return { ...part, node: mapped(part.node, matrixOf(mirror)) };
  if (isSolid(part)) {
    const groups = groupsOf(part).map((group) => mirroredGroup(group, mirror));
    return groups.every(isGroupInReach) ? withGroups(part, (group) => [mirroredGroup(group, mirror)]) : part;
  }
  const isFlat = part.sections.length === 0 && part.bends.length === 0;
  const next = withStrokes(part, (stroke) => (isFlat ? mirroredStroke : turnedOver)(stroke, mirror));
  // of closed pairs the first is the left one, however they are seen
  const isRing = part.strokes.length > 1 && part.strokes[0]!.closed;
  const whole = isRing ? { ...next, sections: next.sections.map(swappedSection) } : next;
  return isFormInReach(whole) ? whole : part;
}

/** What is in front stays in front: instead of the plane's normal its x axis is turned over, and what was drawn with it. */
function turnedOver(stroke: Stroke, mirror: Mirror): Stroke {
  const { plane, samples, ...rest } = mirroredStroke(stroke, mirror);
  return {
    ...rest,
    samples: samples.map((sample) => ({ ...sample, x: 0 - sample.x })),
    plane: { ...plane, x: scale3(plane.x, -1) },
  };
}

/** Left and right of its chord swapped once more: it runs from the same stroke to the same one as before. */
const swappedSection = (section: Section): Section => ({
  ...section,
  front: section.front && swapped(section.front),
  back: section.back && swapped(section.back),
  redraws: section.redraws.map(swapped),
});

function swapped<D extends SectionStroke>(drawn: D): D {
  const { samples } = drawn.stroke;
  const [first, last] = [samples[0]!, samples.at(-1)!];
  // on its own plane the chord's middle stays; across, the chord
  const [dx, dy] = drawn.half === null ? [last.x - first.x, last.y - first.y] : [0, 1];
  const from = drawn.half === null ? first : { x: 0, y: 0 };
  const squared = dx * dx + dy * dy;
  const k = squared > 0 ? 2 / squared : 0;
  const over = samples.map((sample) => {
    const off = k * (dx * (sample.y - from.y) - dy * (sample.x - from.x));
    return { ...sample, x: sample.x + off * dy, y: sample.y - off * dx };
  });
  return { ...drawn, stroke: { ...drawn.stroke, samples: over } };
}

/** Maps of maps are one. */
export const mapped = (node: FieldNode, matrix: Affine): FieldNode =>
  node.type === 'affine'
    ? { ...node, matrix: composed(matrix, node.matrix) }
    : { type: 'affine', matrix, node };

const mirroredGroup = (group: Group, mirror: Mirror): Group => ({
  ...group,
  strokes: group.strokes.map((stroke) => mirroredStroke(stroke, mirror)),
});

function mirroredStroke(stroke: Stroke, { about, normal }: Mirror): Stroke {
  const { origin, x, y } = stroke.plane;
  const way = (v: Vec3): Vec3 => sub3(v, scale3(normal, 2 * dot3(v, normal)));
  return { ...stroke, plane: { origin: add3(about, way(sub3(origin, about))), x: way(x), y: way(y) } };
}

/** Rows of a 3 × 4 matrix. */
function matrixOf({ about, normal: n }: Mirror): Affine {
  const d = 2 * dot3(about, n);
  const row = (i: 0 | 1 | 2) => [0, 1, 2].map((k) => (i === k ? 1 : 0) - 2 * n[i] * n[k]!);
  const [a, b, c] = [row(0), row(1), row(2)] as [number[], number[], number[]];
  return [...a, d * n[0], ...b, d * n[1], ...c, d * n[2]] as unknown as Affine;
}
