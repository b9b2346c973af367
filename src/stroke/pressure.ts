/** The pen's pressure along a stroke: smooth, and with few values, because it only modulates widths and weights. */
import { inkAt, type Path, pathOf } from './path.ts';
import { resample } from './resample.ts';

/** values along the stroke: changes shorter than 1/32 of it are tremble */
const VALUES = 64;

/** Even values along the path, from arc length `start` (mm) on closed paths; open ones include both ends. */
export function pressureProfile(path: Path, start: number): number[] {
  const even = resample(startingAt(path, start), VALUES).map((p) => p.pressure);
  return even.map((value, i) => {
    const before = path.closed ? even[(i + VALUES - 1) % VALUES]! : (even[i - 1] ?? value);
    const after = path.closed ? even[(i + 1) % VALUES]! : (even[i + 1] ?? value);
    return Math.min(Math.max(0.25 * before + 0.5 * value + 0.25 * after, 0), 1);
  });
}

function startingAt(path: Path, start: number): Path {
  if (!path.closed || start === 0) return path;
  const i = path.lengths.findIndex((s) => s > start);
  const n = path.points.length;
  const first = i < 0 ? n : i;
  const rest = Array.from({ length: n }, (_, k) => path.points[(first + k) % n]!);
  return pathOf([inkAt(path, start), ...rest], true);
}
