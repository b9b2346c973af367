/**
 * Tools are small state machines: a handler returns the next state, or nothing to stay. Every state answers
 * cancel (Escape, a second finger, a lost pointer, a change of tool), so that no gesture can be left half done.
 */
import type { Command } from '../document/command/index.ts';
import type { Document } from '../document/document.ts';
import type { Placement } from '../math/placement.ts';
import type { MedialGraph } from '../skeleton/medial/axis.ts';
import type { Stroke, View } from '../stroke/stroke.ts';
import type { Bending } from './bend.ts';
import type { Mark } from './marks.ts';
import type { Redrawing } from './redraw.ts';
import type { Hit, Viewport } from './viewport.ts';

/** One report of the pointer. */
export interface Pen {
  /** CSS pixels on the canvas */
  readonly x: number;
  readonly y: number;
  readonly pressure: number;
  readonly tiltX: number;
  readonly tiltY: number;
  /** ms, any origin */
  readonly time: number;
  readonly pointer: Stroke['pointer'];
  /** Shift or Ctrl/⌘ is held: adds to what is selected */
  readonly adds?: boolean;
}

/** What a tool has to tell; the words are the interface's. */
export type Notice =
  | 'too-short'
  | 'edge-on'
  | 'selected'
  | 'no-sides'
  | 'off-sides'
  | 'too-narrow'
  | 'bent'
  | 'bend'
  | 'bend-what'
  | 'end-on'
  | 'redraw-what'
  | 'section-edge-on';

/** What a tool sees and may ask for. */
export interface Bench {
  readonly document: Document;
  readonly viewport: Viewport;
  /** ids of the parts and groups that are selected, in the document's order */
  readonly selection: readonly string[];
  select(ids: readonly string[]): void;
  commit(commands: readonly Command[]): void;
  /** The camera comes to where these parts fill the picture. */
  focus(ids: readonly string[]): void;
  /** The camera comes to look like this. */
  lookFrom(view: View): void;
  /** `offer`: what would be done instead, if that is what was meant; `from`: a view from where it can be done */
  notify(notice: Notice, offer?: readonly Command[], from?: View): void;
}

/** The gesture so far, for the wet ink. */
export interface Wet {
  readonly pens: readonly Pen[];
  /** the part it starts on */
  readonly on: Hit | null;
  /** lifting now closes it */
  readonly closing: boolean;
}

/** A rectangle drawn with the pen: opposite corners, CSS pixels. */
export interface Band {
  readonly from: Pen;
  readonly to: Pen;
}

/** To the right, and up. */
export type ScreenAxis = 'x' | 'y';

/** Parts that hang on the pen. */
export interface Carried {
  readonly ids: readonly string[];
  /** where they have come from where they are */
  readonly by: Placement;
  /** of a turn, degrees counter-clockwise, or as the pen goes about the screen's own x or y; of a scaling, what all is multiplied by */
  readonly degrees?: number;
  readonly about?: ScreenAxis;
  readonly factor?: number;
}

export interface State {
  /** the moment, for tests: `draw.idle`, `draw.drawing` */
  readonly name: string;
  readonly wet?: Wet;
  readonly band?: Band;
  readonly carried?: Carried;
  /** as it is under the pen, before it is anybody's */
  readonly skeleton?: MedialGraph;
  /** of the section that is about to be drawn */
  readonly guide?: { readonly u: number; readonly side: 'front' | 'back' };
  /** What the blue pencil draws for it. */
  readonly marks?: readonly Mark[];
  /** Those that follow the document. */
  marked?(bench: Bench): readonly Mark[];
  /** What is being bent. */
  readonly bending?: Bending;
  /** What is drawn over, and how far that reaches. */
  readonly redrawing?: Redrawing;
  /** The tool waits here: gestures that begin elsewhere come back to it. */
  readonly waits?: true;
  /** The unfinished form steps back behind the marks. */
  readonly faint?: true;
  /** A gesture is under way that a moving camera would tear. */
  readonly still?: true;
  /** The document as it would be if the pen were lifted now; null: as it is. */
  preview?(bench: Bench): Document | null;
  /** The pen or the mouse is over the picture without touching it; null: it left. Asked again when the document or the view is another. */
  hover?(pen: Pen | null, bench: Bench): State | undefined;
  down?(pen: Pen, bench: Bench): State | undefined;
  move?(pens: readonly Pen[], bench: Bench): State | undefined;
  up?(bench: Bench): State | undefined;
  cancel(): State;
  /** The tool is laid down. */
  leave?(bench: Bench): void;
}
