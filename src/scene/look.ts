/** How the page may look: styles, papers and inks. Colours are display values (sRGB as written), never linear. */
import type { Vec3 } from '../math/vec.ts';

export type Style = 'toon' | 'gouraud' | 'phong' | 'hbed-lines' | 'hbed-ink';
export type Background = 'paper' | 'white' | 'blue' | 'black';
/** The thesis' difference kernels (figure 7.10); auto = the style's own. */
export type KernelChoice = 'A' | 'B' | 'C' | 'D' | 'auto';

export interface Look {
  readonly style: Style;
  readonly background: Background;
  /** the contour of toon, gouraud and phong */
  readonly outline: boolean;
  /** the paper's grain; only the background `paper` has one */
  readonly grain: boolean;
  readonly wireframe: boolean;
  readonly grid: boolean;
  readonly kernel: KernelChoice;
  /** threshold of the normal response, 0–1 */
  readonly creases: number;
  /** threshold of the depth response, in parts of the scene's bounding sphere */
  readonly overlaps: number;
}

export const DEFAULT_LOOK: Look = {
  style: 'toon',
  background: 'paper',
  outline: true,
  grain: true,
  wireframe: false,
  grid: false,
  kernel: 'auto',
  // the thesis' values, section 7.2.2
  creases: 0.15,
  overlaps: 0.05,
};

export const PAPER_COLOUR: Readonly<Record<Background, string>> = {
  paper: '#f6f1e6',
  white: '#ffffff',
  // the dark blue of the thesis' own program
  blue: '#191e2b',
  black: '#000000',
};

const INK = '#2a2520';
const CHALK = '#f2ecdf';

export function isDark(background: Background): boolean {
  return background === 'blue' || background === 'black';
}

/** Lines are ink on light paper and chalk on dark. */
export function lineColour(background: Background): string {
  return isDark(background) ? CHALK : INK;
}

/** #rrggbb → red, green, blue, 0–1, still display values. */
export function displayRgb(hex: string): Vec3 {
  const value = Number.parseInt(hex.slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}
