/** What styles are called. */

export const STYLE_NAMES = {
  toon: 'Toon',
  'hbed-lines': 'Lines',
  'hbed-ink': 'Ink',
  gouraud: 'Shaded',
} as const;

export type ShownStyle = keyof typeof STYLE_NAMES;
