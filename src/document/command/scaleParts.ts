import { type Placement, place3, unplaced } from '../../math/placement.ts';
import { add3, scale3, sub3 } from '../../math/tuple.ts';
import type { Vec3 } from '../../math/vec.ts';
import { isInReach, type Stroke } from '../../stroke/stroke.ts';
import { type Brush, isBody, isSolid, type Part } from '../document.ts';
import { isFormInReach, isGroupInReach } from '../inReach.ts';
import { RADII } from '../radii.ts';
import { type Group, groupsOf, withGroups } from '../solid.ts';
import { withStrokes } from '../surfacePart.ts';
import { changeParts, nameOf } from './changeParts.ts';
import { withHand } from './hand.ts';
import type { CommandKind } from './index.ts';
import { mapped } from './mirrorParts.ts';

export interface Data {
  readonly ids: readonly string[];
  /** 0.01–100 */
  readonly factor: number;
  /** the point that stays, mm */
  readonly about: Vec3;
}

/** Makes parts and groups larger or smaller, strokes and radii alike; what would leave the space there is, or the radii that brushes have, stays as it is. */
export const scaleParts: CommandKind<'scaleParts', Data> = {
  type: 'scaleParts',
  apply(document, { ids, factor, about }) {
    if (factor === 1) return document;
    return withHand(document, ids, (on, chosen) =>
      changeParts(
        on,
        chosen,
        (part) => scaled(part, factor, about),
        (group, of) => scaledGroup(group, factor, place3(unplaced(of.placement), about)) ?? group,
      ),
    );
  },
  describe: (document, { ids, factor }) => `${nameOf(document, ids)} ${factor > 1 ? 'larger' : 'smaller'}`,
};

function scaled(part: Part, factor: number, about: Vec3): Part {
  // what is drawn is scaled about its own origin, and the placement takes it to where it belongs
  const translation = add3(about, scale3(sub3(part.placement.translation, about), factor));
  const placement: Placement = { ...part.placement, translation };
  if (!isInReach(translation)) return part;
  if (isBody(part)) {
    const matrix = [factor, 0, 0, 0, 0, factor, 0, 0, 0, 0, factor, 0] as const;
    return { ...part, placement, node: mapped(part.node, matrix) };
  }
  if (isSolid(part)) {
    const isWhole = groupsOf(part).every((group) => scaledGroup(group, factor, [0, 0, 0]));
    if (!isWhole) return part;
    return { ...withGroups(part, (group) => [scaledGroup(group, factor, [0, 0, 0])!]), placement };
  }
  const form = withStrokes(part, (stroke) => scaledStroke(stroke, factor, [0, 0, 0]), factor);
  const brush = scaledBrush(part.brush, factor);
  return brush && isFormInReach(form) ? { ...form, placement, brush } : part;
}

function scaledGroup(group: Group, factor: number, about: Vec3): Group | null {
  const strokes = group.strokes.map((stroke) => scaledStroke(stroke, factor, about));
  // soft bodies follow their outline, whatever the radius
  const brush = scaledBrush(group.brush, factor) ?? (group.form === 'soft' ? group.brush : null);
  if (!brush) return null;
  const { skeleton } = group;
  const nodes = skeleton?.nodes.map(({ at, radius }) => ({
    at: [factor * at[0], factor * at[1]] as const,
    radius: factor * radius,
  }));
  const next = { ...group, strokes, brush, skeleton: skeleton && { nodes: nodes!, links: skeleton.links } };
  return isGroupInReach(next) ? next : null;
}

/** The view scales with it: what was trembling of the hand still is. */
function scaledStroke(stroke: Stroke, factor: number, about: Vec3): Stroke {
  const { samples, plane, view } = stroke;
  return {
    ...stroke,
    samples: samples.map((sample) => ({ ...sample, x: factor * sample.x, y: factor * sample.y })),
    plane: { ...plane, origin: add3(about, scale3(sub3(plane.origin, about), factor)) },
    view: { ...view, height: view.height * factor },
  };
}

/** Null where its radius is none that brushes have. */
function scaledBrush(brush: Brush, factor: number): Brush | null {
  const radius = brush.radius * factor;
  return radius >= RADII.min && radius <= RADII.max ? { ...brush, radius } : null;
}
