/**
 * The edges of a region as numbers, and for kernels with a support chords over runs of them.
 *
 * A run that lies in a circle beyond the support may be replaced by its chord: what lies between is beyond the support too. So
 * each loop becomes a binary tree of chords in one array, whose walk takes a chord as an edge and leaves out what is below it
 * where its circle is out of reach: what is far costs an angle or two instead of one an edge (quartic: a fifth of the time for 69
 * edges, a tenth for 223). No kernel knows of it, and points over edges stay as good as any.
 */
import type { Vec2 } from '../math/vec.ts';
import type { Region } from './region.ts';

/** of an edge or chord: its ends, direction and length (7), the circle around its run (3), the index after its tree */
export const STRIDE = 11;
export const CIRCLE = 7;
export const NEXT = 10;

/** In kernel units about the middle, of which a millimetre has `per`; parents before children. */
export function outlineOf({ loops }: Region, per: number, support: number): Float64Array {
  const nodes: number[] = [];
  for (const loop of loops) {
    const corners = [loop.at(-1)!, ...loop].map(([x, y]): Vec2 => [x * per, y * per]);
    if (support < Infinity) addTree(nodes, corners);
    else for (let i = 1; i < corners.length; i++) addTree(nodes, corners.slice(i - 1, i + 1));
  }
  return Float64Array.from(nodes);
}

function addTree(nodes: number[], corners: readonly Vec2[]): void {
  const start = nodes.length;
  nodes.push(...chordOf(corners), ...circleAround(corners), 0);
  const edges = corners.length - 1;
  if (edges > 1) {
    const half = edges >> 1;
    addTree(nodes, corners.slice(0, half + 1));
    addTree(nodes, corners.slice(half));
  }
  nodes[start + NEXT] = nodes.length;
}

function chordOf(corners: readonly Vec2[]): number[] {
  const [x0, y0] = corners[0]!;
  const [x1, y1] = corners.at(-1)!;
  const [dx, dy] = [x1 - x0, y1 - y0];
  const length = Math.sqrt(dx * dx + dy * dy);
  // a whole loop ends where it begins
  const per = length > 0 ? 1 / length : 0;
  return [x0, y0, x1, y1, dx * per, dy * per, length];
}

function circleAround(corners: readonly Vec2[]): number[] {
  const middle = (axis: 0 | 1) => {
    const values = corners.map((corner) => corner[axis]);
    return 0.5 * (Math.min(...values) + Math.max(...values));
  };
  const [cx, cy] = [middle(0), middle(1)];
  const r2 = Math.max(...corners.map(([x, y]) => (x - cx) * (x - cx) + (y - cy) * (y - cy)));
  return [cx, cy, Math.sqrt(r2)];
}
