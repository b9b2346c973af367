/** The words for what a tool has to tell. */
import type { Notice as ToolNotice } from '../tool/tool.ts';
import type { ToolName } from './tools.ts';
import { EDIT_WORDS, SECTION_WORDS, WORDS } from './words.ts';

const SAID: Readonly<Record<Exclude<ToolNotice, 'selected'>, string>> = {
  ...EDIT_WORDS.said,
  ...SECTION_WORDS.notAcross,
  'edge-on': WORDS.edgeOn,
  'too-short': WORDS.tooShort,
};

/** `selected`: of the selection. */
export const toolWords = (notice: ToolNotice, selected: string): string =>
  notice === 'selected' ? selected : SAID[notice];

/** What Bend and Redraw ask for, which nobody is to do once they are laid down. */
const ASKED: readonly string[] = [
  EDIT_WORDS.which,
  EDIT_WORDS.redrawHover,
  ...Object.values(EDIT_WORDS.said),
];

/** What the status line says once a tool is laid down; what was done with it stays said. */
export const laidDownWords = (tool: ToolName, said: string): string =>
  (tool === 'bend' || tool === 'redraw') && ASKED.includes(said) ? EDIT_WORDS.left(EDIT_WORDS[tool]) : said;
