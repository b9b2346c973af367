/** `rotund info`: what is in a drawing. */

import { hasSurface, solidOf } from '../document/build.ts';
import { isSurface } from '../document/document.ts';
import { type Args, inputOf } from './args.ts';
import { INFO } from './commands.ts';
import { readInput } from './input.ts';
import { countsOf, leftOut, withoutEnd, withoutSurface } from './report.ts';
import { result } from './say.ts';

/** Whether strokes make a surface at all shows in the coarsest; of bodies it does not, and finer ones take their time. */
const COARSE = { u: 4, v: 4 };

export async function info(args: Args): Promise<void> {
  const { drawing } = await readInput(inputOf(INFO, args));
  const { document } = drawing;
  const surfaces = document.parts.filter((part) => isSurface(part) && !part.hidden);
  const without = surfaces.filter((part) => !hasSurface(solidOf(part, COARSE)));
  result({
    ...countsOf(document),
    warnings: [...leftOut(document), ...withoutEnd(document), ...withoutSurface(without)],
  });
}
