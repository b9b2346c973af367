/**
 * Building blocks of the schemas. A schema's message says what was expected there, and nothing else: place and finding are
 * put to it by `check.ts`. Fields that nobody knows are refused, because a program that does not know a field would
 * lose it on the next save.
 */
import * as v from 'valibot';
import type { Range } from './limits.ts';

export const between = ({ min, max }: Range) => `a number from ${min} to ${max}`;

export function number(range: Range, expected = between(range)) {
  return v.pipe(v.number(expected), v.minValue(range.min, expected), v.maxValue(range.max, expected));
}

export function whole(range: Range) {
  const expected = `a whole number from ${range.min} to ${range.max}`;
  return v.pipe(number(range, expected), v.integer(expected));
}

export const finite = v.pipe(v.number('a finite number'), v.finite('a finite number'));

/** A list of just so many numbers. */
export function numbers(count: number) {
  const expected = `${COUNTS[count] ?? count} finite numbers`;
  return v.pipe(v.array(finite, expected), v.length(count, expected));
}

const COUNTS: Readonly<Record<number, string>> = { 2: 'two', 3: 'three' };

export const flag = v.boolean('true or false');

export const oneOf = <const T extends readonly string[]>(options: T) =>
  v.picklist(options, `one of ${options.map((option) => `"${option}"`).join(', ')}`);

/** A text of so many characters; one character may be two units of UTF-16. */
export function text(least: 0 | 1, most: number) {
  const expected = least ? `a text of 1 to ${most} characters` : `a text of at most ${most} characters`;
  const fits = (value: string) => {
    const length = value.length <= 2 * most ? [...value].length : Infinity;
    return length >= least && length <= most;
  };
  return v.pipe(
    v.string(expected),
    v.check(fits, expected),
    v.metadata({ minLength: least, maxLength: most }),
  );
}

export function list<S extends v.GenericSchema>(item: S, most: number, what: string) {
  const expected = `a list of at most ${most} ${what}`;
  return v.pipe(v.array(item, expected), v.maxLength(most, expected));
}

/** A list that is not empty. */
export function some<S extends v.GenericSchema>(item: S, most: number, what: string) {
  const expected = `a list of 1 to ${most} ${what}`;
  return v.pipe(v.array(item, expected), v.minLength(1, expected), v.maxLength(most, expected));
}

const expectedOf = (schema: v.GenericSchema): string => {
  const { message } = schema as { readonly message?: unknown };
  return typeof message === 'string' ? message : 'an object';
};

/** An object with these fields and no others; valibot's own takes lists for objects. */
export function fields<const E extends v.ObjectEntries>(entries: E) {
  const names = Object.keys(entries).join(', ');
  const schema = v.strictObject(entries, (issue) => {
    const key = issue.path?.[0]?.key as string | undefined;
    if (key === undefined) return `an object with ${names}`;
    return issue.expected === 'never'
      ? `only the fields ${names}`
      : expectedOf(entries[key] as v.GenericSchema);
  });
  type Run = (typeof schema)['~run'];
  const run: Run = (dataset, config) =>
    schema['~run'](Array.isArray(dataset.value) ? { value: null } : dataset, config);
  return { ...schema, '~run': run };
}
