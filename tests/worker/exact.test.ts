/** The worker that casts rays as its page hears it: rows, edges, rays at edges; the latest wish wins; what was located is kept. */
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

const wish = (id: number, more: Partial<Cast> = {}) =>
  say({
    type: 'cast',
    id,
    bodies: [{ key: 1, node: sphere, placement: UNMOVED, cells: 24 }],
    camera: { view: VIEW, width: WIDTH, height: HEIGHT, offset: [0.5, 0.5] },
    ...more,
  });
const of = <T extends FromExact['type']>(id: number, type: T) =>
  heard.filter(
    (message): message is Extract<FromExact, { type: T }> => message.id === id && message.type === type,
  );
const whole = (id: number) => vi.waitFor(() => expect(of(id, 'again').length).toBe(OFFSETS.length), 15_000);

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
    let end = 0;
    for (const { from, to, surface, colours } of of(1, 'rows')) {
      expect(from).toBeGreaterThanOrEqual(end);
      end = to;
      image.surface.set(surface, 4 * from * WIDTH);
      image.colours.set(colours, 4 * from * WIDTH);
    }
    for (let at = 0; at < WIDTH * HEIGHT; at++) {
      const [x, y] = [(at % WIDTH) + 0.5 - WIDTH / 2, Math.floor(at / WIDTH) + 0.5 - HEIGHT / 2];
      const depth = Math.sqrt(100 - x * x - y * y);
      expect(image.colours[4 * at + 3]).toBe(depth > 0 ? 1 : 0);
      if (depth > 0) expect(image.surface[4 * at + 3]).toBeCloseTo(depth, 3);
    }
    const [edges] = of(1, 'edges');
    expect(edges!.evaluationsAPixel).toBeGreaterThan(0.2);
    // around a circle of ten pixels' radius
    expect(edges!.places.length).toBeGreaterThan(50);
    expect(edges!.places.length).toBeLessThan(200);
    for (const { recast } of of(1, 'again')) expect(recast.surface.length).toBe(4 * edges!.places.length);
    const offsets = of(1, 'again').map(({ recast }) => recast.offset);
    expect(offsets).toEqual(OFFSETS);
  });

  test('looks for a body once, however often it is looked at', async () => {
    const blob = body();
    const bodies = [{ key: 2, node: blob, placement: UNMOVED, cells: 64 }];
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
      evaluations.push(of(id, 'edges')[0]!.evaluationsAPixel);
    }
    expect(of(12, 'locating')).toEqual([]);
    expect(of(13, 'locating')).toEqual([]);
    expect(evaluations[2]).toBeCloseTo(evaluations[0]!, 9);
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
    wish(id, { bodies: [{ key: 5, node: sphere, placement: UNMOVED, cells: 48 }] });
    await vi.waitFor(() => {
      if (id < first + 10 && of(id, 'again').length === OFFSETS.length) wish(++id);
      expect(of(first + 10, 'again').length).toBe(OFFSETS.length);
    }, 15_000);
    expect(late).toEqual([]);
  });

  test('stops when told to, and goes on afterwards', async () => {
    wish(21, { bodies: [{ key: 3, node: body(), placement: UNMOVED, cells: 96 }] });
    say({ type: 'stop', id: 22 });
    wish(23);
    await whole(23);
    expect(of(21, 'edges')).toEqual([]);
  });

  test('refuses a tree without a field, in words', async () => {
    const bad = {
      type: 'skels',
      kernel: 'nobody',
      params: {},
      threshold: 1,
      skels: [],
    } as unknown as FieldNode;
    wish(31, { bodies: [{ key: 4, node: bad, placement: UNMOVED, cells: 24 }] });
    await vi.waitFor(() => expect(of(31, 'refused')[0]?.message).toMatch(/nobody/));
    wish(32);
    await whole(32);
  });

  test('shows nothing where nothing is in the picture', async () => {
    wish(41, {
      camera: { view: { ...VIEW, pivot: [500, 0, 0] }, width: WIDTH, height: HEIGHT, offset: [0.5, 0.5] },
    });
    await whole(41);
    expect(of(41, 'rows')).toEqual([]);
    expect(of(41, 'edges')[0]!.places.length).toBe(0);
  });
});
