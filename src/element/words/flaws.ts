/** What the picture does not show of a body, and what helps. */
import { PAGE } from '../../field/polygonize.ts';
import { placesOf } from './counts.ts';

export const FLAWS = {
  thin: (places: number) =>
    `Hardly thicker than a cell or two in ${placesOf(places)}: pieces may be missing. Thicker, or seen exactly, it is whole.`,
  gaps: (gaps: number) =>
    `Nearer to itself than a cell in ${placesOf(gaps)}: gaps may have closed. Wider, or seen exactly, they are open.`,
  cut: `Without end: cut off about ${PAGE} mm from the origin. An intersection with a box ends it where you like.`,
} as const;
