/** Loops as somebody might draw them for a cross section, fitted once. */
import { fitPolarProfile } from '../../field/polarFit.ts';
import type { PolarProfile } from '../../field/polarProfile.ts';
import { cos, sin, TAU } from '../../math/trig.ts';
import type { Vec2 } from '../../math/vec.ts';

const around = (count: number, at: (angle: number, i: number) => Vec2): Vec2[] =>
  Array.from({ length: count }, (_, i) => at((i * TAU) / count, i));

const LOOPS: Readonly<Record<string, () => readonly Vec2[]>> = {
  ellipse: () => around(120, (angle) => [1.6 * cos(angle), 0.8 * sin(angle)]),
  square: () => [
    [-1, -1],
    [1, -1],
    [1, 1],
    [-1, 1],
  ],
  star: () =>
    around(10, (angle, i) => {
      const radius = i % 2 === 0 ? 1 : 0.55;
      return [radius * sin(angle), radius * cos(angle)];
    }),
};

const fitted = new Map<string, PolarProfile>();

/** By the ids of the choice `profile`. */
export function profileNamed(name: string): PolarProfile {
  const known = fitted.get(name) ?? fitPolarProfile(LOOPS[name]!()).profile;
  fitted.set(name, known);
  return known;
}
