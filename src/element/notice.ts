/** What stays in sight until it is answered, or until the next deed: words, places on the ink, and ways on. */
import type { Document } from '../document/document.ts';
import type { Vec3 } from '../math/vec.ts';
import type { View } from '../stroke/stroke.ts';
import { EDIT_WORDS, SILHOUETTE_WORDS, WORDS } from './words.ts';

export interface Notice {
  readonly text: string;
  /** goes with the next deed */
  readonly passing?: boolean;
  /** places on the ink that it is about, mm */
  readonly marks?: readonly Vec3[];
  readonly actions: readonly { readonly label: string; run(): void }[];
}

export function passing(text: string, ...actions: Notice['actions']): Notice {
  return { text, passing: true, actions };
}

/** Nothing drawn is lost: what goes round something twice is filled once. */
export function crossingNotice(marks: readonly Vec3[], undo: () => void): Notice {
  const redraw = { label: SILHOUETTE_WORDS.redraw, run: undo };
  const join = { label: SILHOUETTE_WORDS.join, run: () => {} };
  return { ...passing(SILHOUETTE_WORDS.crosses, redraw, join), marks };
}

/** With a way back to where the first stroke was drawn from. */
export function edgeOnNotice({ draft }: Document, turnTo: (view: View) => void): Notice {
  const first = draft?.strokes[0];
  const turn = first ? [{ label: WORDS.turnBack, run: () => turnTo(first.view) }] : [];
  return passing(WORDS.edgeOn, ...turn);
}

/** What a tap may have meant. */
export function pointNotice(make: () => void): Notice {
  return passing(WORDS.orPoint, { label: WORDS.point, run: make });
}

/** Whether Keep takes it. */
export const isOffer = (notice: Notice | null): notice is Notice => notice?.text === WORDS.orPoint;

/** Whether it asks for another view of a section. */
export const isTurn = (notice: Notice | null): notice is Notice =>
  notice?.text === EDIT_WORDS.said['section-edge-on'];
