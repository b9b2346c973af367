import type { Document } from '../document.ts';
import type { CommandKind } from './index.ts';

/** Another document in place of this one: opening a file is a step that undo takes back. */
export const load: CommandKind<'load', { readonly document: Document; readonly name: string }> = {
  type: 'load',
  apply: (document, { document: other }) => (document === other ? document : other),
  describe: (_document, { name }) => (name ? `opening ${name}` : 'opening'),
};
