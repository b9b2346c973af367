/** A trial: what a command would do is shown while a control is being dragged, and gone when it is cancelled. */
import { apply, type Command } from '../document/command/index.ts';
import type { Document } from '../document/document.ts';
import type { State } from './tool.ts';

export function trial(command: Command, back: State): State {
  let shown: Document | null = null;
  return {
    name: 'trial',
    preview: ({ document }) => (shown ??= apply(document, command)),
    cancel: () => back,
  };
}
