/** What is selected, as it is shown, and its colours. */
import { groupsChosen } from '../document/chosen.ts';
import { colourOf, type Part } from '../document/document.ts';
import type { Session } from './session.ts';

/** What is selected as a whole. As shown: with what a control that is being dragged does. */
export function chosenParts(session: Session): Part[] {
  if (session.selection.length === 0) return [];
  return session.shown().parts.filter(({ id }) => session.selection.includes(id));
}

/** Colours of parts, and of groups that are selected within theirs; null: one has several. */
export function coloursOf(session: Session, parts: readonly Part[]): readonly (string | null)[] {
  const whole = new Set(parts.map(({ id }) => id));
  const inside = groupsChosen(session.shown(), session.selection).filter(({ solid }) => !whole.has(solid.id));
  return [...parts.map(colourOf), ...inside.map(({ group }) => group.brush.colour)];
}

/** Null where several are in use. */
export function chosenColour(session: Session): string | null {
  const [colour, ...others] = coloursOf(session, chosenParts(session));
  return others.every((other) => other === colour) ? (colour ?? null) : null;
}
