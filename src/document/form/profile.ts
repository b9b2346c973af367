/** What radii are multiplied by along lines, curves and rings. */
import type { GroupShape } from '../solid.ts';

/** The factor at u, 0–1: straight between even steps. */
export function profileAt({ profile }: Pick<GroupShape, 'profile'>, u: number): number {
  const last = profile.length - 1;
  const x = Math.min(Math.max(u, 0), 1) * last;
  const i = Math.min(Math.floor(x), Math.max(last - 1, 0));
  const [a = 1, b = a] = [profile[i], profile[i + 1]];
  return a + (b - a) * (x - i);
}
