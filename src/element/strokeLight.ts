/** The stroke in hand whose number the pointer or the focus is on: in the pencil's colour, so that redrawings can be told apart. */
import type { Draft } from '../document/document.ts';
import type { Session } from './session.ts';

/** It goes out with whatever changes the strokes: numbers are others then. */
const lit = new WeakMap<Session, { readonly draft: Draft; readonly number: number }>();

/** As on the picture; null: none. */
export function litStroke(session: Session): number | null {
  const found = lit.get(session);
  return found && found.draft === session.document.draft ? found.number : null;
}

export function lightStroke(session: Session, number: number | null): void {
  const { draft } = session.document;
  if (litStroke(session) === number) return;
  if (draft && number !== null) lit.set(session, { draft, number });
  else lit.delete(session);
  session.update();
}
