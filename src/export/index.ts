/**
 * Exporters: meshes as files other programs read. One file a format; the list below is the registry from which the
 * command line, the menu and tests read. Deterministic: the same document gives the same bytes everywhere.
 */
import { type Resolution, type Solid, solids } from '../document/build.ts';
import type { Document } from '../document/document.ts';

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
  write(model: Model): Promise<readonly OutFile[]>;
}

export type Format = 'obj' | 'glb' | 'stl' | 'ply';

export const exporters: Partial<Record<Format, Exporter>> = {};

/** The kept, visible parts of a document; the unfinished form is left out. */
export function modelOf(document: Document, name: string, resolution?: Resolution): Model {
  return { name: name || 'rotund', solids: solids(document, resolution) };
}
