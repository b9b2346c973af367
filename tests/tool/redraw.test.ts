import { describe, expect, test } from 'vitest';
import { solids } from '../../src/document/build.ts';
import { isSurface } from '../../src/document/document.ts';
import { length3, rotate3 } from '../../src/math/tuple.ts';
import { project, toWorld } from '../../src/stroke/plane.ts';
import { redrawing, redrawOnce } from '../../src/tool/redraw.ts';
import { selecting } from '../../src/tool/select.ts';
import { strokeAlong } from '../document/strokes.ts';
import type { Driver } from './driver.ts';
import { balls, exactBall, RADIUS } from './scene.ts';

/** px a mm */
const SCALE = 3;
/** From a little above, so that sections are seen, and the sides no longer as they were drawn. */
const ABOVE = { rotation: [-0.5, 0, 0, Math.sqrt(0.75)] } as const;

function hand(view: Partial<Driver['view']> = {}): Driver {
  const driver = balls([0, 0, 500]);
  driver.view = { ...driver.view, ...view };
  driver.surface = exactBall(driver);
  driver.state = redrawing(false);
  return driver;
}

const hover = (driver: Driver, x: number, y: number) => {
  const pen = { x, y, pressure: 0, tiltX: 0, tiltY: 0, time: 0, pointer: 'pen' } as const;
  driver.state = driver.state.hover?.(pen, driver) ?? driver.state;
};
const partOf = (driver: Driver) => driver.document.parts.filter(isSurface)[0]!;
const lit = (driver: Driver) => driver.state.marks?.find((mark) => mark.kind === 'line');

describe('what is lit', () => {
  test('a side that is seen as it was drawn, where the pen is near it', () => {
    const driver = hand();
    hover(driver, 400 + SCALE * RADIUS - 6, 300);
    expect(driver.state.redrawing?.over).toBe('side');
    hover(driver, 400 + SCALE * RADIUS + 60, 300);
    expect(driver.state.redrawing?.over).toBeNull();
  });

  test('else the section through the point under the pen', () => {
    const driver = hand(ABOVE);
    hover(driver, 400, 320);
    expect(driver.state.redrawing?.over).toBe('section');
    const under = exactBall(driver)(400, 320)!.point;
    const mark = lit(driver);
    const points = mark?.kind === 'line' ? mark.points : [];
    // all at the height of that point, on the ball
    for (const p of points) {
      expect(p[1]).toBeCloseTo(under[1], 1);
      expect(length3(p)).toBeCloseTo(RADIUS, 0);
    }
    expect(points.length).toBeGreaterThan(8);
  });

  test('of a part, whatever a file calls it, though there is an unfinished form', () => {
    const driver = hand(ABOVE);
    const id = 'draftsman';
    const parts = driver.document.parts.map((part, i) => (i === 0 ? { ...part, id } : part));
    driver.commit([
      { type: 'load', document: { ...driver.document, parts }, name: '' },
      { type: 'addStroke', stroke: strokeAlong((t) => [90, 40 * t - 20]) },
    ]);
    const ball = exactBall(driver);
    driver.surface = (x, y) => {
      const hit = ball(x, y);
      return hit && { ...hit, id };
    };
    driver.draw([
      [370, 338],
      [400, 372],
      [430, 338],
    ]);
    expect(driver.document.draft?.sections).toBeUndefined();
    expect(partOf(driver)).toMatchObject({ id, kind: 'crossSection' });
  });

  test('not one that is seen from its edge: words say why', () => {
    const driver = hand();
    driver.draw([
      [390, 300],
      [420, 320],
    ]);
    expect(driver.notices.at(-1)).toBe('section-edge-on');
  });

  test('which is said once when the pen hovers there, with a view from where it is seen', () => {
    const driver = hand();
    for (const x of [390, 395, 400]) hover(driver, x, 320);
    expect(driver.notices).toEqual(['section-edge-on']);
    driver.view = driver.from!;
    hover(driver, 400, 320);
    expect(driver.state.redrawing?.over).toBe('section');
    // from above
    expect(rotate3(driver.view.rotation, [0, 0, 1])[1]).toBeGreaterThan(0.5);
  });

  test('at hover is what is drawn over, wherever about the pen lands', () => {
    const driver = hand(ABOVE);
    hover(driver, 400, 320);
    const before = lit(driver);
    const pen = { pressure: 0.5, tiltX: 0, tiltY: 0, time: 0, pointer: 'pen' } as const;
    driver.state = driver.state.down!({ ...pen, x: 404, y: 329 }, driver)!;
    expect(lit(driver)).toEqual(before);
  });
});

describe('what is drawn', () => {
  test('over a side takes the place of a part of it: one undo step', () => {
    const driver = hand();
    const before = driver.document;
    const x = 400 + SCALE * RADIUS;
    driver.draw([
      [x - 8, 270],
      [x + 30, 300],
      [x - 8, 330],
    ]);
    const widest = Math.max(
      ...partOf(driver).strokes.flatMap(({ samples }) => samples.map(({ x: mm }) => mm)),
    );
    expect(widest).toBeCloseTo(RADIUS + 10, 0);
    expect(partOf(driver).kind).toBe('rotational');
    driver.undo();
    expect(driver.document).toBe(before);
  });

  test('over a section makes the form one of sections; its surface passes where the pen was', () => {
    const driver = hand(ABOVE);
    hover(driver, 400, 330);
    const bulge = [
      [370, 338],
      [400, 372],
      [430, 338],
    ] as const;
    driver.trace(bulge);
    expect(driver.state.preview?.(driver)).not.toBeNull();
    driver.up();
    const part = partOf(driver);
    expect(part.kind).toBe('crossSection');
    expect(part.back).toBe('front');
    const drawn = part.sections[0]!.redraws[0]!;
    // the stroke is kept on the section's plane: there it is seen where it was drawn
    const { x, y } = drawn.stroke.samples[0]!;
    const seen = project(driver.view, driver.size, toWorld(drawn.stroke.plane, [x, y]))!;
    expect(Math.hypot(seen[0] - 370, seen[1] - 338)).toBeLessThan(1e-6);
    expect(solids(driver.document)[0]!.mesh.indices.length).toBeGreaterThan(0);
  });

  test('on a part that was moved is kept in the part’s own space', () => {
    const driver = hand(ABOVE);
    const turn = [0, Math.SQRT1_2, 0, Math.SQRT1_2] as const;
    driver.commit([{ type: 'moveParts', ids: ['part-1'], by: { rotation: turn, translation: [0, 0, 0] } }]);
    driver.draw([
      [370, 338],
      [400, 372],
      [430, 338],
    ]);
    const { stroke } = partOf(driver).sections[0]!.redraws[0]!;
    const { x, y } = stroke.samples[0]!;
    const world = rotate3(turn, toWorld(stroke.plane, [x, y]));
    const seen = project(driver.view, driver.size, world)!;
    expect(Math.hypot(seen[0] - 370, seen[1] - 338)).toBeLessThan(1e-6);
  });

  test('only here leaves the ends as they were', () => {
    const driver = hand(ABOVE);
    driver.state = redrawing(true);
    driver.draw([
      [370, 338],
      [400, 372],
      [430, 338],
    ]);
    expect(partOf(driver).kind).toBe('bspline');
    expect(partOf(driver).sections.map(({ redraws }) => redraws.length)).toEqual([0, 1, 0]);
  });

  test('is gone when it is cancelled, and what was lit is lit again', () => {
    const driver = hand(ABOVE);
    const before = driver.document;
    driver.trace([
      [370, 338],
      [430, 338],
    ]);
    driver.cancel();
    expect(driver.document).toBe(before);
    expect(driver.state.name).toBe('redraw.lit');
  });

  test('with the other end of the pen is one stroke, and the tool in hand goes on', () => {
    const driver = hand(ABOVE);
    driver.state = redrawOnce(selecting);
    driver.draw([
      [370, 338],
      [400, 372],
      [430, 338],
    ]);
    expect(partOf(driver).sections).toHaveLength(1);
    expect(driver.state).toBe(selecting);
  });
});
