/**
 * What is wrong with a file, in one sentence: which file, where in it, what was expected and what was found. What was
 * found is shortened and shown as JSON, so that no line break, control character or page of text gets into a message.
 */

export class FileError extends Error {
  override readonly name = 'FileError';
  /** of the file */
  readonly file: string;
  /** e.g. `document.parts[2].brush.radius`, or `line 3, column 14`; '' = the whole file */
  readonly place: string;

  constructor(
    file: string,
    place: string,
    message: string,
    sentence = place ? `${file}, ${place}: ${message}` : `${file}: ${message}`,
  ) {
    super(sentence);
    this.file = file;
    this.place = place;
  }
}

/** `document.parts[2].brush` */
export function placeOf(path: readonly PropertyKey[]): string {
  const steps = path.map((key) => (typeof key === 'number' ? `[${key}]` : `.${String(key)}`));
  return steps.join('').replace(/^\./, '');
}

/** Characters of a found value. */
const LONGEST_FOUND = 40;

/** A found value in a message. */
export function shown(value: unknown): string {
  if (value === undefined) return 'nothing';
  if (typeof value === 'string') return quoted(value);
  if (Array.isArray(value)) return isFewNumbers(value) ? shortened(`[${value.join(', ')}]`) : listOf(value);
  if (typeof value === 'object' && value !== null) return 'an object';
  return typeof value === 'function' ? 'a function' : shortened(String(value));
}

const isFewNumbers = (list: readonly unknown[]): boolean =>
  list.length > 0 && list.length <= 6 && list.every((value) => typeof value === 'number');

const listOf = ({ length }: readonly unknown[]): string =>
  length === 0 ? 'an empty list' : `a list of ${length}`;

/** As JSON, which quotes line breaks and control characters. */
function quoted(text: string): string {
  const characters = [...text.slice(0, LONGEST_FOUND + 2)].map((c) => JSON.stringify(c).slice(1, -1));
  return shortened(['"', ...characters, '"']);
}

/** Characters that are seen only, none of them cut, and no more than a line has room for. */
function shortened(characters: Iterable<string>): string {
  let text = '';
  for (const character of characters) {
    const seen = character.replace(UNSEEN, (c) => `\\u{${c.codePointAt(0)!.toString(16)}}`);
    if (text.length + seen.length > LONGEST_FOUND + 1) return `${text}…`;
    text += seen;
  }
  return text;
}

const UNSEEN = /[\p{C}\p{Zl}\p{Zp}]/gu;
