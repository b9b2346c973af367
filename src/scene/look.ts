/** The colours of papers and inks: display values (sRGB as written), never linear. What may be chosen is in the document's `look`. */
import type { Background } from '../document/look.ts';
import type { Vec3 } from '../math/vec.ts';

export { type Background, DEFAULT_LOOK, type KernelChoice, type Look, type Style } from '../document/look.ts';

export const PAPER_COLOUR: Readonly<Record<Background, string>> = {
  paper: '#f6f1e6',
  white: '#ffffff',
  // the dark blue of the thesis' own program
  blue: '#191e2b',
  black: '#000000',
};

const INK = '#2a2520';
const CHALK = '#f2ecdf';
const PENCIL = { onLight: '#2b59c3', onDark: '#93b4ff' } as const;

export function isDark(background: Background): boolean {
  return background === 'blue' || background === 'black';
}

/** Lines are ink on light paper and chalk on dark. */
export function lineColour(background: Background): string {
  return isDark(background) ? CHALK : INK;
}

/** What the program draws on the paper is blue pencil, whatever the theme of the controls. */
export function pencilColour(background: Background): string {
  return isDark(background) ? PENCIL.onDark : PENCIL.onLight;
}

/** #rrggbb → red, green, blue, 0–1, still display values. */
export function displayRgb(hex: string): Vec3 {
  const value = Number.parseInt(hex.slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}
