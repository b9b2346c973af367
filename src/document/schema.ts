/**
 * What a file may look like, field by field: everything that can be said without looking at two places at once (that is
 * `rules.ts`). Fields with an obvious default may be left out.
 */
import * as v from 'valibot';
import { UNMOVED } from '../math/placement.ts';
import { surfaces } from '../surface/index.ts';
import type { Brush, Document } from './document.ts';
import { DEFAULT_BRUSH } from './document.ts';
import { FRONT_VIEW } from './drawing.ts';
import { between, fields, flag, list, number, oneOf, text, whole } from './fields.ts';
import { LIMITS, RANGES, type Range } from './limits.ts';
import { BACKGROUNDS, DEFAULT_LOOK, KERNEL_CHOICES, type Look, MODES, STYLES } from './look.ts';
import { node } from './nodeSchema.ts';
import { completed, documentRules, draftRules, partRules, planeRules, rotationRules } from './rules.ts';
import { samples } from './samples.ts';

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
}) satisfies v.GenericSchema<unknown, Brush>;

/** Some of the brush. */
export const brushChange = fields({
  colour: v.exactOptional(brushFields.colour),
  radius: v.exactOptional(brushFields.radius),
  pressure: v.exactOptional(brushFields.pressure),
  caps: v.exactOptional(brushFields.caps),
  filter: v.exactOptional(brushFields.filter),
  levels: v.exactOptional(brushFields.levels),
}) satisfies v.GenericSchema<unknown, Partial<Brush>>;

export const name = text(1, LIMITS.name);
const kinds = Object.keys(surfaces) as unknown as readonly (keyof typeof surfaces)[];
const strokes = list(stroke, LIMITS.strokes, 'strokes');

const named = { id: v.optional(name), name: v.optional(name) };
const shown = { placement: v.optional(placement, {}), hidden: v.optional(flag, false) };

export const surfacePart = v.pipe(
  fields({ ...named, kind: oneOf(kinds), strokes, brush: v.optional(brush, {}), ...shown }),
  partRules(),
);

export const bodyPart = fields({
  ...named,
  kind: v.literal('body', '"body"'),
  node,
  colour: v.optional(v.nullable(colour), null),
  ...shown,
});

const allKinds = [...kinds, 'body'].map((kind) => `"${kind}"`).join(', ');
export const part = v.variant('kind', [surfacePart, bodyPart], `one of ${allKinds}`);

export const draft = v.pipe(fields({ strokes }), draftRules());

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
