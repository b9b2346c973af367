/** Rows are moved as their sections are, and what their points share is asked for once. */
import { expect, test } from 'vitest';
import { length3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import type { Move } from '../../src/surface/bendMap.ts';
import { bentRow } from '../../src/surface/bentRow.ts';
import type { SheetRow } from '../../src/surface/sheet.ts';
import { sideView } from '../../src/surface/sideView.ts';
import { normalIn, pointIn } from './sheets.ts';

const view = sideView({ origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] });
const section = { centre: [0, 0, 0], rate: [0, 1, 0], normal: [0, 1, 0], spin: [0, 0, 0] } as const;

/** A turn by the angle whose sine is 0.8, and (5, 7); counted. */
function turning() {
  const asked = { times: 0 };
  const counted =
    <T>(value: T) =>
    (): T => {
      asked.times++;
      return value;
    };
  const move: Move = {
    turn: counted([
      [0.6, -0.8],
      [0.8, 0.6],
    ]),
    dTurn: counted([
      [0, 0],
      [0, 0],
    ]),
    from: counted([0, 0]),
    to: counted([5, 7]),
    dFrom: counted([0, 1]),
    dTo: counted([-0.8, 0.6]),
  };
  return { move, asked };
}

function circle(count: number): SheetRow {
  const angles = Array.from({ length: count }, (_, i) => (2 * Math.PI * i) / count);
  const normals = Float64Array.from(angles.flatMap((a) => [Math.cos(a), 0, Math.sin(a)]));
  return { points: normals.map((x) => 3 * x), normals, joined: true, at: { u: 0.5, side: 1 } };
}

test('a turn carries points and normals along, with its section or stiffly', () => {
  const row = circle(24);
  const turned = ([x, y, z]: Vec3): Vec3 => [0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y, z];
  for (const station of [section, null]) {
    const bent = bentRow(row, turning().move, view, station);
    for (let j = 0; j < 24; j++) {
      const [x, y, z] = turned(pointIn(row, j));
      expect(length3(sub3(pointIn(bent, j), [x + 5, y + 7, z]))).toBeLessThan(1e-12);
      expect(length3(sub3(normalIn(bent, j), turned(normalIn(row, j))))).toBeLessThan(1e-12);
    }
  }
});

test('a pole stays one point to the last bit', () => {
  const row = circle(5);
  for (let k = 3; k < 15; k++) row.points[k] = row.points[k - 3]!;
  const { points } = bentRow({ ...row, pole: true }, turning().move, view, section);
  for (let k = 3; k < 15; k++) expect(points[k]).toBe(points[k - 3]);
});

test('a row of many points asks as often as one of few', () => {
  const [few, many] = [turning(), turning()];
  bentRow(circle(3), few.move, view, section);
  bentRow(circle(300), many.move, view, section);
  expect(many.asked.times).toBe(few.asked.times);
});
