/** What a page hands to the element, checked as files are: FileError says the place and what was expected. */
import type { Command } from '../document/command/index.ts';
import type { Document } from '../document/document.ts';
import { checkCommands, FileError } from '../document/serialize.ts';

/** None of them is carried out when one of them is none, or names a part that is not there by then. */
export const checkedCommands = (value: unknown, document: Document): readonly Command[] =>
  checkCommands(Array.isArray(value) ? value : [value], document);

export function checkedIds(value: unknown): readonly string[] {
  if (Array.isArray(value) && value.every((id) => typeof id === 'string')) return value;
  throw new FileError('selection', '', 'expected a list of the ids of parts.');
}
