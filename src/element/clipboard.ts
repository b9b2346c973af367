/**
 * Copy, cut and paste: parts as text, so that they go from one drawing to another, and from page to page. The browser's own events carry it,
 * which need no permission; what was copied last is also kept in the page.
 */
import { groupsChosen } from '../document/chosen.ts';
import { nameOf } from '../document/command/changeParts.ts';
import type { Document, Part, SolidPart } from '../document/document.ts';
import { readJson } from '../document/json.ts';
import { checkCommand, FileError } from '../document/serialize.ts';
import { withGroups } from '../document/solid.ts';
import { writtenCommand } from '../document/written.ts';
import { besideOf, removeSelection } from './partDeeds.ts';
import type { Session } from './session.ts';
import { SOLID_WORDS } from './words.ts';

/** What the text is known by. */
const START = '{"type":"paste"';

let kept = '';

/** Chosen groups are a solid of their own, made as theirs was. */
export function partsCopied(document: Document, ids: readonly string[]): readonly Part[] {
  const chosen = new Set(ids);
  const inside = new Set(
    groupsChosen(document, ids)
      .filter(({ solid }) => !chosen.has(solid.id))
      .map(({ group }) => group),
  );
  return document.parts.flatMap((part): readonly Part[] => {
    if (chosen.has(part.id)) return [part];
    if (part.kind !== 'solid') return [];
    const solid: SolidPart = withGroups(part, (group) => (inside.has(group) ? [group] : []));
    const [first, ...others] = solid.components.flatMap(({ groups }) => groups);
    if (!first) return [];
    return [{ ...solid, name: others.length === 0 ? first.name : part.name }];
  });
}

/** A command as scripts have it: whoever pastes it into a file has a script. */
export const textOf = (document: Document, ids: readonly string[]): string =>
  JSON.stringify(writtenCommand({ type: 'paste', parts: partsCopied(document, ids), offset: [0, 0, 0] }));

/** Whole parts, checked as files are; null: the text is none of ours. FileError where it is broken. */
export function partsIn(text: string): readonly Part[] | null {
  if (!text.startsWith(START)) return null;
  const command = checkCommand(readJson(text, 'clipboard'));
  return command.type === 'paste' ? command.parts : null;
}

/** Answers the browser's events; text fields have a clipboard of their own. */
export function clipboard(event: ClipboardEvent, session: Session): void {
  if (isTyping(event)) return;
  if (event.type === 'paste') {
    event.preventDefault();
    pasteText(session, event.clipboardData?.getData('text/plain') || kept);
  } else copy(event, session);
}

/** For those who have no keys: the page's own clipboard, and the system's where it lets us. */
export function copySelection(session: Session): void {
  const { selection, document } = session;
  kept = textOf(document, selection);
  void navigator.clipboard?.writeText(kept).catch(() => {});
  say(session, SOLID_WORDS.copied(nameOf(document, selection)));
}

export async function pasteHere(session: Session): Promise<void> {
  const text = await navigator.clipboard?.readText().catch(() => '');
  pasteText(session, text?.startsWith(START) ? text : kept);
}

/** Nothing selected, nothing copied. */
function copy(event: ClipboardEvent, session: Session): void {
  const { selection, document } = session;
  if (selection.length === 0) return;
  kept = textOf(document, selection);
  event.clipboardData?.setData('text/plain', kept);
  event.preventDefault();
  const name = nameOf(document, selection);
  if (event.type === 'cut') removeSelection(session);
  say(session, event.type === 'cut' ? SOLID_WORDS.cut(name) : SOLID_WORDS.copied(name));
}

/** Beside where it was, so that it is seen. */
function pasteText(session: Session, text: string): void {
  try {
    const parts = partsIn(text);
    if (parts && parts.length > 0) put(session, parts);
    else say(session, SOLID_WORDS.noPaste);
  } catch (error) {
    if (!(error instanceof FileError)) throw error;
    say(session, SOLID_WORDS.noPaste);
  }
}

function put(session: Session, parts: readonly Part[]): void {
  const before = new Set(session.document.parts);
  session.run({ type: 'paste', parts, offset: besideOf(session) });
  const fresh = session.document.parts.filter((part) => !before.has(part)).map(({ id }) => id);
  if (fresh.length === 0) return;
  if (session.tool !== 'select') session.setTool('select');
  session.select(fresh);
  say(session, SOLID_WORDS.pasted(nameOf(session.document, fresh)));
}

function say(session: Session, words: string): void {
  session.said = words;
  session.update();
}

const isTyping = (event: Event): boolean => {
  const [origin] = event.composedPath();
  return origin instanceof Element && origin.matches('input[type=text], textarea, [contenteditable]');
};
