/** Help and manual say the same: every option, value and default of the tables is in both, and no other. */
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe, expect, it } from 'vitest';
import { COMMANDS } from '../../src/cli/commands.ts';
import { commandHelp, generalHelp } from '../../src/cli/help.ts';
import { exporters } from '../../src/export/index.ts';

const manual = readFileSync(resolve(import.meta.dirname, '../../docs/cli.md'), 'utf8');
const optionsIn = (text: string): Set<string> => new Set(text.match(/--[a-z][a-z-]*/g));

/** The part of the manual under a heading. */
function section(title: string): string {
  const [, rest = ''] = manual.split(`\n## ${title}\n`);
  return rest.split('\n## ')[0]!;
}

describe('help and manual', () => {
  it('has the sections of a manual page', () => {
    const titles = [...manual.matchAll(/^## (.*)$/gm)].map(([, title]) => title);
    for (const title of ['NAME', 'SYNOPSIS', 'DESCRIPTION', 'OPTIONS', 'OUTPUT', 'EXIT STATUS', 'EXAMPLES']) {
      expect(titles).toContain(title);
    }
    expect(titles).toEqual(expect.arrayContaining(['FILES', 'ENVIRONMENT']));
  });

  it.each(COMMANDS.map((command) => [command.name, command] as const))('agree about %s', (name, command) => {
    const help = commandHelp(command);
    const own = command.options.map((option) => `--${option.name}`);
    expect([...optionsIn(help)].sort()).toEqual([...own].sort());
    const [, options = ''] = section('OPTIONS').split(`### rotund ${name}\n`);
    const listed = options.split('\n### ')[0]!;
    for (const { name: option, short, value } of command.options.filter((known) => known.name !== 'help')) {
      const head = `\`${short ? `-${short}\`, \`` : ''}--${option}${value ? ` ${value}` : ''}\``;
      expect(listed).toContain(head);
    }
    for (const key of command.output.match(/\w+/g)!) expect(section('OUTPUT')).toContain(`\`${key}\``);
    expect(generalHelp()).toContain(command.name);
    expect(manual).toContain(command.synopsis);
  });

  it('name no option that is not there', () => {
    const known = new Set([
      ...COMMANDS.flatMap(({ options }) => options.map(({ name }) => `--${name}`)),
      '--version',
    ]);
    // npm's own, in the examples
    const foreign = new Set(['--silent']);
    const unknown = [...optionsIn(manual)].filter((option) => !known.has(option) && !foreign.has(option));
    expect(unknown).toEqual([]);
  });

  it('name every format', () => {
    for (const id of Object.keys(exporters))
      expect(COMMANDS[0]!.synopsis).toMatch(new RegExp(`[{,]${id}[,}]`));
  });

  it('fits a terminal of 80 columns', () => {
    for (const text of [generalHelp(), ...COMMANDS.map(commandHelp)]) {
      expect(text.split('\n').filter((line) => line.length > 80)).toEqual([]);
    }
  });
});
