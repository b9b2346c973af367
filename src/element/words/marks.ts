/** What the marks of tools say. */

export const MARK_WORDS = {
  label: { full: 'full', flat: 'flat', hollow: 'hollow', front: 'front', back: 'back' },
  value: (value: number, unit: '%' | '°' | 'mm') => {
    if (unit === 'mm') return `${Number(value.toFixed(1))} mm`;
    return unit === '°' ? `${Math.round(value)}°` : `${Math.round(value)} %`;
  },
} as const;
