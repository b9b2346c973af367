/** Words of radii that are drawn. */

export const SIZE_WORDS = {
  draw: 'Draw it',
  hint: 'Draw a line of that length, or a circle of that radius',
  brush: (mm: number) => `${mm} mm: draw the radius`,
} as const;
