/**
 * What rays have found so far for one picture: kept on the page, so that another style or colour casts none anew. Bands and rays at edges come
 * from several workers in any order.
 */
import type { Again, Band, Pixels } from '../field/exactWork.ts';
import { edgesOf, imageThrough, OFFSETS } from '../field/rayEdges.ts';
import type { RayCamera } from '../field/rayImage.ts';
import { emptyImage, type OwnImage } from '../field/rayScene.ts';
import type { SurfaceImage } from '../scene/index.ts';
import type { CastImages } from './caster.ts';
import { BAND, type Job } from './rayJobs.ts';

/** of the time until the first image is there, the first time; later less */
const LOCATING = 0.1;

/** Of a band. */
const [THERE, LOST] = [1, 2] as const;

type LostAgain = Pick<Again, 'type' | 'offset' | 'first' | 'count'>;

export class ExactImages implements CastImages {
  readonly whole = 1 + OFFSETS.length;
  milliseconds = 0;
  readonly #camera: RayCamera;
  /** ids of the items */
  readonly #items: readonly string[];
  readonly #base: OwnImage;
  readonly #since = performance.now();
  #located = 0;
  #work = 0;
  /** bands: THERE, LOST or neither */
  readonly #there: Uint8Array;
  /** from the first band that is lost to below the last */
  #lost: readonly [from: number, to: number] | null = null;
  #missing: number;
  /** pixels at edges, in the order in which they were found */
  readonly #places: number[] = [];
  readonly #isEdge: Uint8Array;
  readonly #agains: readonly (Again | LostAgain)[][] = OFFSETS.map(() => []);

  constructor(camera: RayCamera, items: readonly string[]) {
    const { width, height } = camera;
    this.#camera = camera;
    this.#items = items;
    this.#base = emptyImage(camera);
    this.#there = new Uint8Array(Math.ceil(height / BAND));
    this.#missing = this.#there.length;
    this.#isEdge = new Uint8Array(width * height);
  }

  /** Pixels at edges that are known. */
  get places(): number {
    return this.#places.length;
  }

  placesOf(first: number, count: number): Uint32Array<ArrayBuffer> {
    return Uint32Array.from(this.#places.slice(first, first + count));
  }

  /** How much is known of the bodies, as somebody who looks for them says. */
  located(share: number): void {
    this.#located = Math.min(Math.max(share, this.#located), 1);
  }

  hear(said: Band | Again): void {
    if (said.type === 'band') this.#put(said);
    else this.#agains[said.offset]!.push(said);
  }

  /** Nobody will do it. */
  lose(job: Job): void {
    if (job.type === 'again') {
      this.#agains[job.offset]!.push(job);
      return;
    }
    const band = Math.floor(job.from / BAND);
    const [from, to] = this.#lost ?? [band, band + 1];
    this.#lost = [Math.min(from, band), Math.max(to, band + 1)];
    this.#done(band, LOST);
  }

  get count(): number {
    if (this.#missing > 0) return 0;
    const missing = this.#agains.findIndex((agains) => sumOf(agains) < this.#places.length);
    return missing < 0 ? this.whole : 1 + missing;
  }

  get evaluationsAPixel(): number | null {
    return this.#missing > 0 ? null : this.#work / (this.#camera.width * this.#camera.height);
  }

  /** Bodies are looked for, then rows cast. */
  get share(): number {
    return LOCATING * this.#located + (1 - LOCATING) * (1 - this.#missing / this.#there.length);
  }

  get known(): readonly [from: number, to: number] {
    const bands = this.#there.length;
    let [from, to] = [Math.floor(bands / 2), Math.floor(bands / 2)];
    while (from > 0 && this.#there[from - 1] !== 0) from--;
    while (to < bands && this.#there[to] !== 0) to++;
    return [this.#height(from), this.#height(to)];
  }

  /** There is nothing of it, and will be nothing. */
  get isLost(): boolean {
    return this.#there.every((state) => state === LOST);
  }

  get lost(): readonly [from: number, to: number] | null {
    return this.#lost && [this.#height(this.#lost[0]), this.#height(this.#lost[1])];
  }

  /** Of the upper border of a band, 0–1 from the top. */
  #height(band: number): number {
    return Math.min((band * BAND) / this.#camera.height, 1);
  }

  image(number: number): SurfaceImage {
    const [camera, items, lost] = [this.#camera, this.#items, this.lost];
    const offset = OFFSETS[number - 1];
    if (!offset) return { camera, items, lost, ...arraysOf(this.#base) };
    const again = emptyImage({ width: this.#places.length, height: 1 });
    const places = this.placesOf(0, this.#places.length);
    for (const said of this.#agains[number - 1]!) {
      if ('surface' in said) putAt(again, said.first, said);
      else this.#putMiddle(again, said);
    }
    const image = imageThrough(this.#base, camera, places, { offset, ...again });
    return { camera: { ...camera, offset }, items, lost, ...arraysOf(image) };
  }

  /** What rays through the middle have met. */
  #putMiddle(again: OwnImage, { first, count }: LostAgain): void {
    const { surface, colours } = this.#base;
    for (let i = first; i < first + count; i++) {
      const part = [4 * this.#places[i]!, 4 * this.#places[i]! + 4] as const;
      putAt(again, i, { surface: surface.slice(...part), colours: colours.slice(...part) });
    }
  }

  #put(said: Band): void {
    const { from, to, places, work } = said;
    const band = Math.floor(from / BAND);
    if (this.#there[band] !== 0) return;
    this.#work += work;
    putAt(this.#base, from * this.#camera.width, said);
    this.#add(places);
    if (this.#there[band - 1] === THERE) this.#add(this.#seam(from));
    if (this.#there[band + 1] === THERE) this.#add(this.#seam(to));
    this.#done(band, THERE);
  }

  #done(band: number, state: typeof THERE | typeof LOST): void {
    this.#there[band] = state;
    if (--this.#missing === 0) this.milliseconds = performance.now() - this.#since;
  }

  #add(places: Iterable<number>): void {
    for (const at of places) {
      if (this.#isEdge[at] === 1) continue;
      this.#isEdge[at] = 1;
      this.#places.push(at);
    }
  }

  /** Edges in the rows above and below the border between two bands, which neither band can tell. */
  *#seam(row: number): Generator<number> {
    const { width, height, offset } = this.#camera;
    const [from, to] = [Math.max(row - 2, 0), Math.min(row + 2, height)];
    const part = [4 * from * width, 4 * to * width] as const;
    const { surface, colours } = this.#base;
    const strip = {
      width,
      height: to - from,
      surface: surface.subarray(...part),
      colours: colours.subarray(...part),
    };
    const camera: RayCamera = { ...this.#camera, offset: [offset[0], offset[1] + from] };
    for (const at of edgesOf(strip, camera)) {
      const place = at + from * width;
      const y = Math.floor(place / width);
      if (y === row - 1 || y === row) yield place;
    }
  }
}

const sumOf = (agains: readonly Pick<Again, 'count'>[]): number =>
  agains.reduce((sum, { count }) => sum + count, 0);

const arraysOf = ({ surface, colours }: Pick<SurfaceImage, 'surface' | 'colours'>) => ({ surface, colours });

/** From a pixel on. */
function putAt(
  image: OwnImage,
  pixel: number,
  { surface, colours }: Pick<Pixels, 'surface' | 'colours'>,
): void {
  if (!surface || !colours) return;
  image.surface.set(surface, 4 * pixel);
  image.colours.set(colours, 4 * pixel);
}
