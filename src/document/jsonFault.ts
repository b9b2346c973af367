/**
 * Where a text stops being JSON, and what should stand there. Engines word this each in their own way, and some name no
 * place; so the text is walked once more, with a stack of its own, and only after the engine refused it.
 */

export interface Fault {
  /** of the first character that does not fit; the text's length where it ends too soon */
  readonly offset: number;
  readonly expected: string;
}

/** What comes next. */
type Next = 'value' | 'first item' | 'first key' | 'key' | 'colon' | 'after' | 'end';

interface Walk {
  readonly text: string;
  at: number;
  next: Next;
  /** brackets that wait for their ends */
  readonly open: ('{' | '[')[];
}

/** Null for a text that is JSON. */
export function jsonFault(text: string): Fault | null {
  const walk: Walk = { text, at: 0, next: 'value', open: [] };
  for (;;) {
    while (isSpace(text.charCodeAt(walk.at))) walk.at++;
    if (walk.next === 'end') return walk.at < text.length ? fault(walk, 'the end of the text') : null;
    const found = STEPS[walk.next](walk, text.charAt(walk.at));
    if (found) return found;
  }
}

const fault = ({ at }: Walk, expected: string): Fault => ({ offset: at, expected });

type Step = (walk: Walk, character: string) => Fault | null;

const STEPS: Readonly<Record<Exclude<Next, 'end'>, Step>> = {
  value: (walk, character) => value(walk, character, 'a value'),
  'first item': (walk, character) =>
    character === ']' ? close(walk) : value(walk, character, 'a value or ]'),
  'first key': (walk, character) =>
    character === '}' ? close(walk) : key(walk, character, 'a name in quotation marks or }'),
  key: (walk, character) => key(walk, character, 'a name in quotation marks'),
  colon: (walk, character) => (character === ':' ? go(walk, 'value') : fault(walk, 'a colon')),
  after(walk, character) {
    const [end, next] = walk.open.at(-1) === '{' ? (['}', 'key'] as const) : ([']', 'value'] as const);
    if (character === end) return close(walk);
    return character === ',' ? go(walk, next) : fault(walk, `a comma or ${end}`);
  },
};

/** One character on. */
function go(walk: Walk, next: Next): null {
  walk.at++;
  walk.next = next;
  return null;
}

function close(walk: Walk): null {
  walk.open.pop();
  return go(walk, afterValue(walk));
}

const afterValue = ({ open }: Walk): Next => (open.length > 0 ? 'after' : 'end');

function key(walk: Walk, character: string, expected: string): Fault | null {
  if (character !== '"') return fault(walk, expected);
  return string(walk) ?? go(walk, 'colon');
}

function value(walk: Walk, character: string, expected: string): Fault | null {
  if (character === '{' || character === '[') {
    walk.open.push(character);
    return go(walk, character === '{' ? 'first key' : 'first item');
  }
  if (character === '"') return string(walk) ?? go(walk, afterValue(walk));
  SCALAR.lastIndex = walk.at;
  const scalar = SCALAR.exec(walk.text)?.[0];
  if (!scalar) return fault(walk, expected);
  walk.at += scalar.length;
  walk.next = afterValue(walk);
  return null;
}

const SCALAR = /-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?|true|false|null/y;

/** Stops at the closing quotation mark. */
function string(walk: Walk): Fault | null {
  const { text } = walk;
  for (walk.at++; ; walk.at++) {
    const code = text.charCodeAt(walk.at);
    if (code === QUOTE) return null;
    // the end of the text is no number, and no comparison with it holds
    if (!(code >= FIRST_PRINTED)) return fault(walk, 'a quotation mark at the end of the text before it');
    if (code !== BACKSLASH) continue;
    ESCAPE.lastIndex = walk.at;
    const escaped = ESCAPE.exec(text)?.[0];
    if (!escaped) return fault(walk, 'an escape such as \\n or \\u00e9 after a backslash');
    walk.at += escaped.length - 1;
  }
}

const ESCAPE = /\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4})/y;
const QUOTE = 34;
const BACKSLASH = 92;
const FIRST_PRINTED = 32;

const isSpace = (code: number): boolean => code === 32 || code === 10 || code === 13 || code === 9;
