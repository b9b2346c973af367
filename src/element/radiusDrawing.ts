/** The next stroke says how thick tubes are: of the selected parts, or what is drawn from now on. */
import type { Command } from '../document/command/index.ts';
import { middleOfParts, seenParts } from '../document/extent.ts';
import { sizing } from '../tool/radius.ts';
import type { Session } from './session.ts';
import { SIZE_WORDS } from './words.ts';

export function drawRadius(session: Session, command: (mm: number) => Command): void {
  const middle = middleOfParts(seenParts(session.document, session.selection));
  session.begin(sizing({ at: middle ?? session.view.pivot, command, back: session.idle }));
  session.said = SIZE_WORDS.hint;
  session.update();
}

export const isDrawingRadius = ({ state }: Session): boolean => state.name.startsWith('radius.');
