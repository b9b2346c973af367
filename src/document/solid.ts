/**
 * What solids are made of, in ConvMo's words (Tai et al. 2004, §6): a solid has components, which stand side by side; a component
 * has groups, whose fields are summed up, so that they blend; a group has the skels of one silhouette, or of another form of strokes.
 */
import type { MedialGraph } from '../skeleton/medial/axis.ts';
import type { Stroke } from '../stroke/stroke.ts';
import type { Brush, SolidPart } from './document.ts';

/** What strokes become in a solid: closed ones a soft body, a plate or a ring, open ones a line or a curve, a tap a point. */
export const FORMS = ['soft', 'plate', 'ring', 'line', 'curve', 'point'] as const;
export type Form = (typeof FORMS)[number];

export const isForm = (form: string): form is Form => (FORMS as readonly string[]).includes(form);

/** most holes of an outline */
export const MOST_HOLES = 64;

/** How many strokes one form is made of at most: outlines have holes. */
export const mostStrokes = (form: Form): number => (form === 'soft' || form === 'plate' ? 1 + MOST_HOLES : 1);

export const SECTIONS = ['round', 'superQuadric', 'extrusion'] as const;

/** the least α of an extrusion (field/extrusion.ts) */
export const EXTRUSION = 2;

/** What can be set of a group beside its brush. */
export interface GroupShape {
  /** λ of all its skels; below 0 they carve */
  readonly weight: number;
  /** β: how much wider its cross section is within its plane, and how much thicker off it */
  readonly breadth: number;
  readonly depth: number;
  readonly section: (typeof SECTIONS)[number];
  /** α of sections that have one */
  readonly exponent: number;
  /** what radii along lines, curves and rings are multiplied by, at even steps from end to end */
  readonly profile: readonly number[];
  /** of curves: segments a piece, and their knots (null: even) */
  readonly density: number;
  readonly knots: readonly number[] | null;
}

export const DEFAULT_SHAPE: GroupShape = {
  weight: 1,
  breadth: 1,
  depth: 1,
  section: 'round',
  exponent: 2,
  profile: [1],
  density: 6,
  knots: null,
};

/** The skels of one form. */
export interface Group {
  readonly id: string;
  readonly name: string;
  readonly hidden: boolean;
  readonly form: Form;
  /** the outline and its holes, or a line; all on the plane of the first */
  readonly strokes: readonly Stroke[];
  readonly brush: Brush;
  readonly shape: GroupShape;
  /** by hand, in place of what strokes make: on their plane, mm. Radii of plates are half their thickness */
  readonly skeleton: MedialGraph | null;
  /** Only shown. No file has it. */
  readonly isRough?: true;
}

/** Groups that blend: one sum of fields. */
export interface Component {
  readonly id: string;
  readonly name: string;
  readonly kernel: string;
  /** T, above 0 */
  readonly threshold: number;
  /** at least one */
  readonly groups: readonly Group[];
}

/** Fits within .8 %, and its width does not show far off (docs/silhouettes.md) */
export const DEFAULT_COMPONENT = { kernel: 'cauchy', threshold: 0.5 } as const;

export const groupsOf = ({ components }: Pick<SolidPart, 'components'>): readonly Group[] =>
  components.flatMap(({ groups }) => groups);

/** With other groups; components without any are gone. The same where nothing changes. */
export function withGroups(
  solid: SolidPart,
  change: (group: Group, of: Component) => readonly Group[],
): SolidPart {
  const components = solid.components.map((component) => {
    const groups = component.groups.flatMap((group) => change(group, component));
    const isSame =
      groups.length === component.groups.length && groups.every((group, i) => group === component.groups[i]);
    return isSame ? component : { ...component, groups };
  });
  if (components.every((component, i) => component === solid.components[i])) return solid;
  return { ...solid, components: components.filter(({ groups }) => groups.length > 0) };
}
