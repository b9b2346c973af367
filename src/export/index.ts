/**
 * Exporters: meshes as files other programs read. One file a format; the list below is the registry from which the
 * command line, the menu and tests read. Deterministic: the same document gives the same bytes everywhere.
 */
import { bodyMade, makeBody } from '../document/bodies.ts';
import { type Resolution, type Solid, solids } from '../document/build.ts';
import { type Document, isImplicit } from '../document/document.ts';
import { nodeOf } from '../document/solidNode.ts';
import { glb } from './glb.ts';
import { obj } from './obj.ts';
import { ply } from './ply.ts';
import { stl } from './stl.ts';

export { ExportError } from './error.ts';

export interface Model {
  /** without extension, as in the files' names; never empty */
  readonly name: string;
  readonly solids: readonly Solid[];
}

/** One file to be written; the first of a list is the one asked for, the others lie beside it. */
export interface OutFile {
  readonly name: string;
  readonly bytes: Uint8Array;
}

export interface Exporter {
  /** also the file's extension */
  readonly id: Format;
  /** as in the menu, e.g. "Wavefront OBJ" */
  readonly label: string;
  /** one line: what it carries and in which unit */
  readonly carries: string;
  readonly mime: string;
  /** A model without triangles makes a valid file without any. ExportError when the model cannot be written. */
  write(model: Model): Promise<readonly OutFile[]>;
}

export type Format = 'obj' | 'glb' | 'stl' | 'ply';

export const exporters: Readonly<Record<Format, Exporter>> = { obj, glb, stl, ply };

/** The kept, visible parts of a document; the unfinished form is left out. Bodies are as they were made last, or made now. */
export function modelOf(document: Document, name: string, resolution: Resolution | null = null): Model {
  for (const part of document.parts) {
    if (isImplicit(part) && !part.hidden && !bodyMade(nodeOf(part))) makeBody(nodeOf(part));
  }
  return { name: name || 'rotund', solids: solids(document, resolution) };
}
