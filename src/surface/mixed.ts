/** What a patch makes of its sections at one u, as an outline of its own (alike.ts, between.ts): a section that is there already, and can be redrawn. */
import { scale2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { type Along, alike } from './alike.ts';
import { type Between, mixOf } from './between.ts';
import type { Outline } from './outline.ts';
import { formsOf, inOrder, type PlacedOutline } from './weave.ts';

/** At least one section, all open or all closed; `isRound`: the surface runs round, u = 1 is u = 0. */
export function mixedOutline(
  placed: readonly PlacedOutline[],
  at: number,
  between: Between,
  isRound: boolean,
): Outline {
  const sections = inOrder(placed, isRound);
  const u = isRound && at >= 1 ? 0 : at;
  const made = alike(sections.map(({ outline }) => outline));
  const us = sections.map((section) => section.u);
  const shares = mixOf(us, formsOf(made, us.length), between, isRound)(u, 1);
  const { closed, pieces } = made;
  const breaks = made.seamless ? [] : pieces.map(({ from }) => from);
  // closed outlines begin in the middle of a piece, perhaps
  const pieceAt = (v: number, side: -1 | 1) => {
    const found = pieces.findLastIndex(({ from }) => (side === 1 ? from <= v : from < v));
    return found < 0
      ? { piece: pieces[pieces.length - 1]!, at: closed ? v + 1 : v }
      : { piece: pieces[found]!, at: v };
  };
  const sum = (v: number, side: -1 | 1, of: (along: Along, at: number) => Vec2): Vec2 => {
    const { piece, at } = pieceAt(v, side);
    return shares
      .map(({ section, weight }) => scale2(of(piece.along[section]!, at), weight))
      .reduce(([ax, ay], [bx, by]): Vec2 => [ax + bx, ay + by]);
  };
  return {
    closed,
    corners: breaks
      .map((v) => (v >= 1 ? v - 1 : v))
      .filter((v) => closed || (v > 0 && v < 1))
      .sort((a, b) => a - b),
    point: (v) => sum(v, 1, (along, at) => along.point(at)),
    derivative: (v, side) => sum(v, side, (along, at) => along.derivative(at)),
  };
}
