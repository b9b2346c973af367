/** Strokes for tests of document and tools. */
import type { Plane, Sample, Stroke, View } from '../../src/stroke/stroke.ts';

export const PLANE: Plane = { origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] };
export const VIEW: View = { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 200, fov: 0 };

/** A stroke along a path given in mm on the front plane. */
export function strokeAlong(
  path: (t: number) => readonly [number, number],
  options: Partial<Stroke> = {},
  count = 60,
): Stroke {
  const samples: Sample[] = [];
  for (let i = 0; i < count; i++) {
    const [x, y] = path(i / (count - 1));
    samples.push({ x, y, pressure: 0.5, tiltX: 0, tiltY: 0, time: 8 * i });
  }
  return { samples, plane: PLANE, view: VIEW, pointer: 'pen', closed: false, ...options };
}

export const line = (x: number, length = 60): Stroke => strokeAlong((t) => [x, length / 2 - length * t]);

export const circle = (radius: number, x = 0): Stroke =>
  strokeAlong((t) => [x + radius * Math.cos(2 * Math.PI * t), radius * Math.sin(2 * Math.PI * t)], {
    closed: true,
  });

/** Half a circle from pole to pole; `side` −1 is the left one. */
export const halfCircle = (radius: number, side: 1 | -1): Stroke =>
  strokeAlong((t) => [side * radius * Math.sin(Math.PI * t), radius * Math.cos(Math.PI * t)]);
