import type { Part } from './document.ts';

/** What a kind of part is called in names and messages. */
export const WORD: Readonly<Record<Part['kind'], string>> = {
  tube: 'Tube',
  rotational: 'Rotational',
  body: 'Body',
};
