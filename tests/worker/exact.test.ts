/** A worker that casts rays as its page hears it: bands, edges, rays at edges; the latest wish wins; what was located is kept. */
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest';
import type { Cast, FromExact, ToExact } from '../../src/field/exactWork.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { OFFSETS } from '../../src/field/rayEdges.ts';
import { emptyImage } from '../../src/field/rayScene.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import { body } from '../field/trees.ts';
import { random } from '../fixtures/random.ts';
import { FakeScope } from './scope.ts';

const scope = new FakeScope<ToExact, FromExact>();
const { heard, say } = scope;
const sphere: FieldNode = { type: 'shape', shape: { type: 'sphere', radius: 10 } };
const [WIDTH, HEIGHT] = [40, 30];
const VIEW = { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 30, fov: 0 } as const;

const BAND = 10;
const bands = HEIGHT / BAND;

/** A picture, and all bands of it. */
function wish(id: number, more: Partial<Cast> = {}): void {
  say({
    type: 'cast',
    id,
    bodies: [{ name: 'a', key: 1, node: sphere, placement: UNMOVED, cells: 24 }],
    camera: { view: VIEW, width: WIDTH, height: HEIGHT, offset: [0.5, 0.5] },
    ...more,
  });
  for (let from = 0; from < HEIGHT; from += BAND) say({ type: 'band', id, from, to: from + BAND });
}
const of = <T extends FromExact['type']>(id: number, type: T) =>
  heard.filter(
    (message): message is Extract<FromExact, { type: T }> => message.id === id && message.type === type,
  );
const whole = (id: number) => vi.waitFor(() => expect(of(id, 'band').length).toBe(bands), 15_000);
const workOf = (id: number): number => of(id, 'band').reduce((sum, { work }) => sum + work, 0);

beforeAll(async () => {
  vi.stubGlobal('self', scope);
  await import('../../src/worker/exact.ts');
});
beforeEach(() => {
  scope.forget();
});

describe('the worker', () => {
  test('casts the rows of a ball, then its edges again', async () => {
    wish(1);
    await whole(1);
    const image = emptyImage({ width: WIDTH, height: HEIGHT });
    const places: number[] = [];
    for (const { from, surface, colours, places: found } of of(1, 'band')) {
      image.surface.set(surface!, 4 * from * WIDTH);
      image.colours.set(colours!, 4 * from * WIDTH);
      places.push(...found);
    }
    for (let at = 0; at < WIDTH * HEIGHT; at++) {
      const [x, y] = [(at % WIDTH) + 0.5 - WIDTH / 2, Math.floor(at / WIDTH) + 0.5 - HEIGHT / 2];
      const depth = Math.sqrt(100 - x * x - y * y);
      expect(image.colours[4 * at + 3]).toBe(depth > 0 ? 1 : 0);
      if (depth > 0) expect(image.surface[4 * at + 3]).toBeCloseTo(depth, 3);
    }
    expect(workOf(1)).toBeGreaterThan(0.2 * WIDTH * HEIGHT);
    // around a circle of ten pixels' radius
    expect(places.length).toBeGreaterThan(50);
    expect(places.length).toBeLessThan(200);
    // where the circle is crossed the four places of a pixel differ
    const asked = Uint32Array.from(places);
    for (const offset of OFFSETS.keys()) say({ type: 'again', id: 1, offset, first: 7, places: asked });
    await vi.waitFor(() => expect(of(1, 'again').length).toBe(OFFSETS.length));
    for (const { offset, first, count, colours } of of(1, 'again')) {
      expect([first, count]).toEqual([7, places.length]);
      const [dx, dy] = OFFSETS[offset]!;
      for (const [i, at] of places.entries()) {
        const [x, y] = [(at % WIDTH) + dx - WIDTH / 2, Math.floor(at / WIDTH) + dy - HEIGHT / 2];
        expect(colours![4 * i + 3]).toBe(x * x + y * y < 100 ? 1 : 0);
      }
    }
  });

  test('looks for a body once, however often it is looked at', async () => {
    const blob = body();
    const bodies = [{ name: 'b', key: 2, node: blob, placement: UNMOVED, cells: 64 }];
    const view = { ...VIEW, rotation: [0, 1, 0, 0] } as const;
    const evaluations: number[] = [];
    for (const [id, seen] of [
      [11, VIEW],
      [12, view],
      [13, VIEW],
    ] as const) {
      wish(id, {
        bodies,
        camera: { view: seen, width: WIDTH, height: HEIGHT, offset: [0.5, 0.5] },
      });
      await whole(id);
      evaluations.push(workOf(id));
    }
    expect(of(12, 'locating')).toEqual([]);
    expect(of(13, 'locating')).toEqual([]);
    // balls that hold no surface are known then
    expect(evaluations[2]).toBeLessThan(evaluations[0]! * (1 + 1e-9));
    expect(evaluations[2]).toBeGreaterThan(0.2 * evaluations[0]!);
  });

  test.each([1, 2, 3])('of many wishes at any moment the last is cast, seed %d', async (seed) => {
    const next = random(seed);
    const first = 1000 * seed;
    let id = first;
    let newest = first;
    const late: number[] = [];
    scope.onHeard = (message) => {
      // what a slice of work says before messages are heard again is the page's to leave
      if (message.id < newest) late.push(message.id);
      newest = message.id;
      if (id < first + 10 && next() < 0.3) wish(++id);
    };
    wish(id, { bodies: [{ name: 'c', key: 5, node: sphere, placement: UNMOVED, cells: 48 }] });
    await vi.waitFor(() => {
      if (id < first + 10 && of(id, 'band').length === bands) wish(++id);
      expect(of(first + 10, 'band').length).toBe(bands);
    }, 15_000);
    expect(late).toEqual([]);
  });

  test('stops when told to, and goes on afterwards', async () => {
    wish(21, { bodies: [{ name: 'd', key: 3, node: body(), placement: UNMOVED, cells: 96 }] });
    say({ type: 'stop', id: 22 });
    wish(23);
    await whole(23);
    expect(of(21, 'band')).toEqual([]);
  });

  test('refuses a tree without a field, in words', async () => {
    const bad = {
      type: 'skels',
      kernel: 'nobody',
      params: {},
      threshold: 1,
      skels: [],
    } as unknown as FieldNode;
    wish(31, { bodies: [{ name: 'e', key: 4, node: bad, placement: UNMOVED, cells: 24 }] });
    await vi.waitFor(() => expect(of(31, 'refused')[0]?.message).toMatch(/nobody/));
    wish(32);
    await whole(32);
  });

  test('shows nothing where nothing is in the picture', async () => {
    wish(41, {
      camera: { view: { ...VIEW, pivot: [500, 0, 0] }, width: WIDTH, height: HEIGHT, offset: [0.5, 0.5] },
    });
    await whole(41);
    for (const { surface, places } of of(41, 'band')) {
      expect(surface).toBeNull();
      expect(places.length).toBe(0);
    }
  });
});
