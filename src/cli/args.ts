/** Arguments: read by Node's parser, judged by ours, because its messages speak of its own rules. */
import { parseArgs } from 'node:util';
import type { CommandSpec, Option } from './commands.ts';
import { Problem } from './problem.ts';

export interface Args {
  readonly help: boolean;
  /** files and the like, in order */
  readonly operands: readonly string[];
  /** by the option's long name */
  readonly values: Readonly<Record<string, string | undefined>>;
}

export function readArgs(command: CommandSpec, argv: readonly string[]): Args {
  const { tokens } = parseArgs({
    args: [...argv],
    options: Object.fromEntries(command.options.map((option) => [option.name, parserOption(option)])),
    strict: false,
    allowPositionals: true,
    tokens: true,
  });
  const operands: string[] = [];
  const values: Record<string, string> = {};
  let help = false;
  for (const token of tokens) {
    if (token.kind === 'positional') operands.push(token.value);
    if (token.kind !== 'option') continue;
    if (token.name === 'help') help = true;
    else values[token.name] = checkedValue(command, token, values);
  }
  return { help, operands, values };
}

/** The one input that every command takes. */
export function inputOf(command: CommandSpec, { operands }: Args): string {
  const [input, ...more] = operands;
  if (input === undefined) throw new Problem(`no input; expected ${command.synopsis}`);
  if (more.length > 0) {
    throw new Problem(`expected one input, found ${operands.length}: ${operands.join(', ')}`);
  }
  if (input === '') throw new Problem('the name of the input is empty');
  return input;
}

interface OptionToken {
  readonly name: string;
  readonly rawName: string;
  readonly value?: string | undefined;
}

function checkedValue(command: CommandSpec, { name, rawName, value }: OptionToken, before: object): string {
  const option = command.options.find((known) => known.name === name);
  const see = `rotund ${command.name} --help lists the options`;
  if (!option) throw new Problem(`unknown option ${rawName}; ${see}`);
  if (Object.hasOwn(before, name)) throw new Problem(`${rawName} is given twice`);
  if (!value || (value.startsWith('-') && value !== '-' && !isNumber(value))) {
    throw new Problem(`${rawName} needs a value: ${rawName} ${option.value}`);
  }
  return value;
}

function parserOption({ value, short }: Option) {
  const type = value ? ('string' as const) : ('boolean' as const);
  return short ? { type, short } : { type };
}

const isNumber = (text: string): boolean => /^-[\d.]/.test(text);
