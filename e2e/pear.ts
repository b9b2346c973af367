/** The thesis' pear: two strokes for the body, two for the stem, as a hand would draw them in an 800 × 600 picture. */
import { type Point, smoothThrough, trembling } from './pen.ts';

/** In a square of 160 × 200, to be placed in the picture. */
const SCALE = 2.1;
const place = ([x, y]: Point): Point => [400 + (x - 80) * SCALE, 82 + y * SCALE];

const stroke = (seed: number, points: readonly Point[], count: number): Point[] =>
  trembling(smoothThrough(points.map(place), count), seed);

/** Half widths of the pear at heights; nothing that a hand draws is quite the mirror image of what it drew before. */
const LEFT: readonly Point[] = [
  [80, 22],
  [68, 26],
  [60.5, 40],
  [56.5, 60],
  [47.5, 84],
  [34.5, 111],
  [26.5, 139],
  [31, 165],
  [50, 182],
  [80, 187],
];
const RIGHT: readonly Point[] = [
  [80, 22],
  [92, 26],
  [99.5, 40],
  [103.5, 60],
  [112.5, 85],
  [126, 112],
  [134, 140],
  [129, 166],
  [110, 182],
  [80, 187],
];

export const BODY: readonly (readonly Point[])[] = [stroke(1, LEFT, 70), stroke(2, RIGHT, 70)];

export const STEM: readonly (readonly Point[])[] = [
  stroke(
    3,
    [
      [76, 27],
      [76, 19],
      [80, 9],
      [88, 1],
    ],
    26,
  ),
  stroke(
    4,
    [
      [86, 27],
      [86.5, 20],
      [90, 12],
      [97, 6],
    ],
    26,
  ),
];
