/**
 * The state in the address: what differs from the defaults, by name. What is read there is checked like a file, each entry for
 * itself.
 */
import {
  CHOICE_KEYS,
  CHOICES,
  type ChoiceSpec,
  DEFAULT_STATE,
  type FieldState,
  NUMBER_KEYS,
  NUMBERS,
  type NumberSpec,
  rounded,
} from './fieldState.ts';

interface FromHash {
  readonly state: FieldState;
  /** what is wrong with the address, in words: the first that is, and how much more */
  readonly problem: string | null;
}

/** "#kernel=quartic&radius=20"; nothing for the default state. */
export function toHash(state: FieldState): string {
  const entries = [...CHOICE_KEYS, ...NUMBER_KEYS]
    .filter((key) => state[key] !== DEFAULT_STATE[key])
    .map((key) => [key, String(state[key])]);
  return entries.length > 0 ? `#${new URLSearchParams(entries)}` : '';
}

export function fromHash(hash: string): FromHash {
  const state: Record<string, number | string> = { ...DEFAULT_STATE };
  const [first, ...more] = [...new URLSearchParams(hash.replace(/^#/, ''))].flatMap(
    ([key, text]) => read(state, key, text) ?? [],
  );
  const problem = first && more.length > 0 ? `${first}, and ${more.length} more` : (first ?? null);
  return { state: state as unknown as FieldState, problem };
}

/** Into `state`, where it is as it should be; or what is wrong, in words. */
function read(state: Record<string, number | string>, key: string, text: string): string | null {
  if (Object.hasOwn(CHOICES, key)) {
    const { options }: ChoiceSpec = CHOICES[key as keyof typeof CHOICES];
    const ids = options.map(([id]) => id);
    if (!ids.includes(text)) return `${key} is one of ${ids.join(', ')}; found ${shown(text)}`;
    state[key] = text;
    return null;
  }
  if (!Object.hasOwn(NUMBERS, key)) return `nothing here is called ${shown(key)}`;
  const spec: NumberSpec = NUMBERS[key as keyof typeof NUMBERS];
  const value = text.trim() === '' ? Number.NaN : Number(text);
  const { min, max, step } = spec;
  if (!(value >= min && value <= max) || (step && rounded(spec, value) !== value))
    return `${key} is ${step ? `a multiple of ${step}` : 'a number'} from ${min} to ${max}; found ${shown(text)}`;
  // no −0
  state[key] = value + 0;
  return null;
}

/** Of what strangers wrote, no more than a line holds. */
const shown = (text: string): string => `“${text.length > 24 ? `${text.slice(0, 24)}…` : text}”`;
