/** The thesis' pear: two strokes for the body, two for the stem, as a hand would draw them in an 800 × 600 picture. */
import { alongPath, type Point } from './pen.ts';

const SCALE = 2.1;
const place = ([x, y]: Point): Point => [400 + (x - 80) * SCALE, 82 + y * SCALE];

/** Nothing that a hand draws is quite the mirror image of what it drew before. */
export const BODY: readonly (readonly Point[])[] = [
  alongPath('M80 22C66 22 60 34 58 50C55 76 46 88 36 106C22 132 22 168 44 180C56 186 68 187 80 187', place),
  alongPath(
    'M80 22C94 22 100 34 102 50C105 76 114 88 124 106C138 132 138 168 116 180C104 186 92 187 80 187',
    place,
  ),
];

export const STEM: readonly (readonly Point[])[] = [
  alongPath('M76 27C75 17 79 8 88 1', place, 24),
  alongPath('M86 27C86 18 90 11 97 6', place, 24),
];
