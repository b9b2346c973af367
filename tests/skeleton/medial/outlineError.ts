/** How far the surface of skels is from an outline, in their plane. */
import type { Kernel, KernelParams } from '../../../src/kernel/kernel.ts';
import type { Vec2 } from '../../../src/math/vec.ts';
import { bindSkel } from '../../../src/skeleton/index.ts';
import { along, type Loop } from '../../../src/skeleton/medial/outline.ts';
import type { Skel } from '../../../src/skeleton/skels.ts';

/** share of the size beyond which nothing is searched */
const REACH = 0.15;
const STEPS = 60;
/** half a turn: roots are looked for both ways */
const AROUND = Array.from(
  { length: 8 },
  (_, i): Vec2 => [Math.cos((i * Math.PI) / 8), Math.sin((i * Math.PI) / 8)],
);

/**
 * Along the normals of the outline, in shares of its longer side, or where a normal meets nothing, as at the bottom of a notch, the least of
 * sixteen directions; what is not found counts as the reach.
 */
export function outlineError(
  skels: readonly Skel[],
  loops: readonly Loop[],
  kernel: Kernel,
  params: KernelParams,
  threshold: number,
): { readonly mean: number; readonly most: number } {
  const fields = skels.map((skel) => bindSkel(skel, kernel, params));
  const above = (x: number, y: number) =>
    fields.reduce((sum, field) => sum + field.value(x, y, 0), -threshold);
  const flat = loops.flat();
  const span = (axis: 0 | 1) => Math.max(...flat.map((p) => p[axis])) - Math.min(...flat.map((p) => p[axis]));
  const size = Math.max(span(0), span(1));
  const errors = loops.flatMap((loop) => {
    const places = along([loop], size / 120);
    return places.map((p, i) => {
      const [a, b] = [places.at(i - 1)!, places[(i + 1) % places.length]!];
      const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
      const normal: Vec2 = [(b[1] - a[1]) / length, (a[0] - b[0]) / length];
      const found = nearestRoot(above, p, normal, REACH * size);
      if (found < REACH * size) return found / size;
      return Math.min(...AROUND.map((way) => nearestRoot(above, p, way, REACH * size))) / size;
    });
  });
  return { mean: errors.reduce((a, b) => a + b, 0) / errors.length, most: Math.max(...errors) };
}

function nearestRoot(
  above: (x: number, y: number) => number,
  [x, y]: Vec2,
  [nx, ny]: Vec2,
  reach: number,
): number {
  const here = above(x, y);
  let least = reach;
  for (const side of [1, -1]) {
    let before = here;
    for (let i = 1; i <= STEPS; i++) {
      const s = (reach * i) / STEPS;
      const value = above(x + side * s * nx, y + side * s * ny);
      if (value * before <= 0 && before !== value) {
        least = Math.min(least, s - (reach / STEPS) * (value / (value - before)));
        break;
      }
      before = value;
    }
  }
  return least;
}
