/**
 * The text of a file: JSON that a person can read and a diff can compare. What fits stands on one line, samples are
 * packed into lines, and every number comes back to the bit (JSON alone loses the sign of −0).
 */

/** Characters of a line. */
const WIDTH = 140;

/** of the margin: trees of bodies go deeper than a page is wide */
const WIDEST = 40;

const deeper = (indent: string): string => (indent.length < WIDEST ? `${indent}  ` : indent);

/** Numbers are finite; a list under the key `samples` holds rows of numbers. */
export function layout(value: unknown): string {
  return `${format(value, '', '')}\n`;
}

function format(value: unknown, key: string, indent: string): string {
  if (Array.isArray(value)) {
    if (key === 'samples') return packed(value as readonly (readonly number[])[], indent);
    return bracketed(
      '[]',
      value.map((item) => format(item, '', deeper(indent))),
      indent,
    );
  }
  if (typeof value !== 'object' || value === null) return scalar(value);
  const fields = Object.entries(value).filter(([, field]) => field !== undefined);
  const lines = fields.map(
    ([name, field]) => `${JSON.stringify(name)}: ${format(field, name, deeper(indent))}`,
  );
  return bracketed('{}', lines, indent);
}

const scalar = (value: unknown): string => (Object.is(value, -0) ? '-0' : JSON.stringify(value));

/** On one line where there is room. */
function bracketed(brackets: '[]' | '{}', items: readonly string[], indent: string): string {
  const [open, close] = brackets;
  const pad = brackets === '{}' && items.length ? ' ' : '';
  const length = items.reduce((sum, item) => sum + item.length + 2, indent.length);
  if (length <= WIDTH && !items.some((item) => item.includes('\n'))) {
    return `${open}${pad}${items.join(', ')}${pad}${close}`;
  }
  const inner = deeper(indent);
  return `${open}\n${inner}${items.join(`,\n${inner}`)}\n${indent}${close}`;
}

/** As many rows a line as it has room for. */
function packed(rows: readonly (readonly number[])[], outer: string): string {
  const indent = deeper(outer);
  const lines: string[] = [];
  let line = '';
  for (const row of rows) {
    const text = `[${row.map(scalar).join(',')}]`;
    if (line && indent.length + line.length + text.length >= WIDTH) {
      lines.push(line);
      line = text;
    } else line += line ? `,${text}` : text;
  }
  return `[\n${indent}${[...lines, line].join(`,\n${indent}`)}\n${outer}]`;
}
