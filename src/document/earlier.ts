/** Files from before there were silhouettes: closed strokes that nobody said anything of were tubes, or sides of a round form, and stay so. */
import type { Command } from './command/index.ts';
import type { Document, Draft } from './document.ts';
import type { Version } from './fileSchema.ts';

/** The first version that has solids. */
export const SOLIDS: Version = 4;

/** What says nothing, and was read as something else before. */
const isUnsaid = ({ form }: Pick<Draft, 'form'>, closed: boolean | undefined): boolean =>
  closed === true && form === undefined;

export function documentThen(document: Document, version: Version): Document {
  const { draft } = document;
  if (version >= SOLIDS || !draft || !isUnsaid(draft, draft.strokes[0]?.closed)) return document;
  return { ...document, draft: { ...draft, form: 'rotational' } };
}

export function commandThen(command: Command, version: Version): Command {
  if (command.type === 'load') return { ...command, document: documentThen(command.document, version) };
  const isLate = version >= SOLIDS || command.type !== 'addStroke';
  return isLate || !isUnsaid(command, command.stroke.closed) ? command : { ...command, form: 'rotational' };
}
