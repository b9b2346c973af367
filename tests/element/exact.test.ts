/** The exact surface on the screen: cast where all rests, given up at any change, drawn image by image; pictures take turns. */
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { apply } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { FRONT_VIEW } from '../../src/document/drawing.ts';
import type { Caster, CastImages, CastListener } from '../../src/element/caster.ts';
import { Exact, type Seen, shownBodies } from '../../src/element/exact.ts';
import { type Castable, RayWorker } from '../../src/element/rayWorker.ts';
import type { Again, AgainJob, Band, BandJob, Cast, FromExact, ToExact } from '../../src/field/exactWork.ts';
import { OFFSETS } from '../../src/field/rayEdges.ts';
import type { RayCamera } from '../../src/field/rayImage.ts';
import type { Scene, SurfaceImage } from '../../src/scene/index.ts';

/** three bands */
const PIXELS = { width: 20, height: 40 };
const DOCUMENT: Document = apply(EMPTY_DOCUMENT, {
  type: 'addBody',
  name: 'Ball',
  node: { type: 'shape', shape: { type: 'sphere', radius: 5 } },
});

const BODIES = shownBodies(DOCUMENT);

class FakeWorker implements Castable {
  onmessage: Castable['onmessage'] = null;
  onerror: Castable['onerror'] = null;
  readonly asked: ToExact[] = [];
  ended = false;
  postMessage(message: ToExact): void {
    this.asked.push(message);
  }
  terminate(): void {
    this.ended = true;
  }
  get casts(): number {
    return this.asked.filter(({ type }) => type === 'cast').length;
  }
  get last(): Cast {
    return this.asked.filter((message) => message.type === 'cast').at(-1)!;
  }
  say(message: FromExact): void {
    this.onmessage?.call({} as Worker, { data: message } as MessageEvent<FromExact>);
  }
  /** Answers that many of the jobs in hand; there is one pixel at an edge in each band. */
  answer(count = Infinity): void {
    const { id, camera } = this.last;
    for (let i = 0; i < count; i++) {
      const job = this.asked[this.#answered++];
      if (!job) {
        this.#answered = this.asked.length;
        return;
      }
      if (job.type === 'cast' || job.type === 'stop' || job.id !== id) i--;
      else this.say(job.type === 'band' ? bandOf(job, camera.width) : againOf(job));
    }
  }
  #answered = 0;
}

/** All images at once, which count as long as nobody gave them back. */
class DroppedCaster implements Caster {
  left = 0;
  casts = 0;
  cast(_bodies: unknown, camera: RayCamera, listener: CastListener): CastImages {
    this.casts++;
    if (this.isSmall && this.left > 0) expect(listener.spare?.()).toBe(true);
    this.left++;
    queueMicrotask(() => listener.changed());
    const image = { camera, items: [] } as unknown as SurfaceImage;
    return {
      ...{ count: 5, whole: 5, known: [0, 1], share: 1, evaluationsAPixel: 1, milliseconds: 1 },
      lost: this.lost,
      image: () => image,
      drop: () => void this.left--,
    };
  }
  lost: readonly [from: number, to: number] | null = null;
  /** it has room for one picture */
  isSmall = false;
  lives = 0;
  live(): SurfaceImage | null {
    this.lives++;
    return { camera: {}, items: [] } as unknown as SurfaceImage;
  }
  idles = 0;
  idle(): void {
    this.idles++;
  }
  stop(): void {}
  end(): void {}
}

/** Two images, then as many as the test says. */
class TakenOver implements Caster {
  readonly images = {
    ...{ count: 2, whole: 5, known: [0, 0] as const, share: 0.5, evaluationsAPixel: 1, milliseconds: 1 },
    image: () => ({ camera: {}, items: [] }) as unknown as SurfaceImage,
  };
  cast(): CastImages {
    return this.images;
  }
  stop(): void {}
  end(): void {}
}

const NONE = { surface: null, colours: null };
/** values of one skel that a band takes */
const WORK = 90;
const bandOf = ({ id, from, to }: BandJob, width: number): Band => ({
  ...{ type: 'band', id, from, to, work: WORK, ...NONE },
  places: Uint32Array.of(from * width + 3),
});
const againOf = ({ places, ...job }: AgainJob): Again => ({ ...job, ...NONE, count: places.length });

let worker: FakeWorker;
let exact: Exact;
let wakes: number;
let drawn: SurfaceImage[];
let refined: number | null;
const scene = {
  pixels: PIXELS,
  get refined() {
    return refined;
  },
  refine(image: SurfaceImage, { known = [0, 1] } = {}) {
    drawn.push(image);
    if (known[0] === 0 && known[1] === 1 && refined !== null) refined++;
    return true;
  },
} as unknown as Scene;
const seen = (more: Partial<Seen> = {}): Seen => ({
  scene,
  bodies: BODIES,
  view: FRONT_VIEW,
  version: 1,
  ...more,
});

/** Until all rests and rays are being cast. */
function rested(of = seen()): void {
  expect(exact.frame(of)).toBe(false);
  vi.advanceTimersByTime(1000);
  exact.frame(of);
}

beforeEach(() => {
  vi.useFakeTimers();
  worker = new FakeWorker();
  wakes = 0;
  drawn = [];
  refined = 0;
  exact = new Exact(() => void wakes++, new RayWorker(() => worker, 1));
});
afterEach(() => void vi.useRealTimers());

describe('Exact', () => {
  it('casts when all rests, and no sooner', () => {
    for (let height = 100; height < 110; height++) {
      expect(exact.frame(seen({ view: { ...FRONT_VIEW, height } }))).toBe(false);
      vi.advanceTimersByTime(30);
    }
    expect(worker.asked).toEqual([]);
    vi.advanceTimersByTime(1000);
    expect(wakes).toBe(1);
    // the picture of meshes stays as it is
    expect(exact.frame(seen({ view: { ...FRONT_VIEW, height: 109 } }))).toBe(true);
    expect(worker.last.camera).toMatchObject({ ...PIXELS, view: { height: 109 } });
    expect(exact.share).toBe(0);
  });

  it('draws what is there of the first image, then every image once, and leaves the picture as it is', () => {
    rested();
    worker.answer(1);
    // few rows at a time would cost more than they show
    expect(exact.frame(seen())).toBe(true);
    expect(drawn).toEqual([]);
    vi.advanceTimersByTime(2000);
    for (let i = 0; i < 3; i++) expect(exact.frame(seen())).toBe(true);
    expect(drawn.length).toBe(1);
    worker.answer(2);
    expect(exact.frame(seen())).toBe(true);
    expect(exact.evaluationsAPixel).toBe((3 * WORK) / (20 * 40));
    worker.answer();
    for (let i = 0; i < 10; i++) expect(exact.frame(seen())).toBe(true);
    expect(exact.isWhole).toBe(true);
    const offsets = drawn.map(({ camera }) => camera.offset);
    expect(offsets).toEqual([[0.5, 0.5], [0.5, 0.5], ...OFFSETS]);
    expect(drawn[0]!.items).toEqual(DOCUMENT.parts.map(({ id }) => id));
  });

  it('begins anew with what it has when the frame is gone, as after another size', () => {
    rested();
    worker.answer();
    for (let i = 0; i < 10; i++) expect(exact.frame(seen())).toBe(true);
    refined = null;
    expect(exact.frame(seen())).toBe(false);
    refined = 0;
    drawn = [];
    vi.advanceTimersByTime(1000);
    for (let i = 0; i < 10; i++) expect(exact.frame(seen())).toBe(true);
    expect(drawn.length).toBe(1 + OFFSETS.length);
    expect(worker.casts).toBe(1);
  });

  it('casts nothing anew for another style, and all for another view', () => {
    rested();
    worker.answer();
    for (let i = 0; i < 10; i++) exact.frame(seen());
    drawn = [];
    const other = seen({ version: 2 });
    refined = 0;
    expect(exact.frame(other)).toBe(false);
    expect(exact.isWhole).toBe(false);
    vi.advanceTimersByTime(1000);
    for (let i = 0; i < 10; i++) exact.frame(other);
    expect(drawn.length).toBe(1 + OFFSETS.length);
    expect(worker.casts).toBe(1);
    rested(seen({ version: 2, view: { ...FRONT_VIEW, height: 50 } }));
    expect(worker.casts).toBe(2);
  });

  it('gives up at once what nobody waits for any more', () => {
    rested();
    const { id } = worker.last;
    exact.frame(seen({ view: { ...FRONT_VIEW, height: 50 } }));
    expect(worker.asked.at(-1)).toMatchObject({ type: 'stop' });
    worker.say(bandOf({ type: 'band', id, from: 16, to: 32 }, 20));
    expect(exact.evaluationsAPixel).toBeNull();
    expect(drawn).toEqual([]);
  });

  it('wants nothing where there is no body, and shows meshes where rays are refused', () => {
    expect(exact.frame(seen({ bodies: [] }))).toBe(false);
    vi.advanceTimersByTime(1000);
    expect(worker.asked).toEqual([]);
    rested();
    worker.say({ type: 'refused', id: worker.last.id, message: 'no field' });
    expect(exact.frame(seen())).toBe(false);
    expect(exact.problem).toBe('no field');
    expect(exact.isWhole).toBe(true);
  });

  it('gives pictures all images, one after the other, while the screen waits', async () => {
    rested();
    const draw = async (images: readonly (() => SurfaceImage)[]) => images.map((image) => image());
    const first = exact.picture(BODIES, FRONT_VIEW, { width: 8, height: 6 }, draw);
    const second = exact.picture(BODIES, FRONT_VIEW, { width: 6, height: 8 }, draw);
    await vi.waitFor(() => expect(worker.last.camera.width).toBe(8));
    expect(exact.frame(seen())).toBe(false);
    worker.answer();
    expect((await first).map(({ camera }) => camera.offset)).toEqual([[0.5, 0.5], ...OFFSETS]);
    await vi.waitFor(() => expect(worker.last.camera.width).toBe(6));
    worker.say({ type: 'refused', id: worker.last.id, message: 'no room' });
    await expect(second).rejects.toThrow('no room');
    rested();
    expect(worker.last.camera).toMatchObject(PIXELS);
    expect(await exact.picture([], FRONT_VIEW, PIXELS, draw)).toEqual([]);
  });

  it('keeps what is whole on the screen while a picture is made, which is of the same images where it shows the same', async () => {
    rested();
    worker.answer();
    for (let i = 0; i < 10; i++) exact.frame(seen());
    const { length } = await exact.picture(BODIES, FRONT_VIEW, PIXELS, async (images) => images);
    expect(length).toBe(1 + OFFSETS.length);
    expect(worker.casts).toBe(1);
    const other = exact.picture(BODIES, FRONT_VIEW, { width: 8, height: 6 }, async (images) => images);
    await vi.waitFor(() => expect(worker.casts).toBe(2));
    // as where somebody draws meanwhile
    exact.frame(seen({ version: 2 }));
    worker.answer();
    await other;
    expect(exact.frame(seen({ version: 2 }))).toBe(false);
    refined = 0;
    vi.advanceTimersByTime(1000);
    for (let i = 0; i < 10; i++) expect(exact.frame(seen({ version: 2 }))).toBe(true);
    expect(exact.isWhole).toBe(true);
    expect(worker.casts).toBe(2);
  });

  it('begins anew where others take a picture over of which some images were seen', () => {
    const caster = new TakenOver();
    exact = new Exact(() => {}, caster);
    rested();
    for (let i = 0; i < 3; i++) exact.frame(seen());
    expect(exact.evaluationsAPixel).toBe(1);
    caster.images.count = 0;
    expect(exact.frame(seen())).toBe(false);
    expect(exact.evaluationsAPixel).toBeNull();
    expect(exact.share).toBe(0.5);
    caster.images.count = 5;
    refined = 0;
    vi.advanceTimersByTime(1000);
    for (let i = 0; i < 10; i++) expect(exact.frame(seen())).toBe(true);
    expect(exact.isWhole).toBe(true);
  });

  it('gives images back when nobody shows them any more, and not before', async () => {
    const caster = new DroppedCaster();
    exact = new Exact(() => {}, caster);
    rested();
    for (let i = 0; i < 10; i++) exact.frame(seen());
    expect(caster.left).toBe(1);
    const lent = exact.picture(BODIES, FRONT_VIEW, PIXELS, async () => {
      exact.drop();
      expect(caster.left).toBe(1);
    });
    await lent;
    expect(caster.left).toBe(0);
    await exact.picture(BODIES, FRONT_VIEW, PIXELS, async () => expect(caster.left).toBe(1));
    expect(caster.left).toBe(0);
    expect(caster.casts).toBe(2);
  });

  it('gives what is on the screen back for a picture that has no room beside it, and casts it again', async () => {
    const caster = new DroppedCaster();
    caster.isSmall = true;
    exact = new Exact(() => {}, caster);
    rested();
    for (let i = 0; i < 10; i++) exact.frame(seen());
    const size = { width: 8, height: 6 };
    await exact.picture(BODIES, FRONT_VIEW, size, async () => expect(caster.left).toBe(1));
    expect([caster.left, caster.casts]).toEqual([0, 2]);
    // the mean of what was there is no longer of anything
    expect(exact.frame(seen())).toBe(false);
    refined = 0;
    vi.advanceTimersByTime(1000);
    for (let i = 0; i < 10; i++) exact.frame(seen());
    expect([caster.left, caster.casts, exact.isWhole]).toEqual([1, 3, true]);
  });

  it('keeps what is whole while nothing is wanted, and through pictures, of which the same is cast once', async () => {
    rested();
    worker.answer();
    for (let i = 0; i < 10; i++) exact.frame(seen());
    exact.rest();
    const { length } = await exact.picture(BODIES, FRONT_VIEW, PIXELS, async (images) => images);
    expect(length).toBe(1 + OFFSETS.length);
    expect(worker.casts).toBe(1);
    const other = exact.picture(BODIES, FRONT_VIEW, { width: 8, height: 6 }, async (images) => images);
    await vi.waitFor(() => expect(worker.casts).toBe(2));
    worker.answer();
    await other;
    [refined, drawn] = [0, []];
    rested();
    expect(exact.share).toBeNull();
    for (let i = 0; i < 10; i++) exact.frame(seen());
    expect(drawn.length).toBe(1 + OFFSETS.length);
    expect(drawn[0]!.camera).toMatchObject(PIXELS);
    expect(worker.casts).toBe(2);
    // not for ever, and not of what is another
    exact.rest();
    vi.advanceTimersByTime(100_000);
    rested();
    rested(seen({ view: { ...FRONT_VIEW, height: 50 } }));
    expect(worker.casts).toBe(4);
  });

  it('ends its worker, and what waits for it, with the element', async () => {
    rested();
    const waiting = exact.picture(BODIES, FRONT_VIEW, PIXELS, async () => {});
    await vi.waitFor(() => expect(worker.casts).toBe(2));
    exact.stop();
    await expect(waiting).rejects.toThrow('given up');
    expect(worker.ended).toBe(true);
  });

  it('ends its worker when nobody has wanted anything for long, and starts another', () => {
    rested();
    worker.answer();
    vi.advanceTimersByTime(100_000);
    // what is seen is kept
    expect(exact.frame(seen())).toBe(true);
    expect(worker.ended).toBe(false);
    exact.rest();
    vi.advanceTimersByTime(5000);
    rested();
    vi.advanceTimersByTime(100_000);
    expect(worker.ended).toBe(false);
    exact.rest();
    vi.advanceTimersByTime(100_000);
    expect(worker.ended).toBe(true);
    worker = new FakeWorker();
    rested();
    expect(worker.casts).toBe(1);
  });

  it('shows what it has as soon as the style is another, and casts nothing for it', () => {
    const caster = new DroppedCaster();
    exact = new Exact(() => {}, caster);
    rested();
    expect(exact.live(seen())).toBe(true);
    expect(caster.lives).toBe(0);
    exact.live(seen({ view: { ...FRONT_VIEW, height: 50 } }));
    expect(caster.lives).toBe(1);
  });

  it('shows no image alone that has lost rows, whatever is another', () => {
    const caster = new DroppedCaster();
    caster.lost = [0.2, 0.4];
    caster.live = () => null;
    exact = new Exact(() => {}, caster);
    rested();
    for (let i = 0; i < 10; i++) exact.frame(seen());
    expect(exact.isInPart).toBe(true);
    drawn = [];
    expect(exact.live(seen())).toBe(false);
    expect(drawn).toEqual([]);
  });

  it('makes no picture with lost rows, but casts what had some on the screen once more for it', async () => {
    const caster = new DroppedCaster();
    caster.lost = [0.2, 0.4];
    exact = new Exact(() => {}, caster);
    rested();
    for (let i = 0; i < 10; i++) exact.frame(seen());
    const draw = async () => 'drawn';
    await expect(exact.picture(BODIES, FRONT_VIEW, PIXELS, draw)).rejects.toThrow('no exact picture');
    expect([caster.casts, caster.left]).toEqual([2, 1]);
    caster.lost = null;
    expect(await exact.picture(BODIES, FRONT_VIEW, PIXELS, draw)).toBe('drawn');
  });

  it('is not idle as long as something moves', () => {
    const caster = new DroppedCaster();
    exact = new Exact(() => {}, caster);
    rested();
    for (let i = 0; i < 10; i++) exact.frame(seen());
    for (let i = 0; i < 10; i++) {
      exact.rest();
      expect(exact.live(seen({ view: { ...FRONT_VIEW, height: 50 } }))).toBe(true);
      vi.advanceTimersByTime(15_000);
    }
    expect(caster.idles).toBe(0);
    vi.advanceTimersByTime(100_000);
    expect(caster.idles).toBe(1);
  });

  it('has no more rays than can be paid for', () => {
    const large = { ...scene, pixels: { width: 7680, height: 4320 } } as unknown as Scene;
    rested(seen({ scene: large }));
    const { width, height } = worker.last.camera;
    expect(width * height).toBeLessThan(2.5e6);
    expect(width / height).toBeCloseTo(16 / 9, 2);
  });
});
