/** What keys mean to every picture that is turned, in the application and on the field page. */

/** Letters without their case: Caps Lock changes nothing. */
export function keyOf({ key }: KeyboardEvent): string {
  return key.length === 1 ? key.toLowerCase() : key;
}

/** px of a drag that an arrow key stands for: an eighth of a turn of a 600 px picture in five steps */
const ARROW = 24;

const ARROWS: Readonly<Record<string, readonly [dx: number, dy: number]>> = {
  ArrowLeft: [-ARROW, 0],
  ArrowRight: [ARROW, 0],
  ArrowUp: [0, -ARROW],
  ArrowDown: [0, ARROW],
};

/** The drag that a key stands for, px; null for other keys. */
export function dragOf(key: string): readonly [dx: number, dy: number] | null {
  return ARROWS[key] ?? null;
}
