/**
 * Casts rays onto bodies beside the page, as one of several (element/rayWorker.ts): it hears of a picture, locates its bodies, and casts the
 * parts of it that it is given, bands of rows and pixels at edges. The latest picture wins.
 *
 * Each worker locates for itself, and keeps what it located (locatedBodies.ts): lists of objects cannot be shared, and it is 3 % of the
 * work of rays onto the whale.
 */
import type { AgainJob, Band, BandJob, Cast, FromExact, Pixels, ToExact } from '../field/exactWork.ts';
import { edgesOf, OFFSETS } from '../field/rayEdges.ts';
import { emptyImage, type OwnImage, SceneCaster, type Standing } from '../field/rayScene.ts';
import { LocatedBodies } from './locatedBodies.ts';
import { sliced } from './sliced.ts';

/** What this file needs of the scope of a worker, whose types cannot be there beside those of a page. */
interface Scope {
  onmessage: ((event: MessageEvent<ToExact>) => void) | null;
  postMessage(message: FromExact, transfer: readonly ArrayBufferLike[]): void;
}

/** A picture whose bodies are located. */
interface Picture {
  readonly cast: Cast;
  readonly bodies: readonly Standing[];
  /** by the place of their rays in the pixels: among OFFSETS, or MIDDLE */
  readonly casters: Map<number, SceneCaster>;
}

const MIDDLE = -1;
/** pixels between two looks at the clock */
const BATCH = 64;

const scope = self as unknown as Scope;
let wish: Cast | null = null;
let jobs: (BandJob | AgainJob)[] = [];
let latest = 0;
let working = false;
let picture: Picture | null = null;
const kept = new LocatedBodies();

scope.onmessage = ({ data }) => {
  latest = data.id;
  if (data.type === 'band' || data.type === 'again') jobs.push(data);
  else {
    wish = data.type === 'cast' ? data : null;
    jobs = [];
    picture = null;
  }
  if (!working) void work();
};
say({ type: 'begun', id: 0 });

async function work(): Promise<void> {
  working = true;
  while (wish || jobs.length > 0) {
    const { id } = (wish ?? jobs[0])!;
    try {
      if (wish) await begin(wish);
      else await cast(jobs.shift()!);
    } catch (error) {
      say({ type: 'refused', id, message: error instanceof Error ? error.message : String(error) });
    }
  }
  working = false;
}

async function begin(asked: Cast): Promise<void> {
  wish = null;
  const bodies: Standing[] = [];
  const { id, bodies: all } = asked;
  for (const [i, body] of all.entries()) {
    const isEdit = kept.isEdit(body);
    // also for another picture
    const wanted = () =>
      isEdit || id === latest || (wish?.bodies.some(({ key }) => key === body.key) ?? false);
    const progress = (share: number) => say({ type: 'locating', id, share: (i + share) / all.length });
    const located = await sliced(kept.locating(body), wanted, progress);
    if (!located) return;
    bodies.push({ located, placement: body.placement });
    if (id !== latest) return;
  }
  kept.trim(all.map(({ name }) => name));
  picture = { cast: asked, bodies, casters: new Map() };
}

/** What is not of the picture at hand was given up, or refused. */
async function cast(job: BandJob | AgainJob): Promise<void> {
  if (picture?.cast.id !== job.id) return;
  const wanted = () => job.id === latest;
  if (job.type === 'band') await band(job, picture, wanted);
  else await again(job, picture, wanted);
}

async function band({ id, from, to }: BandJob, { cast, bodies, ...all }: Picture, wanted: () => boolean) {
  const before = workOf(bodies);
  const image = await sliced(rowsOf(casterOf({ cast, bodies, ...all }, MIDDLE), cast, from, to), wanted);
  if (!image) return;
  const { width, offset } = cast.camera;
  // rows are counted from the first of these
  const places = edgesOf(image, { ...cast.camera, offset: [offset[0], offset[1] + from] });
  for (let i = 0; i < places.length; i++) places[i]! += from * width;
  const facts = { type: 'band', id, from, to, places, work: workOf(bodies) - before } as const;
  hand<Band>({ ...facts, ...arraysOf(image) });
}

function* rowsOf(
  caster: SceneCaster,
  { camera }: Cast,
  from: number,
  to: number,
): Generator<number, OwnImage> {
  const image = emptyImage({ width: camera.width, height: to - from });
  for (let row = from; row < to; row++) {
    caster.row(image, row, row - from);
    yield (row + 1 - from) / (to - from);
  }
  return image;
}

async function again({ id, offset, first, places }: AgainJob, of: Picture, wanted: () => boolean) {
  const image = await sliced(pixelsOf(casterOf(of, offset), of.cast, places), wanted);
  if (image) hand({ type: 'again', id, offset, first, count: places.length, ...arraysOf(image) });
}

function* pixelsOf(caster: SceneCaster, { camera }: Cast, places: Uint32Array): Generator<number, OwnImage> {
  const image = emptyImage({ width: places.length, height: 1 });
  for (const [i, at] of places.entries()) {
    caster.pixel(image, i, at % camera.width, Math.floor(at / camera.width));
    if (i % BATCH === 0) yield i / places.length;
  }
  return image;
}

function casterOf({ cast, bodies, casters }: Picture, place: number): SceneCaster {
  const offset = OFFSETS[place] ?? cast.camera.offset;
  const caster = casters.get(place) ?? new SceneCaster(bodies, { ...cast.camera, offset });
  casters.set(place, caster);
  return caster;
}

const workOf = (bodies: readonly Standing[]): number =>
  [...new Set(bodies.map(({ located }) => located.tally))].reduce((sum, { work }) => sum + work, 0);

/** None where all of it is empty. */
function arraysOf({ surface, colours }: OwnImage): Pick<Pixels, 'surface' | 'colours'> {
  return colours.some((value) => value !== 0) ? { surface, colours } : { surface: null, colours: null };
}

function hand<T extends FromExact & Pixels>(message: T): void {
  const { surface, colours } = message;
  scope.postMessage(message, surface && colours ? [surface.buffer, colours.buffer] : []);
}

function say(message: FromExact): void {
  scope.postMessage(message, []);
}
