/** Help, printed from the tables of `commands.ts`. `docs/cli.md` says the same at length. */
import { COMMANDS, type CommandSpec, type Option } from './commands.ts';

const WIDTH = 80;
const COLUMN = 30;

export function generalHelp(): string {
  const commands = COMMANDS.map(({ name, summary }) => entry(name, summary)).join('\n');
  return `Usage: rotund COMMAND IN [OPTION…]

${commands}

IN is a drawing (.rotund) or a script of commands; - reads standard input.
rotund COMMAND --help lists a command's options; rotund --version says which
version this is.`;
}

export function commandHelp({ synopsis, summary, input, options, output, linePer }: CommandSpec): string {
  const lines = linePer ? `one line of JSON for each ${linePer}` : 'one line of JSON';
  const list = options.map((option) => entry(nameOf(option), option.help)).join('\n');
  return `Usage: ${synopsis} [OPTION…]

${filled(`${capital(summary)}. ${input}`, 0)}

${list}

${filled(`Prints ${lines} on standard output: ${output}`, 0)}`;
}

function nameOf({ name, short, value }: Option): string {
  return `${short ? `-${short}, ` : '    '}--${name}${value ? ` ${value}` : ''}`;
}

function entry(name: string, text: string): string {
  const [first = '', ...more] = filled(text, COLUMN).split('\n');
  const head = `  ${name}`;
  if (head.length + 2 > COLUMN) return [head, ' '.repeat(COLUMN) + first, ...more].join('\n');
  return [head.padEnd(COLUMN) + first, ...more].join('\n');
}

/** Broken at spaces; all lines but the first are indented. */
function filled(text: string, indent: number): string {
  const lines: string[] = [''];
  for (const word of text.split(' ')) {
    const line = lines.at(-1)!;
    if (indent + line.length + 1 + word.length > WIDTH && line) lines.push(word);
    else lines[lines.length - 1] = line ? `${line} ${word}` : word;
  }
  return lines.join(`\n${' '.repeat(indent)}`);
}

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);
