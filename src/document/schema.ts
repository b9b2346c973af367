/**
 * What a file may look like, field by field: everything that can be said without looking at two places at once (that is
 * `rules.ts`). Fields with an obvious default may be left out.
 */
import * as v from 'valibot';
import { kernels } from '../kernel/index.ts';
import { UNMOVED } from '../math/placement.ts';
import { surfaces } from '../surface/index.ts';
import { type Brush, DEFAULT_BRUSH, type Document, EMPTY_DOCUMENT, type Part } from './document.ts';
import { FRONT_VIEW } from './drawing.ts';
import { between, fields, flag, list, number, oneOf, some, text, whole } from './fields.ts';
import { type BrushChange, DEFAULT_FINISH } from './finish.ts';
import { LIMITS, RANGES, type Range } from './limits.ts';
import { BACKGROUNDS, DEFAULT_LOOK, KERNEL_CHOICES, type Look, MODES, STYLES } from './look.ts';
import { node } from './nodeSchema.ts';
import {
  completed,
  documentRules,
  draftRules,
  graphRules,
  groupRules,
  partRules,
  planeRules,
  rotationRules,
  unitRules,
} from './rules.ts';
import { samples } from './samples.ts';
import { DEFAULT_COMPONENT, DEFAULT_SHAPE, FORMS, SECTIONS } from './solid.ts';
import { BACKS, BETWEENS, DEFAULT_DETAIL, PLAIN } from './surfacePart.ts';

// ── geometry ──────────────────────────────────────────────────────────────────────────────────────────────

function numbers3(range: Range, expected = `three numbers from ${range.min} to ${range.max}`) {
  const one = number(range);
  return v.strictTuple([one, one, one], expected);
}

export const point = numbers3(RANGES.coordinate);
const axis = numbers3(RANGES.component, 'a unit vector, three numbers');
const component = number(RANGES.component);
const rotation = v.pipe(
  v.strictTuple([component, component, component, component], 'a unit quaternion, four numbers'),
  rotationRules(),
  v.description('unit quaternion x, y, z, w'),
);

export const plane = v.pipe(
  fields({
    origin: v.optional(v.pipe(point, v.description('mm')), [0, 0, 0]),
    x: v.optional(axis, [1, 0, 0]),
    y: v.optional(axis, [0, 1, 0]),
  }),
  planeRules(),
);

const { min, max } = RANGES.fov;
const fovExpected = `0 (orthographic) or ${between(RANGES.fov)}`;
const fov = v.pipe(
  v.number(fovExpected),
  v.check((value) => value === 0 || (value >= min && value <= max), fovExpected),
  v.metadata({
    anyOf: [{ const: 0 }, { minimum: min, maximum: max }],
    description: 'degrees; 0 = orthographic',
  }),
);

export const view = fields({
  pivot: v.optional(v.pipe(numbers3(RANGES.pivot), v.description('mm')), FRONT_VIEW.pivot),
  rotation: v.optional(rotation, FRONT_VIEW.rotation),
  height: v.optional(
    v.pipe(number(RANGES.height), v.description('mm visible at the pivot')),
    FRONT_VIEW.height,
  ),
  fov: v.optional(fov, FRONT_VIEW.fov),
});

export const unitVector = v.pipe(axis, unitRules());

export const placement = fields({
  rotation: v.optional(rotation, UNMOVED.rotation),
  translation: v.optional(v.pipe(point, v.description('mm')), UNMOVED.translation),
});

// ── documents ─────────────────────────────────────────────────────────────────────────────────────────────

export const stroke = fields({
  samples,
  plane: v.optional(plane, {}),
  view: v.optional(view, {}),
  pointer: v.optional(oneOf(['pen', 'touch', 'mouse']), 'pen'),
  closed: v.optional(flag, false),
});

export const colour = v.pipe(v.string('a colour #rrggbb'), v.regex(/^#[0-9a-fA-F]{6}$/, 'a colour #rrggbb'));

const finishFields = {
  ambient: number(RANGES.light),
  diffuse: number(RANGES.light),
  specular: number(RANGES.specular),
  shininess: number(RANGES.shininess),
};

const finish = fields({
  ambient: v.optional(finishFields.ambient, DEFAULT_FINISH.ambient),
  diffuse: v.optional(finishFields.diffuse, DEFAULT_FINISH.diffuse),
  specular: v.optional(finishFields.specular, DEFAULT_FINISH.specular),
  shininess: v.optional(finishFields.shininess, DEFAULT_FINISH.shininess),
});

const brushFields = {
  colour,
  radius: v.pipe(number(RANGES.radius), v.description('of tubes, mm')),
  pressure: flag,
  caps: flag,
  filter: oneOf(['least-squares', 'chaikin', 'cubic']),
  levels: whole(RANGES.levels),
};

export const brush = fields({
  colour: v.optional(brushFields.colour, DEFAULT_BRUSH.colour),
  radius: v.optional(brushFields.radius, DEFAULT_BRUSH.radius),
  pressure: v.optional(brushFields.pressure, DEFAULT_BRUSH.pressure),
  caps: v.optional(brushFields.caps, DEFAULT_BRUSH.caps),
  filter: v.optional(brushFields.filter, DEFAULT_BRUSH.filter),
  levels: v.optional(brushFields.levels, DEFAULT_BRUSH.levels),
  finish: v.optional(finish, DEFAULT_FINISH),
}) satisfies v.GenericSchema<unknown, Brush>;

/** Some of the brush. */
export const brushChange = fields({
  colour: v.exactOptional(brushFields.colour),
  radius: v.exactOptional(brushFields.radius),
  pressure: v.exactOptional(brushFields.pressure),
  caps: v.exactOptional(brushFields.caps),
  filter: v.exactOptional(brushFields.filter),
  levels: v.exactOptional(brushFields.levels),
  finish: v.exactOptional(
    fields({
      ambient: v.exactOptional(finishFields.ambient),
      diffuse: v.exactOptional(finishFields.diffuse),
      specular: v.exactOptional(finishFields.specular),
      shininess: v.exactOptional(finishFields.shininess),
    }),
  ),
}) satisfies v.GenericSchema<unknown, BrushChange>;

export const name = text(1, LIMITS.name);
const kinds = Object.keys(surfaces) as unknown as readonly (keyof typeof surfaces)[];
const strokes = list(stroke, LIMITS.strokes, 'strokes');

const named = { id: v.optional(name), name: v.optional(name) };
const shown = { placement: v.optional(placement, {}), hidden: v.optional(flag, false) };

export const u = v.pipe(number(RANGES.u), v.description('along the construction curves'));

export const sectionStroke = fields({
  stroke,
  half: v.optional(v.nullable(v.pipe(number(RANGES.half), v.description('mm'))), null),
});

/** Drawn over a section. */
export const redrawnStroke = fields({
  stroke,
  half: v.pipe(number(RANGES.half), v.description('mm')),
});

export const section = fields({
  u,
  front: v.optional(v.nullable(sectionStroke), null),
  back: v.optional(v.nullable(sectionStroke), null),
  redraws: v.optional(list(redrawnStroke, LIMITS.redraws, 'redrawn strokes'), []),
  follows: v.exactOptional(v.literal(true, 'true')),
});

const bendFields = { stroke, keepsLength: flag, isOff: flag };

export const bend = fields({
  stroke,
  keepsLength: v.optional(flag, true),
  isOff: v.optional(flag, false),
});

/** Some of a bend. */
export const bendChange = fields({
  stroke: v.exactOptional(bendFields.stroke),
  keepsLength: v.exactOptional(bendFields.keepsLength),
  isOff: v.exactOptional(bendFields.isOff),
});

const detailFields = {
  rows: v.nullable(whole(RANGES.rows)),
  columns: whole(RANGES.columns),
  u: whole(RANGES.subdivisions),
  v: whole(RANGES.subdivisions),
};

export const detail = fields({
  rows: v.optional(detailFields.rows, DEFAULT_DETAIL.rows),
  columns: v.optional(detailFields.columns, DEFAULT_DETAIL.columns),
  u: v.optional(detailFields.u, DEFAULT_DETAIL.u),
  v: v.optional(detailFields.v, DEFAULT_DETAIL.v),
});

const back = oneOf(BACKS);
const blending = oneOf(BETWEENS);

/** Some of what can be set of a surface beside its strokes. */
export const surfaceChange = fields({
  back: v.exactOptional(back),
  between: v.exactOptional(blending),
  detail: v.exactOptional(
    fields({
      rows: v.exactOptional(detailFields.rows),
      columns: v.exactOptional(detailFields.columns),
      u: v.exactOptional(detailFields.u),
      v: v.exactOptional(detailFields.v),
      finer: v.exactOptional(whole(RANGES.finer)),
    }),
  ),
});

const sections = list(section, LIMITS.sections, 'sections');

export const surfacePart = v.pipe(
  fields({
    ...named,
    kind: oneOf(kinds),
    strokes,
    sections: v.optional(sections, []),
    back: v.optional(back, PLAIN.back),
    between: v.optional(blending, PLAIN.between),
    bends: v.optional(list(bend, LIMITS.bends, 'bends'), []),
    detail: v.optional(detail, {}),
    brush: v.optional(brush, {}),
    ...shown,
  }),
  partRules(),
);

export const bodyPart = fields({
  ...named,
  kind: v.literal('body', '"body"'),
  node,
  colour: v.optional(v.nullable(colour), null),
  ...shown,
});

const finitePlane = v.strictTuple([number(RANGES.coordinate), number(RANGES.coordinate)], 'two numbers');
const index = whole({ min: 0, max: LIMITS.nodes - 1 });

/** A skeleton on the plane of strokes: circles, and which are linked. */
export const skeleton = v.pipe(
  fields({
    nodes: some(fields({ at: finitePlane, radius: number(RANGES.skeletonRadius) }), LIMITS.nodes, 'circles'),
    links: v.optional(
      v.pipe(
        v.array(v.strictTuple([index, index], 'two indices of circles'), 'a list of links'),
        v.maxLength(2 * LIMITS.nodes, `at most ${2 * LIMITS.nodes} links`),
      ),
      [],
    ),
  }),
  graphRules(),
);

const positive = number(RANGES.factor);

const shapeFields = {
  weight: number(RANGES.weight),
  breadth: positive,
  depth: positive,
  section: oneOf(SECTIONS),
  exponent: number(RANGES.exponent),
  profile: some(positive, LIMITS.profile, 'factors'),
  density: whole(RANGES.density),
  knots: v.nullable(list(number(RANGES.coordinate), LIMITS.nodes, 'knots')),
};

export const shape = fields({
  weight: v.optional(shapeFields.weight, DEFAULT_SHAPE.weight),
  breadth: v.optional(shapeFields.breadth, DEFAULT_SHAPE.breadth),
  depth: v.optional(shapeFields.depth, DEFAULT_SHAPE.depth),
  section: v.optional(shapeFields.section, DEFAULT_SHAPE.section),
  exponent: v.optional(shapeFields.exponent, DEFAULT_SHAPE.exponent),
  profile: v.optional(shapeFields.profile, [...DEFAULT_SHAPE.profile]),
  density: v.optional(shapeFields.density, DEFAULT_SHAPE.density),
  knots: v.optional(shapeFields.knots, DEFAULT_SHAPE.knots),
});

/** Some of what can be set of a group. */
export const groupChange = fields({
  form: v.exactOptional(oneOf(FORMS)),
  weight: v.exactOptional(shapeFields.weight),
  breadth: v.exactOptional(shapeFields.breadth),
  depth: v.exactOptional(shapeFields.depth),
  section: v.exactOptional(shapeFields.section),
  exponent: v.exactOptional(shapeFields.exponent),
  profile: v.exactOptional(shapeFields.profile),
  density: v.exactOptional(shapeFields.density),
  knots: v.exactOptional(shapeFields.knots),
});

export const group = v.pipe(
  fields({
    ...named,
    form: oneOf(FORMS),
    hidden: v.optional(flag, false),
    strokes,
    brush: v.optional(brush, {}),
    shape: v.optional(shape, {}),
    skeleton: v.optional(v.nullable(skeleton), null),
  }),
  groupRules(),
);

const kernelName = oneOf(kernels.map(({ name: kernel }) => kernel));
const threshold = number(RANGES.fieldThreshold);

export const sumOfGroups = fields({
  ...named,
  kernel: v.optional(kernelName, DEFAULT_COMPONENT.kernel),
  threshold: v.optional(threshold, DEFAULT_COMPONENT.threshold),
  groups: some(group, LIMITS.strokes, 'groups'),
});

/** Some of what can be set of a component. */
export const componentChange = fields({
  kernel: v.exactOptional(kernelName),
  threshold: v.exactOptional(threshold),
});

export const solidPart = fields({
  ...named,
  kind: v.literal('solid', '"solid"'),
  components: some(sumOfGroups, LIMITS.strokes, 'components'),
  ...shown,
});

const allKinds = [...kinds, 'body', 'solid'].map((kind) => `"${kind}"`).join(', ');
export const part = v.variant('kind', [surfacePart, bodyPart, solidPart], `one of ${allKinds}`);

export const joins = fields({ solid: name, component: v.nullable(name) });
const draftForms = [...FORMS, ...kinds] as const;

/** What a stroke is to become. */
export const intent = {
  form: v.exactOptional(oneOf(draftForms)),
  joins: v.exactOptional(joins),
  carves: v.exactOptional(v.literal(true, 'true')),
};
export const form = oneOf(draftForms);

const recreated = fields({ part: name, brush: v.optional(brush, {}) });

export const draft = v.pipe(
  fields({
    strokes,
    ...intent,
    sections: v.exactOptional(sections),
    back: v.exactOptional(back),
    between: v.exactOptional(blending),
    detail: v.exactOptional(detail),
    recreates: v.exactOptional(recreated),
  }),
  draftRules(),
);

/** A part in hand: nothing of it is left out, and it is complete in itself. */
export const wholePart = v.pipe(
  part,
  v.transform((found): Part => completed({ ...EMPTY_DOCUMENT, parts: [found], nextId: undefined }).parts[0]!),
);

export const document = v.pipe(
  fields({
    version: v.optional(v.literal(1, '1'), 1),
    parts: v.optional(list(part, LIMITS.strokes, 'parts'), []),
    draft: v.optional(v.nullable(draft), null),
    brush: v.optional(brush, {}),
    tubesOnly: v.optional(flag, false),
    nextId: v.optional(whole(RANGES.nextId)),
  }),
  v.transform((found): Document => completed(found)),
  documentRules<Document>(),
) satisfies v.GenericSchema<unknown, Document>;

export const look = fields({
  style: v.optional(oneOf(STYLES), DEFAULT_LOOK.style),
  mode: v.optional(oneOf(MODES), DEFAULT_LOOK.mode),
  background: v.optional(oneOf(BACKGROUNDS), DEFAULT_LOOK.background),
  outline: v.optional(flag, DEFAULT_LOOK.outline),
  grain: v.optional(flag, DEFAULT_LOOK.grain),
  wireframe: v.optional(flag, DEFAULT_LOOK.wireframe),
  grid: v.optional(flag, DEFAULT_LOOK.grid),
  kernel: v.optional(oneOf(KERNEL_CHOICES), DEFAULT_LOOK.kernel),
  creases: v.optional(number(RANGES.threshold), DEFAULT_LOOK.creases),
  overlaps: v.optional(number(RANGES.threshold), DEFAULT_LOOK.overlaps),
}) satisfies v.GenericSchema<unknown, Look>;
