import { expect, test } from 'vitest';
import type { Vec3 } from '../../src/math/vec.ts';
import { type Move, normalMove } from '../../src/surface/bendMap.ts';
import { sideView } from '../../src/surface/sideView.ts';

test('what the normals of a row share is asked for once, however many there are', () => {
  let asked = 0;
  const matrix = (): [[number, number], [number, number]] => {
    asked++;
    return [
      [0.6, -0.8],
      [0.8, 0.6],
    ];
  };
  const move: Move = {
    turn: matrix,
    dTurn: () => [
      [0, 0],
      [0, 0],
    ],
    from: () => [0, 0],
    to: () => [0, 0],
    dFrom: () => [0, 1],
    dTo: () => [-0.8, 0.6],
  };
  const station = { centre: [0, 0, 0], rate: [0, 1, 0], normal: [0, 1, 0], spin: [0, 0, 0] } as const;
  const view = sideView({ origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] });
  const moved = normalMove(move, view, station);
  const before = asked;
  for (let i = 0; i < 100; i++) {
    const n: Vec3 = [Math.cos(i), 0, Math.sin(i)];
    const [x, y, z] = moved([Math.cos(i), 0, Math.sin(i)], n);
    // a turn, which carries normals along
    expect([x - 0.6 * n[0], y - 0.8 * n[0], z - n[2]].every((d) => Math.abs(d) < 1e-12)).toBe(true);
  }
  expect(asked).toBe(before);
});
