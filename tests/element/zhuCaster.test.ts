/** Who has Zhu's rays cast: one worker a picture, what it says in images, what was given up is not heard of. */
import { expect, test } from 'vitest';
import type { ShownBody } from '../../src/element/caster.ts';
import type { Castable } from '../../src/element/rayWorker.ts';
import { ZhuCaster } from '../../src/element/zhuCaster.ts';
import { OFFSETS } from '../../src/field/rayEdges.ts';
import { emptyImage } from '../../src/field/rayScene.ts';
import type { FromZhu, ToZhu } from '../../src/field/zhuWork.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import { body } from '../field/trees.ts';

const CAMERA = {
  view: { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 20, fov: 0 },
  width: 4,
  height: 3,
  offset: [0.5, 0.5],
} as const;
const BODY: ShownBody = { id: 'a', node: body(), placement: UNMOVED, cells: 32 };
const COMPARISON = {
  hits: 3,
  zhu: { evaluationsPerPixel: 50, missed: 1 },
  bricks: { evaluationsPerPixel: 8, missed: 0 },
} as const;

class Fake implements Castable {
  readonly heard: ToZhu[] = [];
  ended = false;
  onmessage: Castable['onmessage'] = null;
  onerror: Castable['onerror'] = null;
  postMessage(message: ToZhu): void {
    this.heard.push(message);
  }
  terminate(): void {
    this.ended = true;
  }
  say(data: FromZhu): void {
    (this.onmessage as (event: { readonly data: FromZhu }) => void)({ data });
  }
}

function begun() {
  const workers: Fake[] = [];
  const caster = new ZhuCaster(() => {
    workers.push(new Fake());
    return workers.at(-1)!;
  });
  const refused: string[] = [];
  let changes = 0;
  const listener = { changed: () => void changes++, refused: (why: string) => void refused.push(why) };
  return { caster, workers, refused, listener, changes: () => changes };
}

const images = [CAMERA.offset, ...OFFSETS].map(() => emptyImage(CAMERA));
const DONE: FromZhu = { type: 'compared', comparison: COMPARISON, images, milliseconds: 70 };

test('images come at once, with what both did', () => {
  const { caster, workers, listener, changes } = begun();
  const cast = caster.cast([BODY], CAMERA, listener);
  const { id: _, ...sent } = BODY;
  expect(workers[0]!.heard).toEqual([{ bodies: [sent], camera: CAMERA }]);
  workers[0]!.say({ type: 'progress', share: 0.4 });
  expect(cast).toMatchObject({ count: 0, share: 0.4, evaluationsAPixel: null });
  workers[0]!.say(DONE);
  expect(cast).toMatchObject({ count: 5, whole: 5, evaluationsAPixel: 50, milliseconds: 70 });
  expect(caster.comparison).toEqual(COMPARISON);
  expect(cast.image(2)).toMatchObject({ items: ['a'], camera: { offset: OFFSETS[1] } });
  expect(changes()).toBe(2);
  expect(workers[0]!.ended).toBe(true);
});

test('a newer picture, and the end of all, end what was asked before', () => {
  const { caster, workers, listener, changes, refused } = begun();
  const old = caster.cast([BODY], CAMERA, listener);
  caster.cast([BODY], CAMERA, listener);
  expect(workers.map(({ ended }) => ended)).toEqual([true, false]);
  workers[0]!.say(DONE);
  expect(old.count).toBe(0);
  expect(changes()).toBe(0);
  caster.end();
  expect(refused).toEqual(['given up']);
  expect(workers[1]!.ended).toBe(true);
});

test('what cannot be cast is refused in words', () => {
  const { caster, workers, listener, refused } = begun();
  caster.cast([BODY], CAMERA, listener);
  workers[0]!.say({ type: 'refused', message: 'not a sum' });
  expect(refused).toEqual(['not a sum']);
  const none = new ZhuCaster(() => {
    throw new Error('no workers');
  });
  none.cast([BODY], CAMERA, listener);
  expect(refused).toEqual(['not a sum', 'no workers']);
});
