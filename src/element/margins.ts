/** How much of the picture the controls cover: what is fitted lies between them. */
import { AIR, type Margins } from '../scene/view.ts';
import type { Size } from './place.ts';

/** px, with a little air: the top row; the tools beside the picture, or below it where that is narrow */
const COVER = { top: 84, left: 92, bottom: 92 } as const;
/** px of width below which the tools lie below */
const NARROW = 700;
/** The least of a small picture that is left to the form. */
const LEAST = 0.4;

export function marginsOf({ width, height }: Size, bare: boolean, readOnly: boolean): Margins {
  if (bare) return AIR;
  const narrow = width < NARROW;
  const tools = !readOnly;
  const share = (pixels: number, of: number, air: number) => Math.max(air, pixels / Math.max(1, of));
  const top = share(COVER.top, height, AIR.top);
  const bottom = share(tools && narrow ? COVER.bottom : 0, height, AIR.bottom);
  const left = share(tools && !narrow ? COVER.left : 0, width, AIR.left);
  // In a picture too small for both the form matters more than what lies over it.
  const shrink = Math.min(1, (1 - LEAST) / (top + bottom));
  return { left, top: top * shrink, right: AIR.right, bottom: bottom * shrink };
}

/** px: what else lies over a narrow picture while there is a form or a part in hand: the meter, and the card of it */
const IN_HAND = { top: 128, bottom: 256 } as const;

/** With a card of a tool, or of the unfinished form. */
export function marginsInHand(margins: Margins, { width, height }: Size): Margins {
  if (width >= NARROW || height < IN_HAND.top + IN_HAND.bottom) return margins;
  const [top, bottom] = [IN_HAND.top / height, IN_HAND.bottom / height];
  return { ...margins, top: Math.max(margins.top, top), bottom: Math.max(margins.bottom, bottom) };
}
