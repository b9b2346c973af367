/** Paint for the presets: display colours as fields want them. */
import type { Colour } from '../../field/node.ts';

/** #rrggbb → linear light. */
function paint(hex: string): Colour {
  const channel = (shift: number) => {
    const x = ((Number.parseInt(hex.slice(1), 16) >> shift) & 255) / 255;
    return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  };
  return [channel(16), channel(8), channel(0)];
}

export const PAINT = {
  fox: paint('#dd7f36'),
  cream: paint('#f6ead2'),
  bark: paint('#5f4234'),
  coal: paint('#2e2a2c'),
  pear: paint('#d9cb4a'),
  red: paint('#cf4a36'),
  blue: paint('#4a7ab8'),
  teal: paint('#3f9690'),
  leaf: paint('#74ab4f'),
  rose: paint('#e08c98'),
  violet: paint('#8a64ac'),
  wood: paint('#b98a5a'),
} as const;
