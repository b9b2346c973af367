/**
 * The package’s main entry: the element’s class, without defining it, and what works on its files without a page. Safe to
 * import where there is no DOM.
 */

export type { Command } from '../document/command/index.ts';
export type { BodyPart, Brush, Document, Draft, Part, SurfacePart } from '../document/document.ts';
export { EMPTY_DOCUMENT } from '../document/document.ts';
export type { Drawing } from '../document/drawing.ts';
export { EMPTY_DRAWING } from '../document/drawing.ts';
export type { Background, Look, Style } from '../document/look.ts';
export { FileError, parse, replay, serialize, serializeScript } from '../document/serialize.ts';
export type { Exporter, Format, Model, OutFile } from '../export/index.ts';
export { exporters, modelOf } from '../export/index.ts';
export type { FieldNode } from '../field/node.ts';
export type { SkelAt } from '../field/skelAt.ts';
export type { Mesh } from '../mesh/mesh.ts';
export type { Plane, Sample, Stroke, View } from '../stroke/stroke.ts';
export type { LoadOptions, RayComparison } from './api.ts';
export type {
  ChangeDetail,
  ErrorDetail,
  RenameDetail,
  RotundSketchEventMap,
  SelectDetail,
} from './events.ts';
export type { Flaw } from './flaws.ts';
export type { Waiting } from './needs.ts';
export type { Picked } from './picked.ts';
export { RotundSketch } from './rotundSketch.ts';
export type { Angles, Shot } from './shot.ts';
export type { StrokeInput } from './strokeInput.ts';
