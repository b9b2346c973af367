/**
 * An outline from places that a pen went through, as Tai et al. 2004, §5, sample theirs: edges of at most 0.05 W, and of at least 0.01 W where
 * they turn by more than 20°. W, their canvas, is the longer side of the outline here, so that a form is the same wherever and however
 * large it is drawn.
 *
 * What is changed: places that are no numbers or stay where the last one was are left out; ends that nearly meet are joined, and what a pen
 * drew too far is cut (stroke/closed.ts); bends between the places that are kept become chords. Our own skeleton takes 260 even places
 * instead (silhouette.ts), of which what is too much is pruned: circumcentres are on the medial axis to within the spacing of places.
 */
import { cross2, dot2, sub2 } from '../../math/tuple.ts';
import type { Vec2 } from '../../math/vec.ts';
import { CLOSED_TOLERANCE, joinEnds, meetingOf } from '../../stroke/closed.ts';
import { inkAt, type Path, pathOf, toVec } from '../../stroke/path.ts';
import { type Loop, sizeOf } from './outline.ts';

/** of W: the longest edge, and the shortest beside a bend */
const LONGEST = 0.05;
const SHORTEST = 0.01;
/** tangent of 20° */
const BEND = 0.36397023426620234;

/** null where the ends are too far apart for a closed line, or it has no more than two places. `size` is W, mm. */
export function outlineOf(points: readonly Vec2[], size?: number): Loop | null {
  const sound = points
    .filter(([x, y]) => Number.isFinite(x) && Number.isFinite(y))
    .filter((p, i, all) => i === 0 || p[0] !== all[i - 1]![0] || p[1] !== all[i - 1]![1]);
  if (sound.length < 3) return null;
  const path = pathOf(
    sound.map(([x, y]) => ({ x, y, pressure: 1 })),
    false,
  );
  if (!meetingOf(path, CLOSED_TOLERANCE)) return null;
  const loop = sampled(joinEnds(path), size ?? sizeOf([sound]));
  return loop.length > 2 ? loop : null;
}

/** Loops that are closed already, by the same rule; what has fewer than three places left is left out. */
export function sampledLoops(loops: readonly Loop[]): readonly Loop[] {
  const size = sizeOf(loops);
  if (!(size > 0)) return [];
  const paths = loops.map((loop) =>
    pathOf(
      loop.map(([x, y]) => ({ x, y, pressure: 1 })),
      true,
    ),
  );
  return paths.map((path) => sampled(path, size)).filter((loop) => loop.length > 2);
}

/** By steps of the shortest edge: one goes on as long as it is straight and not too long. */
function sampled(path: Path, size: number): Loop {
  const steps = Math.max(Math.floor(path.length / (SHORTEST * size)), 3);
  const most = Math.floor(LONGEST / SHORTEST);
  const fine = Array.from({ length: steps }, (_, i) => toVec(inkAt(path, (i * path.length) / steps)));
  const kept = [fine[0]!];
  for (let i = 1, from = 0; i < steps; i++) {
    const so = sub2(fine[i]!, fine[from]!);
    const next = sub2(fine[(i + 1) % steps]!, fine[i]!);
    const turns = !(Math.abs(cross2(so, next)) <= BEND * dot2(so, next));
    if (!turns && i - from < most) continue;
    kept.push(fine[i]!);
    from = i;
  }
  return kept;
}
