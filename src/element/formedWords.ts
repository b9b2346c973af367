/** What the unfinished form is after commands that made another one of it; what went of it was said. */
import type { Command } from '../document/command/index.ts';
import { type Document, readingOf } from '../document/document.ts';
import { draftProblem } from './draftProblem.ts';
import { awaitedBack, longName, previewWords } from './draftWords.ts';
import { SECTION_WORDS } from './words.ts';

const FORMING = ['addStroke', 'setTubesOnly', 'setForm', 'addSection', 'removeSection', 'setStroke'];

/** They make another form of the unfinished strokes. */
export const areForming = (commands: readonly Command[]): boolean =>
  commands.some(({ type }) => FORMING.includes(type));

const isRemoval = (command: Command): boolean =>
  command.type === 'removeSection' || (command.type === 'setStroke' && command.stroke === null);

/** `document` is the one after them. Null: nothing worth saying. */
export function formedWords(document: Document, commands: readonly Command[]): string | null {
  const back = awaitedBack(document, commands);
  if (back) return SECTION_WORDS.nowBack(back);
  if (!areForming(commands) || !readingOf(document)) return null;
  const problem = draftProblem(document);
  if (problem) return `${longName(document)}: ${problem}`;
  return commands.every(isRemoval) ? null : previewWords(document);
}
