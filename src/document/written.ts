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
import type { Look } from './look.ts';
import { ordered } from './nodeSchema.ts';
import { rowOf } from './samples.ts';
import type { Component, Group } from './solid.ts';

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

function writtenBrush({ colour, radius, pressure, caps, filter, levels }: Brush): Brush {
  return { colour, radius, pressure, caps, filter, levels };
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

function writtenSurface({ id, name, kind, strokes, brush, placement, hidden }: SurfacePart) {
  const { rotation, translation } = placement;
  return {
    id,
    name,
    kind,
    hidden,
    brush: writtenBrush(brush),
    placement: { rotation, translation },
    strokes: strokes.map(writtenStroke),
  };
}

export function writtenDocument({ parts, draft, brush, tubesOnly, nextId }: Document) {
  return {
    nextId,
    tubesOnly,
    brush: writtenBrush(brush),
    parts: parts.map(writtenPart),
    draft: draft && { ...intentOf(draft), strokes: draft.strokes.map(writtenStroke) },
  };
}

export function writtenCommand(command: Command): object {
  if (command.type === 'addStroke')
    return { type: command.type, ...intentOf(command), stroke: writtenStroke(command.stroke) };
  if (command.type === 'paste') return { ...command, parts: command.parts.map(writtenPart) };
  if (command.type === 'addBody' || command.type === 'setBody')
    return { ...command, node: ordered(command.node) };
  if (command.type !== 'load') return command;
  const { type, name, document } = command;
  return { type, name, document: writtenDocument(document) };
}
