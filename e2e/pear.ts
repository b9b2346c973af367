/** The thesis' pear: two strokes for the body, two for the stem, as a hand would draw them in an 800 × 600 picture. */
import { type Point, splineThrough, trembling } from './pen.ts';

/** In a square of 160 × 200, to be placed in the picture. */
const SCALE = 2.1;
const place = ([x, y]: Point): Point => [400 + (x - 80) * SCALE, 82 + y * SCALE];

/** Control polygon: down the left side from the top, up the right one. Nothing that a hand draws is quite its mirror image. */
const OUTLINE: readonly Point[] = [
  [80, 20],
  [62, 24],
  [57, 58],
  [48, 88],
  [24, 118],
  [20, 158],
  [44, 188],
  [80, 189],
  [116, 188],
  [141, 158],
  [136, 119],
  [112, 89],
  [103, 58],
  [98, 24],
];
const BOTTOM = 7;

const STEM_LEFT: readonly Point[] = [
  [76, 29],
  [76, 27],
  [75, 17],
  [81, 8],
  [88, 1],
  [90, -1],
];
const STEM_RIGHT: readonly Point[] = [
  [86, 29],
  [86, 27],
  [86, 19],
  [90, 12],
  [97, 6],
  [99, 4],
];

const stroke = (seed: number, polygon: readonly Point[], from: number, to: number, count: number): Point[] =>
  trembling(splineThrough(polygon.map(place), from, to, count), seed);

export const BODY: readonly (readonly Point[])[] = [
  stroke(1, OUTLINE, 0, BOTTOM, 70),
  stroke(2, OUTLINE, OUTLINE.length, BOTTOM, 70),
];

export const STEM: readonly (readonly Point[])[] = [
  stroke(3, STEM_LEFT, 1, 4, 26),
  stroke(4, STEM_RIGHT, 1, 4, 26),
];
