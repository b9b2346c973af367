import { describe, expect, test } from 'vitest';
import type { Row } from '../../src/mesh/grid.ts';
import { facing } from '../../src/surface/facing.ts';

function ring(radius: number, z: number, sense: 1 | -1, x = 0): Row {
  const points = Array.from({ length: 9 }, (_, i) => {
    const angle = (sense * 2 * Math.PI * (i % 8)) / 8;
    return [x + radius * Math.cos(angle), radius * Math.sin(angle), z];
  }).flat();
  return { points: Float64Array.from(points), normals: new Float64Array(27), joined: true };
}

function strip(from: number, to: number, y: number): Row {
  return { points: Float64Array.from([from, y, 0, to, y, 0]), normals: new Float64Array(6), joined: true };
}

describe('which way rows face', () => {
  test('closed: by the volume, wherever they are', () => {
    for (const x of [0, 1e4]) {
      expect(facing([ring(1, 2, 1, x), ring(1, 0, 1, x)], true)).toBe(1);
      expect(facing([ring(1, 0, 1, x), ring(1, 2, 1, x)], true)).toBe(-1);
      expect(facing([ring(1, 0, -1, x), ring(0, 2, -1, x)], true)).toBe(1);
    }
  });

  test('open: 1 towards the person', () => {
    expect(facing([strip(0, 1, 1), strip(0, 1, 0)], false)).toBe(
      -facing([strip(0, 1, 0), strip(0, 1, 1)], false),
    );
    expect(facing([strip(0, 1, 1), strip(0, 1, 0)], false)).toBe(-1 * -1);
  });

  test('what encloses nothing has no side', () => {
    expect(facing([ring(1, 0, 1), ring(0.5, 0, 1)], true)).toBe(0);
    expect(facing([strip(0, 1, 0), strip(2, 5, 0)], false)).toBe(0);
    expect(facing([ring(0, 0, 1), ring(0, 0, 1)], true)).toBe(0);
    expect(facing([], true)).toBe(0);
  });
});
