/**
 * The samples of a stroke as files hold them: a row `[x, y, pressure, tiltX, tiltY, time]` each, of which the last four
 * may be left out; the form the program has in hand, `{ x, y, … }`, is read as well. Checked in a loop of their own:
 * there may be a million, and a schema for each number costs thirty times as much.
 */
import * as v from 'valibot';
import type { Sample } from '../stroke/stroke.ts';
import { LIMITS, RANGES, type Range } from './limits.ts';

interface Field {
  readonly key: keyof Sample;
  readonly range: Range;
  /** of the i-th sample; undefined: it must be given */
  readonly standard?: (i: number) => number;
}

const FIELDS: readonly Field[] = [
  { key: 'x', range: RANGES.coordinate },
  { key: 'y', range: RANGES.coordinate },
  { key: 'pressure', range: RANGES.pressure, standard: () => 0.5 },
  { key: 'tiltX', range: RANGES.tilt, standard: () => 0 },
  { key: 'tiltY', range: RANGES.tilt, standard: () => 0 },
  { key: 'time', range: RANGES.time, standard: (i) => 8 * i },
];
const KEYS: readonly string[] = FIELDS.map(({ key }) => key);
const REQUIRED = FIELDS.filter(({ standard }) => !standard).length;

export const ROW = `[${KEYS.join(', ')}]`;
const COUNT = `1 to ${LIMITS.samples} samples ${ROW}`;

/** As in `Sample`, without names. */
export const rowOf = ({ x, y, pressure, tiltX, tiltY, time }: Sample): readonly number[] => [
  x,
  y,
  pressure,
  tiltX,
  tiltY,
  time,
];

/** What was expected, and where. */
export interface Fault {
  readonly expected: string;
  readonly path: readonly PropertyKey[];
  /** a sentence that says all; nothing else is said then */
  readonly refused?: string;
}

const isFault = (read: Sample | Fault): read is Fault => 'expected' in read;

function readSample(value: unknown, i: number): Sample | Fault {
  const isRow = Array.isArray(value);
  if (typeof value !== 'object' || value === null) return { expected: `a sample ${ROW}`, path: [] };
  const odd = isRow ? wrongLength(value) : unknownKey(value);
  if (odd) return odd;
  const sample: Record<string, number> = {};
  for (let k = 0; k < FIELDS.length; k++) {
    const { key, range, standard } = FIELDS[k]!;
    const place = isRow ? k : key;
    const given = (value as Record<PropertyKey, unknown>)[place];
    const number = given === undefined && standard ? standard(i) : given;
    // written so that NaN is outside
    if (typeof number !== 'number' || !(number >= range.min && number <= range.max)) {
      return { expected: `${key}, a number from ${range.min} to ${range.max}`, path: [place] };
    }
    sample[key] = number;
  }
  return sample as unknown as Sample;
}

function wrongLength(row: readonly unknown[]): Fault | null {
  const fits = row.length >= REQUIRED && row.length <= FIELDS.length;
  return fits ? null : { expected: `${REQUIRED} to ${FIELDS.length} numbers ${ROW}`, path: [] };
}

function unknownKey(value: object): Fault | null {
  const odd = Object.keys(value).find((key) => !KEYS.includes(key));
  return odd === undefined ? null : { expected: `a sample with only ${KEYS.join(', ')}`, path: [] };
}

const numberSchema = ({ range }: Field) => ({ type: 'number', minimum: range.min, maximum: range.max });

/** The same rules for the JSON Schema. */
const SAMPLE_SCHEMA = {
  anyOf: [
    {
      type: 'array',
      description: `${ROW}: mm, mm, 0–1, degrees, degrees, ms; by default pressure 0.5, no tilt, 8 ms a sample`,
      prefixItems: FIELDS.map(numberSchema),
      minItems: REQUIRED,
      items: false,
    },
    {
      type: 'object',
      properties: Object.fromEntries(FIELDS.map((field) => [field.key, numberSchema(field)])),
      required: KEYS.slice(0, REQUIRED),
      additionalProperties: false,
    },
  ],
};

/** The message is what is said where there are none. */
export const samples = {
  message: COUNT,
  ...v.pipe(
    v.unknown(),
    v.metadata({ type: 'array', minItems: 1, maxItems: LIMITS.samples, items: SAMPLE_SCHEMA }),
    v.rawTransform(({ dataset, addIssue, NEVER }): readonly Sample[] => {
      const rows = dataset.value;
      if (!Array.isArray(rows) || rows.length < 1 || rows.length > LIMITS.samples) {
        addIssue({ message: COUNT });
        return NEVER;
      }
      const found: Sample[] = [];
      for (let i = 0; i < rows.length; i++) {
        const read = readSample(rows[i], i);
        if (isFault(read)) {
          addIssue({ message: read.expected, path: pathTo(rows, [i, ...read.path]) });
          return NEVER;
        }
        found.push(read);
      }
      return found;
    }),
  ),
};

/** A path in the form valibot keeps it, through `value`. */
export function pathTo(
  value: unknown,
  keys: readonly PropertyKey[],
): [v.IssuePathItem, ...v.IssuePathItem[]] {
  let input = value;
  const path = keys.map((key): v.IssuePathItem => {
    const item = { type: 'unknown', origin: 'value', input, key, value: (input as never)?.[key] } as const;
    input = item.value;
    return item;
  });
  return path as [v.IssuePathItem, ...v.IssuePathItem[]];
}
