/** Two balls that go through each other, for the page and for the test. */

import type { Look } from '../../src/document/look.ts';
import type { Vec3 } from '../../src/math/vec.ts';

export interface Ball {
  readonly centre: Vec3;
  readonly radius: number;
  readonly colour: string;
}

export interface ExactPicture {
  readonly look: Partial<Look>;
  /** degrees; 0 is orthographic */
  readonly fov?: number;
  /** of the image, pixels; without them as many as the picture has */
  readonly cast?: readonly [width: number, height: number];
  /** where the image lies */
  readonly from?: 'arrays' | 'buffers';
  /** rows of the image that are there, from … to …, 0–1 from the top: only the first is drawn then */
  readonly known?: readonly [number, number];
  readonly selected?: readonly ('triangles' | 'rays')[];
  /** mm that the eye is moved towards the balls */
  readonly height?: number;
}

export const SIZE = [300, 240] as const;
/** Of triangles, and of rays. */
export const BALLS: readonly [Ball, Ball] = [
  { centre: [-20, 0, 0], radius: 55, colour: '#d9cb4a' },
  { centre: [35, 10, 12], radius: 40, colour: '#4a78d9' },
];
