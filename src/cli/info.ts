/** `rotund info`: what is in a drawing. */

import { hasSurface, solidOf } from '../document/build.ts';
import { type Args, inputOf } from './args.ts';
import { INFO } from './commands.ts';
import { readInput } from './input.ts';
import { countsOf, leftOut, withoutSurface } from './report.ts';
import { result } from './say.ts';

/** Whether there is a surface at all shows in the coarsest. */
const COARSE = { u: 4, v: 4 };

export async function info(args: Args): Promise<void> {
  const { drawing } = await readInput(inputOf(INFO, args));
  const { document } = drawing;
  const without = document.parts.filter((part) => !part.hidden && !hasSurface(solidOf(part, COARSE)));
  result({ ...countsOf(document), warnings: [...leftOut(document), ...withoutSurface(without)] });
}
