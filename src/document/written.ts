/** What files hold of documents and commands: the same data, samples as rows, keys always in the same order. */
import type { Stroke, View } from '../stroke/stroke.ts';
import type { Command } from './command/index.ts';
import { type BodyPart, type Brush, type Document, isBody, type Part, type SurfacePart } from './document.ts';
import type { Look } from './look.ts';
import { ordered } from './nodeSchema.ts';
import { rowOf } from './samples.ts';

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

const writtenPart = (part: Part): object => (isBody(part) ? writtenBody(part) : writtenSurface(part));

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
    draft: draft && { strokes: draft.strokes.map(writtenStroke) },
  };
}

export function writtenCommand(command: Command): object {
  if (command.type === 'addStroke') return { type: command.type, stroke: writtenStroke(command.stroke) };
  if (command.type === 'addBody' || command.type === 'setBody')
    return { ...command, node: ordered(command.node) };
  if (command.type !== 'load') return command;
  const { type, name, document } = command;
  return { type, name, document: writtenDocument(document) };
}
