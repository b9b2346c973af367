/** Several workers that share a picture: it is what one would have cast, whoever does what when, and whoever is lost on the way. */
import { describe, expect, it } from 'vitest';
import type { CastImages, ShownBody } from '../../src/element/caster.ts';
import { type Castable, RayWorker } from '../../src/element/rayWorker.ts';
import { bindField } from '../../src/field/bind.ts';
import type { Again, AgainJob, Band, BandJob, FromExact, ToExact } from '../../src/field/exactWork.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { locating } from '../../src/field/polygonize.ts';
import { edgesOf, imageThrough, OFFSETS } from '../../src/field/rayEdges.ts';
import type { RayCamera } from '../../src/field/rayImage.ts';
import { emptyImage, type OwnImage, SceneCaster } from '../../src/field/rayScene.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import type { SurfaceImage } from '../../src/scene/index.ts';
import { finished } from '../field/finished.ts';
import { random } from '../fixtures/random.ts';

const NODE: FieldNode = {
  type: 'union',
  form: 'hard',
  parts: [
    { type: 'shape', shape: { type: 'torus', ring: 20, tube: 6 }, colour: [0.8, 0.1, 0.1] },
    { type: 'shape', shape: { type: 'box', half: [8, 8, 12] }, colour: [0.1, 0.1, 0.8] },
  ],
};
const CAMERA: RayCamera = {
  view: { pivot: [0, 0, 0], rotation: [0.3, 0.2, 0, Math.sqrt(0.87)], height: 70, fov: 40 },
  width: 90,
  height: 70,
  offset: [0.5, 0.5],
};
const BODIES: readonly ShownBody[] = [{ id: 'ring', node: NODE, placement: UNMOVED, cells: 48 }];
const STANDING = [{ located: finished(locating(bindField(NODE), 48)), placement: UNMOVED }];
/** All rays through one place of the pixels. */
function image(offset: RayCamera['offset']): OwnImage {
  const all = emptyImage(CAMERA);
  const caster = new SceneCaster(STANDING, { ...CAMERA, offset });
  for (let y = 0; y < CAMERA.height; y++) caster.row(all, y);
  return all;
}
const BASE = image(CAMERA.offset);
const OTHERS = OFFSETS.map(image);

/** Casts when it is told to. */
class FakeWorker implements Castable {
  onmessage: Castable['onmessage'] = null;
  onerror: Castable['onerror'] = null;
  todo: (BandJob | AgainJob)[] = [];
  latest = 0;
  casts = 0;
  stops = 0;
  ended = false;
  postMessage(message: ToExact): void {
    if (message.type === 'band' || message.type === 'again') this.todo.push(message);
    else {
      this.latest = message.id;
      this.todo = [];
      if (message.type === 'cast') this.casts++;
      else this.stops++;
    }
  }
  terminate(): void {
    this.ended = true;
  }
  say(message: FromExact): void {
    this.onmessage?.call({} as Worker, { data: message } as MessageEvent<FromExact>);
  }
  begin(): void {
    this.say({ type: 'begun', id: 0 });
  }
  fail(message = 'out of memory'): void {
    this.onerror?.call({} as Worker, { message } as ErrorEvent);
  }
  step(): void {
    const job = this.todo.shift();
    if (job) this.say(job.type === 'band' ? band(job) : again(job));
  }
}

function band({ from, to, ...job }: BandJob): Band {
  const { width } = CAMERA;
  const [surface, colours] = [BASE.surface, BASE.colours].map((all) =>
    all.slice(4 * from * width, 4 * to * width),
  );
  const passed = BASE.passed.slice(from * width, to * width);
  const image = { width, height: to - from, surface: surface!, colours: colours!, passed };
  const places = edgesOf(image, { ...CAMERA, offset: [0.5, 0.5 + from] }).map((at) => at + from * width);
  return { ...job, from, to, places, work: 10, surface: image.surface, colours: image.colours };
}

/** Of these pixels. */
function recast(offset: number, places: Uint32Array): OwnImage {
  const image = emptyImage({ width: places.length, height: 1 });
  const { surface, colours } = OTHERS[offset]!;
  for (const [i, at] of places.entries()) {
    image.surface.set(surface.subarray(4 * at, 4 * at + 4), 4 * i);
    image.colours.set(colours.subarray(4 * at, 4 * at + 4), 4 * i);
  }
  return image;
}

function again({ places, ...job }: AgainJob): Again {
  const { surface, colours } = recast(job.offset, places);
  return { ...job, count: places.length, surface, colours };
}

interface Pool {
  readonly workers: FakeWorker[];
  readonly caster: RayWorker;
  readonly refused: string[];
  cast(): CastImages;
}

function pool(count: number): Pool {
  const workers: FakeWorker[] = [];
  const refused: string[] = [];
  const caster = new RayWorker(() => {
    workers.push(new FakeWorker());
    return workers.at(-1)!;
  }, count);
  const listener = { changed: () => {}, refused: (why: string) => void refused.push(why) };
  return { workers, caster, refused, cast: () => caster.cast(BODIES, CAMERA, listener) };
}

/** One of those that have something to do answers, until nobody has. */
function run(workers: readonly FakeWorker[], next: () => number, before: (step: number) => void = () => {}) {
  for (let step = 0; ; step++) {
    before(step);
    const busy = workers.filter(({ todo, ended }) => !ended && todo.length > 0);
    if (busy.length === 0) return;
    busy[Math.floor(next() * busy.length)]!.step();
  }
}

const differing = (a: SurfaceImage['surface'], b: Float32Array): number =>
  a instanceof Float32Array && a.length === b.length
    ? b.filter((value, i) => value !== a[i]).length
    : Number.NaN;

function expectWhole(images: CastImages): void {
  expect(images.count).toBe(images.whole);
  expect(images.known).toEqual([0, 1]);
  const places = edgesOf(BASE, CAMERA);
  for (const [i, offset] of [null, ...OFFSETS].entries()) {
    const expected = offset ? imageThrough(BASE, CAMERA, places, { offset, ...recast(i - 1, places) }) : BASE;
    const { surface, colours, items } = images.image(i);
    expect(items).toEqual(['ring']);
    expect(differing(surface, expected.surface)).toBe(0);
    expect(differing(colours, expected.colours)).toBe(0);
  }
}

describe('workers that share a picture', () => {
  it.each([
    [1, 1],
    [2, 2],
    [3, 3],
    [8, 4],
  ])('%d of them cast what one does, in any order, seed %d', (count, seed) => {
    const { workers, cast } = pool(count);
    const images = cast();
    expect(workers.length).toBe(count);
    let known = 0;
    run(workers, random(seed), () => {
      const [from, to] = images.known;
      expect(to - from).toBeGreaterThanOrEqual(known);
      known = to - from;
    });
    expectWhole(images);
    expect(images.evaluationsAPixel).toBeCloseTo((10 * Math.ceil(70 / 16)) / (90 * 70), 9);
  });

  it.each([1, 2, 3])('what a lost worker had in hand others do, seed %d', (seed) => {
    const { workers, cast, refused } = pool(4);
    const next = random(seed);
    const images = cast();
    run(workers, next, (step) => {
      const worker = workers[step];
      if (step < 3 && worker) {
        worker.fail();
        expect(worker.ended).toBe(true);
      }
    });
    expectWhole(images);
    expect(refused).toEqual([]);
    // the next picture has as many as before
    cast();
    expect(workers.filter(({ ended }) => !ended).length).toBe(4);
  });

  it.each([
    [1, 'band', 1],
    [2, 'band', 2],
    [4, 'band', 3],
    [1, 'again', 4],
    [3, 'again', 5],
  ] as const)(
    '%d workers: of a job that kills the others are done, and no third dies of it: %s, seed %d',
    (count, type, seed) => {
      const { workers, cast, refused } = pool(count);
      const next = random(seed);
      const images = cast();
      const isDeadly = (job: BandJob | AgainJob | undefined) =>
        job?.type === type && (job.type === 'band' ? job.from === 16 : job.offset === 1 && job.first === 0);
      let deaths = 0;
      for (;;) {
        const busy = workers.filter(({ todo, ended }) => !ended && todo.length > 0);
        const worker = busy[Math.floor(next() * busy.length)];
        if (!worker) break;
        worker.begin();
        if (isDeadly(worker.todo[0])) {
          deaths++;
          worker.fail();
        } else worker.step();
      }
      expect(deaths).toBe(2);
      expect(refused).toEqual([]);
      expect(images.count).toBe(images.whole);
      expect(images.known).toEqual([0, 1]);
      const [from, to] = type === 'band' ? [16 / 70, 32 / 70] : [0, 0];
      expect(images.lost ?? [0, 0]).toEqual([from, to]);
      for (let i = 0; i < images.whole; i++) {
        const { surface, lost } = images.image(i);
        expect(lost).toEqual(images.lost);
        const all = i === 0 ? BASE : OTHERS[i - 1]!;
        let other = 0;
        for (let at = 0; at < CAMERA.width * CAMERA.height; at++) {
          const row = Math.floor(at / CAMERA.width) / CAMERA.height;
          if (row >= from && row < to) continue;
          // where this place of the pixels and their middle meet something else
          const met = (surface as Float32Array)[4 * at + 3]! > -1e9;
          if (met !== all.surface[4 * at + 3]! > -1e9) other++;
        }
        // but for the edges that nobody could cast
        if (i === 2 && type === 'again') expect(other).toBeGreaterThan(0);
        else expect(other).toBe(0);
      }
    },
  );

  it('gives a picture up whose jobs all kill', () => {
    const { workers, cast, refused } = pool(2);
    cast();
    for (let step = 0; step < 50; step++) {
      const worker = workers.find(({ todo, ended }) => !ended && todo.length > 0);
      worker?.begin();
      worker?.fail();
    }
    expect(refused).toEqual(['out of memory']);
    expect(workers.length).toBeLessThan(9);
  });

  it('tries no more workers after three pictures for which they did not start, until all have rested', () => {
    const { workers, cast, refused, caster } = pool(2);
    for (let picture = 1; picture < 6; picture++) {
      cast();
      for (const worker of workers.filter(({ ended }) => !ended)) worker.fail('no file');
      expect(workers.length).toBe(Math.min(2 * picture, 6));
      expect(refused).toEqual(Array(picture).fill('no file'));
    }
    caster.idle();
    const images = cast();
    expect(workers.length).toBe(8);
    run(workers, random(1));
    expectWhole(images);
  });

  it('goes on trying after pictures that killed all who did start', () => {
    const { workers, cast, refused } = pool(2);
    for (let picture = 1; picture < 6; picture++) {
      cast();
      for (let step = 0; step < 50; step++) {
        const worker = workers.find(({ todo, ended }) => !ended && todo.length > 0);
        worker?.begin();
        worker?.fail();
      }
      expect(refused).toEqual(Array(picture).fill('out of memory'));
    }
    const images = cast();
    run(workers, random(1));
    expectWhole(images);
  });

  it('counts those that did not start in a row, not those before one did', () => {
    const { workers, cast } = pool(1);
    for (let picture = 0; picture < 5; picture++) {
      cast();
      workers.at(-1)!.fail('no file');
      cast();
      workers.at(-1)!.begin();
      workers.at(-1)!.fail();
      workers.at(-1)!.begin();
    }
    const images = cast();
    run(workers, random(1));
    expectWhole(images);
  });

  it('tells once when all are lost, or one refuses, and can go on', () => {
    const { workers, cast, refused } = pool(3);
    cast();
    for (const worker of workers) worker.fail('no room');
    expect(refused).toEqual(['no room']);
    const images = cast();
    const [a, b, c] = workers.slice(3);
    a!.say({ type: 'refused', id: a!.latest, message: 'no field' });
    b!.say({ type: 'refused', id: a!.latest - 1, message: 'no field' });
    expect(refused).toEqual(['no room', 'no field']);
    expect([a!.stops, b!.stops, c!.stops]).toEqual([1, 1, 1]);
    expect(images.count).toBe(0);
    const later = cast();
    run(workers, random(1));
    expectWhole(later);
    expect(workers.length).toBe(6);
  });

  it('goes on with those that start, and refuses where none does', () => {
    const started: FakeWorker[] = [];
    const refused: string[] = [];
    const listener = { changed: () => {}, refused: (why: string) => void refused.push(why) };
    const limited = (most: number) =>
      new RayWorker(() => {
        if (started.length >= most) throw new Error('no more');
        started.push(new FakeWorker());
        return started.at(-1)!;
      }, 4);
    const images = limited(2).cast(BODIES, CAMERA, listener);
    run(started, random(1));
    expectWhole(images);
    limited(2).cast(BODIES, CAMERA, listener);
    expect(refused).toEqual(['no more']);
  });

  it('hears nothing more of what was given up', () => {
    const { workers, caster, cast } = pool(2);
    const first = cast();
    const [late] = workers[0]!.todo as [BandJob];
    const second = cast();
    workers[0]!.say(band(late));
    expect(first.known).toEqual(second.known);
    expect(second.share).toBe(0);
    run(workers, random(1));
    expectWhole(second);
    expect(first.count).toBe(0);
    cast();
    caster.end();
    expect(workers.every(({ ended }) => ended)).toBe(true);
  });
});
