/** How the Redraw tool is taken up and laid down. */
import type { Session } from './session.ts';
import { EDIT_WORDS } from './words.ts';

/** A selection stays: it is drawn over first. */
export function startRedraw(session: Session): true {
  session.setTool('redraw');
  session.said = EDIT_WORDS.redrawHover;
  session.update();
  return true;
}

export function leaveRedraw(session: Session): void {
  session.setTool(session.selection.length > 0 ? 'select' : 'draw');
  session.said = EDIT_WORDS.left(EDIT_WORDS.redraw);
  session.update();
}
