import { describe, expect, test } from 'vitest';
import { between, inkAt, pathOf, reversed } from '../../src/stroke/path.ts';

const ink = (x: number, y: number, pressure = 0.5) => ({ x, y, pressure });
const square = [ink(0, 0, 0), ink(10, 0, 1), ink(10, 10, 0), ink(0, 10, 1)];

describe('path', () => {
  test('lengths of open and closed paths', () => {
    expect(pathOf(square, false).length).toBe(30);
    expect(pathOf(square, true).length).toBe(40);
    expect([...pathOf(square, true).lengths]).toEqual([0, 10, 20, 30, 40]);
    expect(pathOf([ink(1, 2)], false).length).toBe(0);
    expect(pathOf([], false).length).toBe(0);
  });

  test('points by arc length: clamped when open, wrapped when closed', () => {
    expect(inkAt(pathOf(square, false), 15)).toEqual(ink(10, 5));
    expect(inkAt(pathOf(square, false), 99)).toEqual(square[3]);
    expect(inkAt(pathOf(square, false), -1)).toEqual(square[0]);
    expect(inkAt(pathOf(square, true), 35)).toEqual(ink(0, 5));
    expect(inkAt(pathOf(square, true), -5)).toEqual(ink(0, 5));
    expect(inkAt(pathOf(square, true), 45)).toEqual(ink(5, 0));
  });

  test('stretches include their ends and the vertices between, also across the start', () => {
    expect(between(pathOf(square, false), 5, 15)).toEqual([ink(5, 0), square[1], ink(10, 5)]);
    const across = between(pathOf(square, true), 30, 50);
    expect(across).toEqual([square[3], square[0], square[1]]);
    const around = pathOf(between(pathOf(square, true), 10, 50), false);
    expect(around.length).toBe(40);
    expect(around.points).toHaveLength(5);
  });

  test('drawn from the other end it is as long', () => {
    const path = pathOf(square, false);
    expect(reversed(path).length).toBe(path.length);
    expect(reversed(path).points[0]).toEqual(square[3]);
  });
});
