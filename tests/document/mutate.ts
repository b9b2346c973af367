/**
 * Files gone wrong: a sound document or script, changed in one or two places, as data or as text. The same seed gives
 * the same mutants in every engine.
 */
import { serialize, serializeScript } from '../../src/document/serialize.ts';
import { random } from '../fixtures/random.ts';
import { COMMANDS, drawingOf, historyOf } from './files.ts';

export interface Mutant {
  /** what was done to it, for messages */
  readonly kind: string;
  readonly text: string;
}

/** Random choices of one mutant. */
class Dice {
  readonly #next: () => number;

  constructor(seed: number) {
    this.#next = random(seed);
  }

  below(n: number): number {
    return Math.floor(this.#next() * n);
  }

  of<T>(options: readonly T[]): T {
    return options[this.below(options.length)]!;
  }

  chance(share: number): boolean {
    return this.#next() < share;
  }
}

type Holder = Record<PropertyKey, unknown>;

/** A place in the data: `holder[key]`. */
interface Spot {
  readonly holder: Holder;
  readonly key: PropertyKey;
}

const isHolder = (value: unknown): value is Holder => typeof value === 'object' && value !== null;

function spotsIn(value: unknown, found: Spot[] = []): Spot[] {
  if (!isHolder(value)) return found;
  for (const key of Object.keys(value)) {
    found.push({ holder: value, key });
    // of hundreds of samples the first few stand for all
    if (key === 'samples' && Array.isArray(value[key])) spotsIn(value[key].slice(0, 3), found);
    else spotsIn(value[key], found);
  }
  return found;
}

const set = ({ holder, key }: Spot, value: unknown): void => {
  Object.defineProperty(holder, key, { value, enumerable: true, configurable: true, writable: true });
};
const get = ({ holder, key }: Spot): unknown => holder[key];

function nested(depth: number, asObject: boolean): unknown {
  let value: unknown = 0;
  for (let i = 0; i < depth; i++) value = asObject ? { a: value } : [value];
  return value;
}

const HTML = '<img src=x onerror="alert(1)"><script>alert(2)</script>';
const POISON = { polluted: true, toString: 1, hidden: true, type: 'keep' };
const VALUES: readonly unknown[] = [
  null,
  'NaN',
  'Infinity',
  true,
  false,
  -1,
  0,
  '',
  [],
  {},
  [[]],
  [null],
  '1',
  HTML,
  'tube',
];
/** Coordinates far off are sound and slow: they have a test of their own. */
const NUMBERS = [1e308, -1e308, 1e-308, 5e-324, -0, 1000, 1e6 + 1, 1e10, -1, 0.5, 1.5, 2, 3, 1e21, 2 ** 53];

type Change = (spot: Spot, dice: Dice) => void;

const CHANGES: Readonly<Record<string, Change>> = {
  'wrong type': (spot, dice) => set(spot, dice.of(VALUES)),
  number: (spot, dice) => set(spot, dice.of(NUMBERS)),
  'number in a list': (spot, dice) => {
    const value = get(spot);
    if (Array.isArray(value) && value.length) value[dice.below(value.length)] = dice.of(NUMBERS);
    else set(spot, dice.of(NUMBERS));
  },
  nudged(spot, dice) {
    const value = get(spot);
    if (typeof value === 'number')
      set(spot, value * dice.of([0.999, 1.0001, 1.01, -1]) + dice.of([0, 1e-4, 0.3]));
    else set(spot, value === true ? false : 'Nudged');
  },
  'as text': (spot) => set(spot, String(get(spot))),
  'deep nesting': (spot, dice) => set(spot, nested(dice.of([5, 20, 30, 200, 1000]), dice.chance(0.5))),
  deleted({ holder, key }) {
    if (Array.isArray(holder)) holder.splice(Number(key), 1);
    else delete holder[key];
  },
  doubled(spot) {
    const { holder, key } = spot;
    if (Array.isArray(holder)) holder.splice(Number(key), 0, get(spot));
    else set({ holder, key: `${String(key)}2` }, get(spot));
  },
  'unknown key': ({ holder }, dice) => {
    if (Array.isArray(holder)) holder.push(dice.of(VALUES));
    else set({ holder, key: dice.of(['radus', 'constructor', 'toString', 'length', '']) }, dice.of(VALUES));
  },
  __proto__: ({ holder }, dice) => {
    const poison = dice.chance(0.5) ? POISON : { constructor: { prototype: POISON } };
    if (Array.isArray(holder)) holder.push({ ['__proto__']: poison });
    else set({ holder, key: '__proto__' }, poison);
  },
  HTML: (spot) => set(spot, HTML),
  'huge text': (spot, dice) => set(spot, dice.of(['x', HTML, '\ud83d', '\u0000', '🍐']).repeat(10_000)),
  'huge list'(spot, dice) {
    const value = get(spot);
    const first: unknown = Array.isArray(value) ? value[0] : null;
    const item = Array.isArray(first) && first.length <= 6 ? first : [0, 0];
    set(spot, new Array(dice.chance(0.05) ? 1_000_000 : 100_001).fill(item));
  },
  'list for object'(spot) {
    const value = get(spot);
    if (Array.isArray(value)) set(spot, { ...value });
    else set(spot, isHolder(value) ? Object.values(value) : [value]);
  },
  swapped({ holder, key }, dice) {
    const other = dice.of(Object.keys(holder));
    const value = holder[other];
    set({ holder, key: other }, holder[key]);
    set({ holder, key }, value);
  },
};

const TEXT_CHANGES: Readonly<Record<string, (text: string, dice: Dice) => string>> = {
  'very deep nesting': (text, dice) => spliced(text, dice, 0, dice.of(['[', '{"a":']).repeat(100_000)),
  truncated: (text, dice) => text.slice(0, dice.below(text.length)),
  'character changed': (text, dice) => spliced(text, dice, 1, dice.of([...'{}[]",:0-.e+x\\\n\u0000é'])),
  'character missing': (text, dice) => spliced(text, dice, 1, ''),
  'number token': (text, dice) => {
    const numbers = [...text.matchAll(/(?<=[[, ])-?\d+(\.\d+)?(?=[,\]])/g)];
    const { index, 0: found } = dice.of(numbers);
    const token = dice.of([
      'NaN',
      'Infinity',
      '-Infinity',
      'undefined',
      '01',
      '1.',
      '.5',
      '+1',
      '0x10',
      '1e999',
      '-0',
      '1e',
    ]);
    return text.slice(0, index) + token + text.slice(index + found.length);
  },
  'stretch missing': (text, dice) => spliced(text, dice, 1 + dice.below(400), ''),
  twice: (text) => text + text,
  'byte order mark': (text) => `\ufeff${text}`,
  'wrong version': (text, dice) =>
    text.replace('"version": 1', `"version": ${dice.of(['9', '"1"', '0', 'null', '1e308', '-1'])}`),
  'wrong format': (text, dice) =>
    text.replace(/"rotund(-script)?"/, dice.of(['"Rotund"', '"rotund-script"', '"rotund"', '7', HTML])),
  binary: (text, dice) =>
    `\u0089PNG\r\n\u001a\n${String.fromCharCode(...Array.from({ length: 40 }, () => dice.below(256)))}${text}`,
};

function spliced(text: string, dice: Dice, count: number, by: string): string {
  const at = dice.below(text.length);
  return text.slice(0, at) + by + text.slice(at + count);
}

/** The sound files. */
export function soundTexts(): readonly string[] {
  const history = historyOf(COMMANDS);
  const drawing = drawingOf(history.present);
  const load = { type: 'load', document: drawing.document, name: 'inner' } as const;
  return [
    serialize(drawing),
    serializeScript(COMMANDS, drawing),
    serializeScript([load, { type: 'keep' }], drawing),
    // hands write less
    `[{"type":"addStroke","stroke":{"samples":[[0,0],[5,20],[0,40]]}},{"type":"keep"},
      {"type":"setBrush","change":{"radius":2}},{"type":"addStroke","stroke":{"samples":[[9,0],[12,30,0.7]],"plane":{"origin":[0,0,4]}}}]`,
  ];
}

const SOUND = soundTexts();

export function mutant(seed: number): Mutant {
  const dice = new Dice(seed);
  const sound = dice.of(SOUND);
  if (dice.chance(0.25)) {
    const kind = dice.of(Object.keys(TEXT_CHANGES));
    return { kind, text: TEXT_CHANGES[kind]!(sound, dice) };
  }
  const root = { data: JSON.parse(sound) as unknown };
  const done: string[] = [];
  do {
    const kind = dice.of(Object.keys(CHANGES));
    CHANGES[kind]!(dice.of(spotsIn(root.data)), dice);
    done.push(kind);
    // what is huge now would be huge squared
  } while (!done.at(-1)!.startsWith('huge') && dice.chance(0.2));
  return { kind: done.join(', '), text: JSON.stringify(root.data) };
}
