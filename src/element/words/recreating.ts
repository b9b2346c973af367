/** A part whose strokes are in hand again. */

export const RECREATE_WORDS = {
  inHand: 'its strokes in hand',
  said: (name: string) => `${name}, its strokes in hand`,
  kept: (name: string) => `${name}, as it is drawn now`,
  dropped: (name: string) => `${name} is as it was`,
} as const;
