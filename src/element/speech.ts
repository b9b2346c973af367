/** What the status line says of a command; `document` is the one before it. Null: nothing worth saying. */
import { itemsOf } from '../document/command/changeParts.ts';
import { apply, type Command, describe } from '../document/command/index.ts';
import type { Document } from '../document/document.ts';
import { droppedWords, keptWords, previewWords } from './draftWords.ts';
import { WORDS } from './words.ts';

export function spoken(document: Document, command: Command): string | null {
  switch (command.type) {
    case 'keep':
      return keptWords(document);
    case 'drop':
      return droppedWords(document);
    case 'removeLast':
      return deleted(
        document,
        document.parts.slice(-1).map(({ name }) => name),
      );
    case 'removeAll':
      return deleted(
        document,
        document.parts.map(({ name }) => name),
      );
    case 'removeParts':
      return deleted(document, names(document, command.ids));
    case 'recreate':
      return previewWords(apply(document, command));
    case 'addStroke':
    case 'setForm':
    case 'setTubesOnly':
      return null;
    case 'renamePart':
      return WORDS.named(command.name.trim());
    case 'moveParts':
    case 'showParts':
    case 'duplicateParts':
    case 'mirrorParts':
    case 'scaleParts':
    case 'moveGroups':
    case 'paste':
    case 'bend':
      return describe(document, command);
    case 'load':
      return WORDS.opened(command.name);
    default:
      return WORDS.changed(describe(document, command));
  }
}

const names = (document: Document, ids: readonly string[]) =>
  itemsOf(document)
    .filter(({ id }) => ids.includes(id))
    .map(({ name }) => name);

function deleted(document: Document, parts: readonly string[]): string {
  if (parts.length === 0) return document.draft ? WORDS.dropped : WORDS.nothingToDelete;
  return WORDS.deleted(parts);
}
