/** The stroke meter. */
import type { SurfaceKind } from '../../surface/index.ts';

export const METER_WORDS = {
  label: 'The number of strokes decides the surface',
  everyStroke: 'every stroke',
  steps: {
    tube: { number: '1', name: 'Tube' },
    rotational: { number: '2', name: 'Rotational' },
    crossSection: { number: '3', name: 'Section' },
    bspline: { number: '4+', name: 'Patch' },
  },
  hint: (step: SurfaceKind, state: 'pinned' | 'done' | 'current' | 'next') => {
    if (state === 'pinned') return 'Every stroke a tube. Tap to let the number decide again';
    if (state === 'done')
      return step === 'tube'
        ? 'Back to tubes; no stroke is lost. Hold: every stroke a tube'
        : 'Back to this; no stroke is lost';
    return {
      tube: 'A tube along the stroke. Hold: every stroke a tube',
      rotational: state === 'next' ? 'Draw the other side to make it round' : 'Round between the two strokes',
      crossSection:
        state === 'next'
          ? 'Draw across, from one side to the other (L)'
          : 'The section that was drawn, all along',
      bspline: state === 'next' ? 'Draw a second section (L)' : 'From section to section',
    }[step];
  },
} as const;
