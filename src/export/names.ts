/**
 * Names for files: of parts, which people choose freely, and of the files themselves. By character codes rather than by
 * Unicode's classes, which grow from engine to engine.
 */

/** What a part is called where any text may stand; half a surrogate pair is no text. */
export function plainName(name: string, index: number): string {
  return name.replace(/\p{Surrogate}/gu, '\ufffd').trim() || `Part ${index + 1}`;
}

/** Names of one word each, no two alike: for formats where spaces and `#` have a meaning. */
export function wordNames(names: readonly string[]): string[] {
  const taken = new Set<string>();
  const next = new Map<string, number>();
  return names.map((name) => {
    const word = wordOf(name) || 'part';
    let count = next.get(word) ?? 1;
    let distinct = word;
    while (taken.has(distinct)) distinct = `${word}_${++count}`;
    next.set(word, count);
    taken.add(distinct);
    return distinct;
  });
}

/** Letters, digits, `.`, `-` and everything beyond ASCII that is no space or control stay; runs of others become `_`. */
export function wordOf(name: string): string {
  let word = '';
  let gap = false;
  for (const character of name) {
    if (isPlain(character)) {
      word += gap && word ? `_${character}` : character;
      gap = false;
    } else gap = true;
  }
  return word;
}

/** A file's name without what systems forbid in one; `rotund` when nothing is left. */
export function fileName(name: string): string {
  let kept = '';
  for (const character of name) kept += isForbidden(character) ? '-' : character;
  const trimmed = [...kept.replace(/^[\s.]+|[\s.]+$/g, '')].slice(0, LONGEST_NAME).join('');
  if (!trimmed) return 'rotund';
  return RESERVED.test(trimmed) ? `_${trimmed}` : trimmed;
}

const LONGEST_NAME = 60;
/** devices of Windows, with any extension */
const RESERVED = /^(con|prn|aux|nul|com\d|lpt\d)(\.|$)/i;

function isPlain(character: string): boolean {
  const code = character.codePointAt(0)!;
  return code < 0x80 ? /[\w.-]/.test(character) : !isGap(code);
}

function isForbidden(character: string): boolean {
  const code = character.codePointAt(0)!;
  return code < 0x20 || '<>:"/\\|?*'.includes(character) || (isGap(code) && !isSpace(code));
}

/** Beyond ASCII: controls, spaces, marks that only order or join text, halves of surrogate pairs. */
function isGap(code: number): boolean {
  return (
    isSpace(code) ||
    (code >= 0x7f && code <= 0xa0) ||
    (code >= 0x200b && code <= 0x200f) ||
    (code >= 0x2028 && code <= 0x202e) ||
    (code >= 0x2060 && code <= 0x206f) ||
    (code >= 0xd800 && code <= 0xdfff) ||
    code === 0xfeff
  );
}

function isSpace(code: number): boolean {
  return (
    code === 0x20 ||
    code === 0xa0 ||
    code === 0x1680 ||
    (code >= 0x2000 && code <= 0x200a) ||
    code === 0x202f ||
    code === 0x205f ||
    code === 0x3000
  );
}
