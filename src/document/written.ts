/** What files hold of documents and commands: the same data, samples as rows, keys always in the same order. */
import type { Stroke, View } from '../stroke/stroke.ts';
import type { Command } from './command/index.ts';
import {
  type BodyPart,
  type Brush,
  type Document,
  type Draft,
  isBody,
  isSolid,
  type Part,
  type SolidPart,
  type SurfacePart,
} from './document.ts';
import { isPlainFinish } from './finish.ts';
import type { Look } from './look.ts';
import { ordered } from './nodeSchema.ts';
import { rowOf } from './samples.ts';
import type { Component, Group } from './solid.ts';
import {
  type Bend,
  isPlainDetail,
  PLAIN,
  type Section,
  type SectionStroke,
  type SurfaceForm,
} from './surfacePart.ts';

export const writtenView = ({ pivot, rotation, height, fov }: View): View => ({
  pivot,
  rotation,
  height,
  fov,
});

/** What older programs do not know is left out where it is as they have it. */
export function writtenLook(look: Look): Omit<Look, 'mode'> & Partial<Pick<Look, 'mode'>> {
  const { style, mode, background, outline, grain, wireframe, grid, kernel, creases, overlaps } = look;
  return {
    style,
    ...(mode === 'exact' && { mode }),
    background,
    outline,
    grain,
    wireframe,
    grid,
    kernel,
    creases,
    overlaps,
  };
}

/** What older programs do not know is left out where it is as they have it. */
function writtenBrush({ colour, radius, pressure, caps, filter, levels, finish }: Brush) {
  const { ambient, diffuse, specular, shininess } = finish;
  return {
    colour,
    radius,
    pressure,
    caps,
    filter,
    levels,
    ...(!isPlainFinish(finish) && { finish: { ambient, diffuse, specular, shininess } }),
  };
}

function writtenStroke({ samples, plane: { origin, x, y }, view, pointer, closed }: Stroke) {
  return { pointer, closed, plane: { origin, x, y }, view: writtenView(view), samples: samples.map(rowOf) };
}

function writtenPart(part: Part): object {
  if (isSolid(part)) return writtenSolid(part);
  return isBody(part) ? writtenBody(part) : writtenSurface(part);
}

function writtenSolid({ id, name, kind, components, placement, hidden }: SolidPart) {
  const { rotation, translation } = placement;
  return {
    id,
    name,
    kind,
    hidden,
    placement: { rotation, translation },
    components: components.map(writtenComponent),
  };
}

function writtenComponent({ id, name, kernel, threshold, groups }: Component) {
  return { id, name, kernel, threshold, groups: groups.map(writtenGroup) };
}

function writtenGroup({ id, name, form, hidden, brush, shape, skeleton, strokes }: Group) {
  const { weight, breadth, depth, section, exponent, profile, density, knots } = shape;
  return {
    id,
    name,
    form,
    hidden,
    brush: writtenBrush(brush),
    shape: { weight, breadth, depth, section, exponent, profile, density, knots },
    skeleton,
    strokes: strokes.map(writtenStroke),
  };
}

/** What older programs do not know is left out where it says nothing. */
function intentOf({ form, joins, carves }: Pick<Draft, 'form' | 'joins' | 'carves'>) {
  return { ...(form && { form }), ...(joins && { joins }), ...(carves && { carves }) };
}

function writtenBody({ id, name, kind, node, colour, placement, hidden }: BodyPart) {
  const { rotation, translation } = placement;
  return { id, name, kind, hidden, colour, placement: { rotation, translation }, node: ordered(node) };
}

function writtenSurface(part: SurfacePart) {
  const { id, name, kind, strokes, brush, placement, hidden, bends } = part;
  const { rotation, translation } = placement;
  return {
    id,
    name,
    kind,
    hidden,
    brush: writtenBrush(brush),
    placement: { rotation, translation },
    ...furtherOf(part),
    ...(bends.length > 0 && { bends: bends.map(writtenBend) }),
    strokes: strokes.map(writtenStroke),
  };
}

/** What surfaces of strokes alone have none of is left out, for older programs. */
function furtherOf({
  sections = [],
  back = PLAIN.back,
  between = PLAIN.between,
  detail = PLAIN.detail,
}: Partial<SurfaceForm>) {
  const { rows, columns, u, v } = detail;
  return {
    ...(sections.length > 0 && { sections: sections.map(writtenSection) }),
    ...(back !== PLAIN.back && { back }),
    ...(between !== PLAIN.between && { between }),
    ...(!isPlainDetail(detail) && { detail: { rows, columns, u, v } }),
  };
}

function writtenSection({ u, front, back, redraws, follows }: Section) {
  return {
    u,
    front: front && writtenDrawn(front),
    back: back && writtenDrawn(back),
    redraws: redraws.map(writtenDrawn),
    ...(follows && { follows }),
  };
}

const writtenDrawn = ({ half, stroke }: SectionStroke) => ({ half, stroke: writtenStroke(stroke) });

const writtenBend = ({ keepsLength, isOff, stroke }: Bend) => ({
  keepsLength,
  isOff,
  stroke: writtenStroke(stroke),
});

export function writtenDocument({ parts, draft, brush, tubesOnly, nextId }: Document) {
  return {
    nextId,
    tubesOnly,
    brush: writtenBrush(brush),
    parts: parts.map(writtenPart),
    draft: draft && writtenDraft(draft),
  };
}

function writtenDraft(draft: Draft) {
  const { strokes, recreates } = draft;
  return {
    ...intentOf(draft),
    ...(recreates && { recreates: { part: recreates.part, brush: writtenBrush(recreates.brush) } }),
    ...furtherOf(draft),
    strokes: strokes.map(writtenStroke),
  };
}

/** Commands of surfaces that carry strokes. */
const WITH_STROKES: readonly Command['type'][] = [
  'addSection',
  'redrawSection',
  'setStroke',
  'bend',
  'setBend',
];

/** Strokes anywhere in a command, as files have them. */
function withWrittenStrokes(value: unknown): unknown {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) return value;
  if ('samples' in value) return writtenStroke(value as Stroke);
  return Object.fromEntries(Object.entries(value).map(([key, field]) => [key, withWrittenStrokes(field)]));
}

export function writtenCommand(command: Command): object {
  if (command.type === 'addStroke')
    return { type: command.type, ...intentOf(command), stroke: writtenStroke(command.stroke) };
  if (command.type === 'paste') return { ...command, parts: command.parts.map(writtenPart) };
  if (command.type === 'addBody' || command.type === 'setBody')
    return { ...command, node: ordered(command.node) };
  if (WITH_STROKES.includes(command.type)) return withWrittenStrokes(command) as object;
  if (command.type !== 'load') return command;
  const { type, name, document } = command;
  return { type, name, document: writtenDocument(document) };
}
