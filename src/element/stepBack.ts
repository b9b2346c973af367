/** While the pen is down, cards near it fade and let it through; null: all are back. */
export function stepBack(root: ParentNode, pen: { readonly x: number; readonly y: number } | null): void {
  for (const card of root.querySelectorAll<HTMLElement>('.chrome')) {
    const near = pen !== null && distance(card, pen) < NEAR;
    card.classList.toggle('away', near);
  }
}

/** px */
const NEAR = 48;

/** The pen's place is given in the element's own box. */
function distance(card: HTMLElement, { x, y }: { readonly x: number; readonly y: number }): number {
  const frame = card.closest('.app')?.getBoundingClientRect() ?? { left: 0, top: 0 };
  const box = card.getBoundingClientRect();
  const dx = Math.max(box.left - frame.left - x, x - (box.right - frame.left), 0);
  const dy = Math.max(box.top - frame.top - y, y - (box.bottom - frame.top), 0);
  return Math.hypot(dx, dy);
}
