import { beforeEach, describe, expect, it } from 'vitest';
import { solids } from '../../src/document/build.ts';
import { itemsOf } from '../../src/document/command/changeParts.ts';
import { newHistory } from '../../src/document/history.ts';
import { shapedOf } from '../../src/document/solidNode.ts';
import { project } from '../../src/stroke/plane.ts';
import { selecting } from '../../src/tool/select.ts';
import type { Pen } from '../../src/tool/tool.ts';
import { figure, solidOf } from '../document/figure.ts';
import { line } from '../document/strokes.ts';
import type { Driver } from './driver.ts';
import { tubes } from './scene.ts';

/** Three upright tubes of 12 mm: 300 px, 400 px and 500 px from the left, 36 px wide. */
let hand: Driver;
beforeEach(() => {
  hand = tubes(-100 / 3, 0, 100 / 3);
  hand.state = selecting;
  const tubesAt = [300, 400, 500];
  hand.surface = (x, y, except = []) => {
    const i = tubesAt.findIndex((at) => Math.abs(x - at) <= 18 && Math.abs(y - 300) <= 108);
    const id = `part-${i + 1}`;
    if (i < 0 || except.includes(id)) return null;
    return { point: [(x - 400) / 3, (300 - y) / 3, 6], normal: [0, 0, 1], id };
  };
});

function press(x: number, y: number, more: Partial<Pen> = {}): void {
  const pen: Pen = { x, y, pressure: 0.5, tiltX: 0, tiltY: 0, time: 0, pointer: 'pen', ...more };
  hand.state = hand.state.down?.(pen, hand) ?? hand.state;
}

function tap(x: number, y: number, more: Partial<Pen> = {}): void {
  press(x, y, more);
  hand.up();
}

describe('a tap', () => {
  it('takes the part under the pen, another one in its place, and lets go on the paper', () => {
    tap(300, 300);
    expect(hand.selection).toEqual(['part-1']);
    tap(500, 300);
    expect(hand.selection).toEqual(['part-3']);
    tap(600, 300);
    expect(hand.selection).toEqual([]);
    expect(hand.notices).toEqual(['selected', 'selected', 'selected']);
  });

  it('with Shift or Ctrl adds and takes away, and on the paper changes nothing', () => {
    tap(300, 300);
    tap(500, 300, { adds: true });
    expect(hand.selection).toEqual(['part-1', 'part-3']);
    tap(700, 300, { adds: true });
    expect(hand.selection).toEqual(['part-1', 'part-3']);
    tap(300, 300, { adds: true });
    expect(hand.selection).toEqual(['part-3']);
  });

  it('finds what lies close beside the pen, for a finger further away', () => {
    tap(321, 300);
    expect(hand.selection).toEqual(['part-1']);
    tap(327, 300);
    expect(hand.selection).toEqual([]);
    tap(327, 300, { pointer: 'touch' });
    expect(hand.selection).toEqual(['part-1']);
  });

  it('on the unfinished form changes nothing: it is no part yet', () => {
    tap(300, 300);
    hand.commit([{ type: 'addStroke', stroke: line(60) }]);
    const { draft } = hand.document;
    hand.surface = () => ({ point: [60, 0, 6], normal: [0, 0, 1], id: 'draft-0' });
    tap(580, 300);
    expect(hand.selection).toEqual(['part-1']);
    expect(hand.document.draft).toBe(draft);
  });

  it('and another one soon after bring the camera to the part', () => {
    tap(300, 300, { time: 1000 });
    tap(301, 300, { time: 1200 });
    expect(hand.focused).toEqual([['part-1']]);
    tap(301, 300, { time: 1300 });
    tap(500, 300, { time: 1400 });
    tap(500, 300, { time: 2400 });
    expect(hand.focused).toHaveLength(1);
    expect(hand.selection).toEqual(['part-3']);
  });

  it('that is cancelled selects nothing; waiting for a second tap there is nothing to cancel', () => {
    press(300, 300);
    hand.cancel();
    expect(hand.selection).toEqual([]);
    tap(300, 300);
    const { state } = hand;
    hand.cancel();
    expect(hand.state).toBe(state);
  });
});

describe('a drag from a part', () => {
  it('moves all that is selected, the point under the pen with it', () => {
    hand.select(['part-1', 'part-2']);
    press(300, 300);
    hand.move(304, 300);
    expect(hand.state.name).toBe('select.pressed');
    hand.move(360, 330);
    hand.up();
    const [a, b, c] = hand.document.parts.map(({ placement }) => placement.translation);
    expect(a![0]).toBeCloseTo(20, 9);
    expect(a![1]).toBeCloseTo(-10, 9);
    expect(b).toEqual(a);
    expect(c).toEqual([0, 0, 0]);
    hand.undo();
    expect(hand.document.parts.every(({ placement }) => placement.translation[0] === 0)).toBe(true);
  });

  it('takes one that is not selected first', () => {
    hand.select(['part-1']);
    press(500, 300);
    hand.move(530, 300);
    expect(hand.selection).toEqual(['part-3']);
    expect(hand.state.carried?.ids).toEqual(['part-3']);
  });
});

describe('a drag over the paper', () => {
  const box = (from: readonly [number, number], to: readonly [number, number], adds = false) => {
    press(...from, { adds });
    hand.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
    hand.move(...to);
    expect(hand.state.band).toMatchObject({ from: { x: from[0] }, to: { x: to[0] } });
    hand.up();
  };

  it('takes exactly the parts with a vertex in its rectangle, whichever way it is drawn', () => {
    const rectangles = [
      [250, 150, 450, 450],
      [450, 450, 250, 150],
      [250, 150, 283, 450],
      [250, 150, 281, 450],
      [350, 390, 700, 420],
    ] as const;
    for (const [x0, y0, x1, y1] of rectangles) {
      box([x0, y0], [x1, y1]);
      const inside = solids(hand.document).filter(({ mesh }) => {
        for (let i = 0; i < mesh.positions.length; i += 3) {
          const [x, y] = project(hand.view, hand.size, [
            mesh.positions[i]!,
            mesh.positions[i + 1]!,
            mesh.positions[i + 2]!,
          ])!;
          if (
            x >= Math.min(x0, x1) &&
            x <= Math.max(x0, x1) &&
            y >= Math.min(y0, y1) &&
            y <= Math.max(y0, y1)
          )
            return true;
        }
        return false;
      });
      expect(hand.selection).toEqual(inside.map(({ id }) => id));
    }
  });

  it('with Shift adds, around nothing lets go, and leaves hidden parts out', () => {
    box([450, 150], [550, 450]);
    expect(hand.selection).toEqual(['part-3']);
    box([250, 150], [350, 450], true);
    expect([...hand.selection].sort()).toEqual(['part-1', 'part-3']);
    box([600, 100], [650, 150]);
    expect(hand.selection).toEqual([]);
    hand.commit([{ type: 'showParts', ids: ['part-1'], visible: false }]);
    box([200, 150], [450, 450]);
    expect(hand.selection).toEqual(['part-2']);
  });

  it('that is cancelled leaves the selection as it was', () => {
    hand.select(['part-2']);
    press(600, 100);
    hand.move(100, 500);
    hand.cancel();
    expect(hand.selection).toEqual(['part-2']);
    expect(hand.state).toBe(selecting);
  });
});

describe('a solid of several groups', () => {
  /** Left of 400 px the head of the figure, right of it the eye. */
  beforeEach(() => {
    hand.history = newHistory(figure());
    hand.surface = (x) => {
      const path = x < 400 ? `parts[0].skels[${bodySkels()}]` : 'parts[1].skels[0]';
      return { point: [0, 0, 0], normal: [0, 0, 1], id: 'part-1', skel: { path, share: 1 } };
    };
  });
  const bodySkels = () => {
    const { part, groups } = solidOf(hand.document);
    return shapedOf(groups[0]!, part.components[0]!)!.skels.length;
  };
  const names = () =>
    itemsOf(hand.document)
      .filter(({ id }) => hand.selection.includes(id))
      .map(({ name }) => name);

  it('is taken first, then the group under the pen, then another one', () => {
    tap(300, 300, { time: 1000 });
    expect(hand.selection).toEqual(['part-1']);
    tap(300, 300, { time: 2000 });
    expect(names()).toEqual(['Head']);
    tap(500, 300, { time: 3000 });
    expect(names()).toEqual(['Eye']);
  });

  it('is what a double tap brings the camera to', () => {
    tap(300, 300, { time: 1000 });
    tap(300, 300, { time: 1200 });
    expect(hand.focused).toEqual([['part-1']]);
    expect(hand.selection).toEqual(['part-1']);
  });

  it('moves with a drag, or the group of it that is selected', () => {
    tap(300, 300, { time: 1000 });
    tap(500, 300, { time: 2000 });
    const before = solidOf(hand.document).groups;
    press(300, 300);
    hand.move(330, 300);
    hand.up();
    const after = solidOf(hand.document).groups;
    expect(after.slice(0, 3)).toEqual(before.slice(0, 3));
    expect(after[3]!.strokes[0]!.plane.origin[0]).toBeCloseTo(10, 9);
  });
});
