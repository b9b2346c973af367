/**
 * What a file holds: a document, and how it is looked at. The two are kept apart because looking is no deed: undo
 * brings back what was drawn and leaves the view and the style as they are.
 */
import type { View } from '../stroke/stroke.ts';
import { type Document, EMPTY_DOCUMENT } from './document.ts';
import { DEFAULT_LOOK, type Look } from './look.ts';

/** Of a new drawing: 200 mm high, orthographic, seen from the front. */
export const FRONT_VIEW: View = { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 200, fov: 0 };

export interface Drawing {
  /** as on the tray and in suggested file names; may be empty */
  readonly name: string;
  readonly document: Document;
  readonly view: View;
  readonly look: Look;
}

export const EMPTY_DRAWING: Drawing = {
  name: '',
  document: EMPTY_DOCUMENT,
  view: FRONT_VIEW,
  look: DEFAULT_LOOK,
};
