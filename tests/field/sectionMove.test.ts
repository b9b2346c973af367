/** How far cross sections move a point at most: the bounds behind the spread of a warped skel. */
import { expect, test } from 'vitest';
import { extrusion } from '../../src/field/extrusion.ts';
import { polarProfile } from '../../src/field/polarProfile.ts';
import { ROUND, type Section } from '../../src/field/section.ts';
import { superQuadric } from '../../src/field/superQuadric.ts';
import { cos, sin, TAU } from '../../src/math/trig.ts';
import { Lot } from './lot.ts';

const SEED = 54;
const CASES = 300;
const move = new Float64Array(2);
const stretch = new Float64Array(3);

const flower = Array.from({ length: 24 }, (_, i) => 1 + 0.3 * sin((i * TAU) / 6));
const crooked = Array.from({ length: 24 }, (_, i) => [0.4, 1, 2, 0.7, 1.2][i % 5]!);
const SECTIONS: readonly (readonly [string, Section])[] = [
  ['round', ROUND],
  ...[0.3, 0.7, 1, 1.5, 2, 2.5, 8, 100].map(
    (exponent) => [`super-quadric ${exponent}`, superQuadric({ type: 'superQuadric', exponent })] as const,
  ),
  ...[2, 3, 20].map(
    (exponent) => [`extrusion ${exponent}`, extrusion({ type: 'extrusion', exponent })] as const,
  ),
  ['flower', polarProfile({ type: 'polar', radii: flower })],
  ['crooked', polarProfile({ type: 'polar', radii: crooked })],
];

test.each(SECTIONS)(
  `%s: no point of an ellipse goes farther than said (${CASES} ellipses, seed ${SEED})`,
  (_, section) => {
    const lot = new Lot(SEED);
    const mapped = (x: number, y: number) => {
      const m = section.value(x, y);
      return [m * x, m * y] as const;
    };
    let closest = 0;
    let farthest = -Infinity;
    for (let i = 0; i < CASES; i++) {
      const size = lot.one([1e-3, 0.05, 0.5, 3]);
      const [x, y] = [lot.one([0, lot.between(-2, 2)]), lot.one([1e-4, lot.between(-2, 2)])];
      const [rx, ry] = [size * lot.between(0.3, 1), size * lot.between(0.3, 1)];
      section.evaluate(x, y, stretch);
      const [m, mx, my] = [stretch[0]!, stretch[1]!, stretch[2]!];
      section.move(x, y, m, rx, ry, move);
      const [most, bend] = [move[0]!, move[1]!];
      const [cx, cy] = mapped(x, y);
      for (let j = 0; j < 24; j++) {
        const angle = (j * TAU) / 24;
        const [dx, dy] = [rx * cos(angle), ry * sin(angle)];
        const [px, py] = mapped(x + dx, y + dy);
        const away = Math.hypot(px - cx, py - cy);
        closest = Math.max(closest, away / most);
        farthest = Math.max(farthest, away - most * (1 + 1e-15));
        if (bend === Infinity) continue;
        const radial = mx * dx + my * dy;
        const off = Math.hypot(px - cx - m * dx - radial * x, py - cy - m * dy - radial * y);
        farthest = Math.max(farthest, off - bend);
      }
    }
    expect(farthest).toBeLessThan(1e-13);
    expect(closest).toBeGreaterThan(0.7);
  },
);
