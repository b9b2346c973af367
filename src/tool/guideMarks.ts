/** The section guide as marks (thesis fig. 5.10): the chord, the round sides of a cylinder seen a little from above, and where ends snap. */
import { cos, PI, sin } from '../math/trig.ts';
import { add2, distance2, mix2, scale2, sub2 } from '../math/tuple.ts';
import type { Vec2 } from '../math/vec.ts';
import { toWorld } from '../stroke/plane.ts';
import { runsLeft } from '../surface/chordWay.ts';
import { endsOf, type Guide } from './across.ts';
import type { Mark, MarkWord } from './marks.ts';
import type { Viewport } from './viewport.ts';

/** of half the chord: how deep the round sides are drawn; a half circle would hide the form */
const DEPTH = 0.44;
const STEPS = 32;
/** px of a chord that has room for words */
const WORDY = 84;

export interface GuideOptions {
  /** while a stroke is drawn: ends that are held in their places */
  readonly held?: { readonly near: boolean; readonly far: boolean };
}

export function guideMarks(guide: Guide, viewport: Viewport, { held }: GuideOptions = {}): readonly Mark[] {
  const { across, left, right, near, side, u } = guide;
  const world = (p: Vec2) => toWorld(across.plane, p);
  const [at, other] = near === 'left' ? [left, right] : [right, left];
  const dot = (p: Vec2, isHeld: boolean | undefined): Mark =>
    isHeld ? { kind: 'dot', at: world(p), held: true } : { kind: 'dot', at: world(p) };
  const round = (style: 'full' | 'hollow', sense: 1 | -1): Mark => {
    const points = halfRound(guide, sense).map(world);
    return { kind: 'line', style, points };
  };
  const isFront = side === 'front';
  return [
    ...(isFront ? [round('full', 1)] : []),
    round('hollow', -1),
    { kind: 'line', style: 'flat', points: [world(left), world(right)] },
    dot(at, held?.near),
    dot(other, held?.far),
    ...(held ? [] : [{ kind: 'ring' as const, at: world(at) }]),
    ...(held || !hasRoom(guide, viewport) ? [] : labels(guide)),
    { kind: 'tag', at: world(other), from: world(at), value: 100 * u, unit: '%' },
  ];
}

function hasRoom(guide: Guide, viewport: Viewport): boolean {
  const [a, b] = endsOf(guide, viewport);
  return a !== null && b !== null && distance2(a, b) >= WORDY;
}

/** Towards the full side. */
function across2({ across: { pair }, left, right }: Guide): Vec2 {
  const [dx, dy] = sub2(right, left);
  const way = runsLeft((u) => pair.at(u, 1)) ? -0.5 : 0.5;
  return [way * dy, -way * dx];
}

function halfRound(guide: Guide, sense: 1 | -1): readonly Vec2[] {
  const { left, right } = guide;
  const middle = mix2(left, right, 0.5);
  const half = scale2(sub2(right, left), 0.5);
  const deep = scale2(across2(guide), sense * DEPTH);
  return Array.from({ length: STEPS + 1 }, (_, i) => {
    const angle = (PI * i) / STEPS;
    return add2(middle, add2(scale2(half, -cos(angle)), scale2(deep, sin(angle))));
  });
}

function labels(guide: Guide): Mark[] {
  const { across, left, right, side } = guide;
  const middle = mix2(left, right, 0.5);
  const deep = scale2(across2(guide), DEPTH);
  const label = (word: MarkWord, p: Vec2, from: Vec2): Mark => ({
    kind: 'label',
    word,
    at: toWorld(across.plane, p),
    from: toWorld(across.plane, from),
  });
  const full = add2(middle, deep);
  const hollow = sub2(middle, deep);
  if (side === 'back') return [label('back', hollow, middle)];
  return [label('full', full, middle), label('hollow', hollow, middle), label('flat', middle, full)];
}
