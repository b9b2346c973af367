/**
 * The command line. One JSON line on standard output when all went well (`field`: one for each family and kernel); otherwise a message on standard error, exit status
 * 2 for what was asked or given, 1 for what the machine lacks.
 */
import { FileError } from '../document/serialize.ts';
import { type Args, readArgs } from './args.ts';
import { COMMANDS, type CommandSpec } from './commands.ts';
import { field } from './field.ts';
import { commandHelp, generalHelp } from './help.ts';
import { info } from './info.ts';
import { mesh } from './mesh.ts';
import { Problem } from './problem.ts';
import { render } from './render.ts';
import { say } from './say.ts';
import { VERSION } from './version.ts';

const RUN: Readonly<Record<CommandSpec['name'], (args: Args) => Promise<void>>> = {
  mesh,
  render,
  info,
  field,
};

async function main([name, ...rest]: readonly string[]): Promise<void> {
  if (name === '--help' || name === '-h') return print(generalHelp());
  if (name === '--version') return print(`rotund ${VERSION}`);
  const command = commandOf(name);
  const args = readArgs(command, rest);
  if (args.help) return print(commandHelp(command));
  await RUN[command.name](args);
}

function commandOf(name: string | undefined): CommandSpec {
  const known = COMMANDS.find((command) => command.name === name);
  if (known) return known;
  const expected = `expected ${COMMANDS.map((command) => command.name).join(', ')}; rotund --help says more`;
  if (name === undefined) throw new Problem(`no command; ${expected}`);
  throw new Problem(`unknown ${name.startsWith('-') ? 'option' : 'command'} ${name}; ${expected}`);
}

function print(text: string): void {
  process.stdout.write(`${text}\n`);
}

function failed(error: unknown): void {
  const known = error instanceof Problem || error instanceof FileError;
  const message = error instanceof Error ? error.message : String(error);
  say(
    known
      ? `rotund: ${message}`
      : `rotund: this is a mistake in the program: ${(error as Error)?.stack ?? message}`,
  );
  process.exitCode = error instanceof Problem ? error.status : known ? 2 : 1;
}

// A reader that has seen enough (`| head`) is no failure.
process.stdout.on('error', () => {});

await main(process.argv.slice(2)).catch(failed);
