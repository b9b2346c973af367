import { bench, describe } from 'vitest';
import { topology } from '../../src/mesh/check.ts';
import { polylineCurve } from '../../src/stroke/arcLength.ts';
import { rotational } from '../../src/surface/rotational.ts';
import { tube } from '../../src/surface/tube.ts';
import { circle, FLAT, halfCircle, line } from '../surface/curves.ts';

/** A pear's side as a polyline of 200 points: what a filtered stroke costs to look at, about. */
const side = (sign: 1 | -1) =>
  polylineCurve(
    Array.from({ length: 200 }, (_, i) => {
      const t = (Math.PI * i) / 199;
      return [sign * (30 - 10 * Math.cos(t)) * Math.sin(t), 60 * Math.cos(t)] as const;
    }),
    false,
  );

describe('surfaces at 64 × 64', () => {
  const [left, right] = [side(-1), side(1)];
  const cap = { u: 64, v: 64, caps: true } as const;
  const pipe = { u: 64, v: 64, caps: 'round', radius: 6, pressure: true } as const;

  bench('tube', () => void tube(left, FLAT, pipe));
  bench('tube with a corner', () => void tube(line([0, 0], [50, 0], [50, 50]), FLAT, pipe));
  bench('rotational', () => void rotational(left, right, FLAT, cap));
  bench('rotational, closed pair', () => void rotational(closed[0], closed[1], FLAT, cap));
  bench('topology of one', () => void topology(solid));

  const closed = [circle(-30, 0, 10), circle(30, 0, 10)] as const;
  const solid = rotational(halfCircle(50, -1), halfCircle(50, 1), FLAT, cap);
});
