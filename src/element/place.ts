/** Where the chip goes: 24 px under the form; no room there, above it; else beside it. Never outside the picture. */
import type { Mesh } from '../mesh/mesh.ts';
import { project, toWorld } from '../stroke/plane.ts';
import type { Stroke, View } from '../stroke/stroke.ts';

export interface Size {
  readonly width: number;
  readonly height: number;
}

export interface Rect {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

export interface Place {
  /** middle of the chip's upper edge, CSS pixels */
  readonly x: number;
  readonly y: number;
  /** icons only, to fit beside the form */
  readonly narrow: boolean;
}

/** px: about what the chip needs, and what lies at the edges: tool rail, top row, meter */
const CHIP = {
  width: 352,
  narrow: 190,
  height: 52,
  narrowHeight: 52,
  gap: 24,
  side: 84,
  top: 76,
  bottom: 92,
  /** the view ball's upper end over that of the meter */
  ball: 20,
} as const;

/** px of a chip; `narrow`: its width with icons only */
export interface ChipSize {
  readonly width: number;
  readonly narrow: number;
  readonly height: number;
  /** with icons only, in rows below each other */
  readonly narrowHeight: number;
  /** from a form that it lies beside */
  readonly beside?: number;
}

/** The box of meshes on the screen, CSS pixels; null when nothing is in front of the camera. */
export function screenBox(meshes: readonly Mesh[], view: View, size: Size): Rect | null {
  let box: Rect | null = null;
  for (const { positions } of meshes) {
    // Every seventh vertex is near enough for placing a card, and a drag stays cheap.
    for (let i = 0; i + 2 < positions.length; i += 21) {
      const p = project(view, size, [positions[i]!, positions[i + 1]!, positions[i + 2]!]);
      if (p) box = grown(box, p[0], p[1]);
    }
  }
  return box;
}

/** The box of strokes on the screen: for a form that has no surface. */
export function strokesBox(strokes: readonly Stroke[], view: View, size: Size): Rect | null {
  let box: Rect | null = null;
  for (const { plane, samples } of strokes)
    for (const { x, y } of samples) {
      const p = project(view, size, toWorld(plane, [x, y]));
      if (p) box = grown(box, p[0], p[1]);
    }
  return box;
}

function grown(box: Rect | null, x: number, y: number): Rect {
  if (!box) return { left: x, right: x, top: y, bottom: y };
  return {
    left: Math.min(box.left, x),
    right: Math.max(box.right, x),
    top: Math.min(box.top, y),
    bottom: Math.max(box.bottom, y),
  };
}

export function chipPlace(box: Rect, size: Size, chip: ChipSize = CHIP): Place {
  const { side, top, bottom, gap } = CHIP;
  const { height } = chip;
  const middle = clamp((box.left + box.right) / 2, side + chip.width / 2, size.width - 16 - chip.width / 2);
  const lowest = size.height - bottom - height;
  if (box.bottom + gap <= lowest) return { x: middle, y: Math.max(top, box.bottom + gap), narrow: false };
  if (box.top - gap - height >= top) return { x: middle, y: box.top - gap - height, narrow: false };
  for (const narrow of [false, true]) {
    const least = size.height - bottom - (narrow ? chip.narrowHeight : height);
    const y = clamp((box.top + box.bottom) / 2, top, least);
    const half = (narrow ? chip.narrow : chip.width) / 2;
    const beside = chip.beside ?? gap;
    const right = box.right + beside + half;
    if (right + half <= size.width - 16) return { x: right, y, narrow };
    const left = box.left - beside - half;
    if (left - half >= side) return { x: left, y, narrow };
  }
  return partlyBeside(box, size, chip) ?? { x: middle, y: lowest, narrow: false };
}

/** At its lower end, over less than a quarter of its width; null: it fills the picture, and the chip lies where the meter is anyway. */
function partlyBeside(box: Rect, size: Size, { narrow, narrowHeight }: ChipSize): Place | null {
  const { side, bottom, ball } = CHIP;
  const y = size.height - bottom - ball - narrowHeight;
  const left = { x: side + narrow / 2, over: side + narrow - box.left };
  const right = { x: size.width - 16 - narrow / 2, over: box.right - (size.width - 16 - narrow) };
  const { x, over } = left.over <= right.over ? left : right;
  return over < (box.right - box.left) / 4 ? { x, y, narrow: true } : null;
}

const clamp = (value: number, low: number, high: number) =>
  Math.max(low, Math.min(Math.max(low, high), value));
