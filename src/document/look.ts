/** How the page may look: styles, papers and what is shown on them. Data only; colours are in the scene. */

export const STYLES = ['toon', 'gouraud', 'phong', 'hbed-lines', 'hbed-ink'] as const;
export type Style = (typeof STYLES)[number];

export const BACKGROUNDS = ['paper', 'white', 'blue', 'black'] as const;
export type Background = (typeof BACKGROUNDS)[number];

/** pixels a side of a picture */
export const PICTURE_SIDE = { least: 16, most: 8192 } as const;

/** The thesis' difference kernels (figure 7.10); auto = the style's own. */
export const KERNEL_CHOICES = ['A', 'B', 'C', 'D', 'auto'] as const;
export type KernelChoice = (typeof KERNEL_CHOICES)[number];

/** What is seen of bodies: triangles, or what rays find of the surface itself. */
export const MODES = ['mesh', 'exact'] as const;
export type Mode = (typeof MODES)[number];

export interface Look {
  readonly style: Style;
  readonly mode: Mode;
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
  /** threshold of the depth response, in parts of the scene's bounding sphere, 0–1 */
  readonly overlaps: number;
}

export const DEFAULT_LOOK: Look = {
  style: 'toon',
  mode: 'mesh',
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
