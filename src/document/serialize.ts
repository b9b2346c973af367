/** Files: a drawing or a script as text, and back. (Being written: validation follows.) */
import { apply, type Command } from './command/index.ts';
import { type Document, EMPTY_DOCUMENT } from './document.ts';
import { type Drawing, EMPTY_DRAWING, FRONT_VIEW } from './drawing.ts';
import { DEFAULT_LOOK } from './look.ts';

/** What is wrong with a file, in one sentence: which file, where in it, what was expected and what was found. */
export class FileError extends Error {
  override readonly name = 'FileError';
  /** of the file */
  readonly file: string;
  /** e.g. `document.parts[2].brush.radius`, or `line 3, column 14`; '' = the whole file */
  readonly place: string;

  constructor(file: string, place: string, message: string) {
    super(place ? `${file}, ${place}: ${message}` : `${file}: ${message}`);
    this.file = file;
    this.place = place;
  }
}

/** Reads a document or a script; `file` is what messages call it. Throws FileError, never anything else. */
export function parse(text: string, file: string): Drawing {
  try {
    const data = JSON.parse(text);
    const named = file.replace(/^.*[\\/]|\.(rotund|json)$/g, '');
    if (Array.isArray(data)) return { ...EMPTY_DRAWING, name: named, document: replay(data) };
    const { name = named, view = FRONT_VIEW, look = DEFAULT_LOOK } = data;
    return { name, view, look, document: data.document ?? replay(data.commands) };
  } catch (error) {
    throw new FileError(file, '', String(error));
  }
}

/** The text of a `.rotund` file. */
export function serialize({ name, view, look, document }: Drawing): string {
  return JSON.stringify({ format: 'rotund', version: 1, name, view, look, document });
}

/** The text of a script: commands that make the document from an empty one. */
export function serializeScript(commands: readonly Command[], { name, view, look }: Drawing): string {
  return JSON.stringify({ format: 'rotund-script', version: 1, name, view, look, commands });
}

export function replay(commands: readonly Command[], from: Document = EMPTY_DOCUMENT): Document {
  return commands.reduce(apply, from);
}
