/**
 * A part's finish as the styles read it: two vectors of the object that is drawn, or of the image's table. What is worked out once a part
 * is worked out here, without three.js, so that the palette of finishes uses the same numbers. The default finish gives the styles' own
 * exactly.
 */
import { DEFAULT_FINISH, type Finish } from '../document/finish.ts';

/** Shade turns cool, not black: blue keeps more ambient and gains less. */
export const AMBIENT_LIGHT = [0.43, 0.43, 0.5] as const;
export const LAMP_LIGHT = [0.83, 0.82, 0.74] as const;

/** how far toon's highlight goes from the lit colour to white: a tint, not a hole in the picture */
const HIGHLIGHT_WHITE = 0.75;
/** white added at the middle of smooth highlights: they stay tinted, as wax or fruit do */
const HIGHLIGHT_GLEAM = 0.25;
/** toon's highlight is on where (N·H)^shininess exceeds this */
const HIGHLIGHT_THRESHOLD = 0.8;

/** Numbers of a finish for the device, four and four. */
export interface FinishVectors {
  /** ambient, diffuse, toon's white, smooth gleam */
  readonly light: readonly [number, number, number, number];
  /** exponent, cosine where toon's highlight begins, chalk beyond that of the default, nothing */
  readonly peak: readonly [number, number, number, number];
}

export function finishVectors({ ambient, diffuse, specular, shininess }: Finish): FinishVectors {
  const strength = specular / DEFAULT_FINISH.specular;
  // nears white and never leaves it
  const white = strength === 1 ? HIGHLIGHT_WHITE : 1 - (1 - HIGHLIGHT_WHITE) ** strength;
  const more = Math.max(0, specular - DEFAULT_FINISH.specular) / (1 - DEFAULT_FINISH.specular);
  return {
    light: [ambient, diffuse, white, HIGHLIGHT_GLEAM * strength],
    peak: [shininess, HIGHLIGHT_THRESHOLD ** (1 / shininess), more, 0],
  };
}
