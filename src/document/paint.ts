/**
 * Colours of documents are display values (sRGB as written), those of fields light, which is linear.
 * The transfer function of sRGB (IEC 61966-2-1) has the power 2.4 = 2 · (1 + 1/5); the fifth root is Newton's, because
 * engines differ in the last bit of theirs.
 */

export type Rgb = readonly [red: number, green: number, blue: number];

/** #rrggbb → 0–255 each. */
export function displayBytes(hex: string): Rgb {
  const value = Number.parseInt(hex.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

/** #rrggbb → 0–1 each, linear. */
export function linearRgb(hex: string): Rgb {
  const [red, green, blue] = displayBytes(hex);
  return [linear(red / 255), linear(green / 255), linear(blue / 255)];
}

function linear(display: number): number {
  if (display <= 0.04045) return display / 12.92;
  const base = (display + 0.055) / 1.055;
  return base * base * fifthRoot(base * base);
}

/** Of 0 < a ≤ 1: from 1 Newton's steps fall towards the root; the last bits are reached when they no longer do. */
function fifthRoot(a: number): number {
  let root = 1;
  for (;;) {
    const square = root * root;
    const next = (4 * root + a / (square * square)) / 5;
    if (next >= root) return root;
    root = next;
  }
}
