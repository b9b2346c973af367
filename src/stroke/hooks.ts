/**
 * Takes off the little flicks a pen leaves where it lands and lifts.
 *
 * Theory: dehooking, which the thesis (chapter 4) names as the classical first step and leaves out. A hook is the stretch
 * before a sharp turn close to an end: shorter than 5 % of the stroke and than three grains, turning by more than 60°,
 * most of it on the spot, so that the tight start of a spiral is no hook.
 */
import { type Ink, inkAt, type Path, pathOf, reversed, toVec } from './path.ts';
import { isSharp, turnAtPoint } from './turn.ts';

const LARGEST_SHARE = 0.05;
/** hooks are at most this many grains long */
const LARGEST_GRAINS = 3;
/** radians, 60° */
const SHARP = 1.05;
/** the direction behind the hook is taken over this many grains, so that the tremble of a pixel does not decide */
const ARM_GRAINS = 1.5;

/** The points without a hook at either end; `grain` in mm. */
export function removeHooks(points: readonly Ink[], grain: number): readonly Ink[] {
  const front = withoutFirstHook(pathOf(points, false), grain);
  return reversed(withoutFirstHook(reversed(front), grain)).points;
}

function withoutFirstHook(path: Path, grain: number): Path {
  const reach = Math.min(LARGEST_GRAINS * grain, LARGEST_SHARE * path.length);
  let sharpest = 0;
  let cut = 0;
  for (let i = 1; i < path.points.length - 1 && path.lengths[i]! <= reach; i++) {
    const turn = turnBehind(path, path.lengths[i]!, Math.min(ARM_GRAINS * grain, reach));
    if (isSharp(turn, SHARP) && Math.abs(turn.turn) > sharpest) {
      sharpest = Math.abs(turn.turn);
      cut = i;
    }
  }
  return cut === 0 ? path : pathOf(path.points.slice(cut), false);
}

/** The turn at arc length s from the whole stretch before it to an arm after it. */
function turnBehind(path: Path, s: number, arm: number) {
  const at = (x: number) => toVec(inkAt(path, x));
  const after = Math.max(arm, s);
  return turnAtPoint([at(0), at(s / 2), at(s), at(s + after / 2), at(s + after)]);
}
