/** The words for what a tool has to tell. */
import type { Notice as ToolNotice } from '../tool/tool.ts';
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
