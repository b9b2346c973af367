/** `rotund info`: what is in a drawing. */
import { type Args, inputOf } from './args.ts';
import { INFO } from './commands.ts';
import { readInput } from './input.ts';
import { countsOf, leftOut } from './report.ts';
import { result } from './say.ts';

export async function info(args: Args): Promise<void> {
  const { drawing } = await readInput(inputOf(INFO, args));
  result({ ...countsOf(drawing.document), warnings: leftOut(drawing.document) });
}
