/**
 * Casts rays onto bodies beside the page: first one a pixel, row by row, then more at edges. The latest wish wins. What was located of a
 * body, its bricks and near lists, is kept for the next picture, so that turning the camera only casts rays.
 */
import { bindField } from '../field/bind.ts';
import type { Cast, ExactBody, FromExact, ToExact } from '../field/exactWork.ts';
import { type Located, locating } from '../field/polygonize.ts';
import { edgesOf, OFFSETS, type Recast } from '../field/rayEdges.ts';
import { emptyImage, type OwnImage, SceneCaster, type Standing } from '../field/rayScene.ts';
import { sliced } from './sliced.ts';

/** What this file needs of the scope of a worker, whose types cannot be there beside those of a page. */
interface Scope {
  onmessage: ((event: MessageEvent<ToExact>) => void) | null;
  postMessage(message: FromExact, transfer: readonly ArrayBufferLike[]): void;
}

/** ms between two parts of the image */
const PART = 200;
/** active bricks that are kept beyond those of the picture, some 10 kB each */
const MOST_BRICKS = 10_000;

const scope = self as unknown as Scope;
let wish: Cast | null = null;
let latest = 0;
let working = false;
/** oldest first */
const kept = new Map<string, Located>();

scope.onmessage = ({ data }) => {
  wish = data.type === 'cast' ? data : null;
  latest = data.id;
  if (wish && !working) void work();
};

async function work(): Promise<void> {
  working = true;
  while (wish) {
    const job: Cast = wish;
    wish = null;
    try {
      await cast(job);
    } catch (error) {
      say({ type: 'refused', id: job.id, message: error instanceof Error ? error.message : String(error) });
    }
  }
  working = false;
}

async function cast(job: Cast): Promise<void> {
  const bodies: Standing[] = [];
  for (const body of job.bodies) {
    const located = await locatedOf(body, job);
    if (!located) return;
    bodies.push({ located, placement: body.placement });
  }
  forget(job.bodies.length);
  const wanted = () => job.id === latest;
  const start = performance.now();
  const before = workOf(bodies);
  const image = await sliced(rowsOf(job, bodies), wanted);
  if (!image) return;
  const { camera, id } = job;
  const milliseconds = performance.now() - start;
  const evaluationsAPixel = (workOf(bodies) - before) / (camera.width * camera.height);
  const places = edgesOf(image, camera);
  scope.postMessage({ type: 'edges', id, places, evaluationsAPixel, milliseconds }, []);
  for (const offset of OFFSETS) {
    const recast = await sliced(again(job, bodies, places, offset), wanted);
    if (!recast) return;
    scope.postMessage({ type: 'again', id, recast }, [recast.surface.buffer, recast.colours.buffer]);
  }
}

const workOf = (bodies: readonly Standing[]): number =>
  [...new Set(bodies.map(({ located }) => located.tally))].reduce((sum, { work }) => sum + work, 0);

/** Goes on as long as this body is wanted, also for another picture. */
async function locatedOf({ key, node, cells }: ExactBody, { id }: Cast): Promise<Located | null> {
  const name = `${key} ${cells}`;
  const known = kept.get(name);
  kept.delete(name);
  const wanted = () => id === latest || (wish?.bodies.some((body) => body.key === key) ?? false);
  const progress = (share: number) => say({ type: 'locating', id, share });
  const located = known ?? (await sliced(locating(bindField(node), cells), wanted, progress));
  if (located) kept.set(name, located);
  return located;
}

/** What was not looked at for long goes, where there is too much. */
function forget(needed: number): void {
  const others = [...kept].slice(0, -needed);
  let bricks = others.reduce((sum, [, located]) => sum + located.bricks.active.length, 0);
  for (const [name, located] of others) {
    if (bricks <= MOST_BRICKS) return;
    bricks -= located.bricks.active.length;
    kept.delete(name);
  }
}

/** The image, told in parts. */
function* rowsOf({ id, camera }: Cast, bodies: readonly Standing[]): Generator<number, OwnImage> {
  const image = emptyImage(camera);
  const caster = new SceneCaster(bodies, camera);
  const [first, end] = caster.rows;
  let told = first;
  let due = performance.now() + PART;
  for (let row = first; row < end; row++) {
    caster.row(image, row);
    const share = (row + 1 - first) / (end - first);
    if (row + 1 === end || performance.now() > due) {
      const part = [4 * told * image.width, 4 * (row + 1) * image.width] as const;
      const [surface, colours] = [image.surface.slice(...part), image.colours.slice(...part)];
      const rows = { type: 'rows', id, from: told, to: row + 1, share, surface, colours } as const;
      scope.postMessage(rows, [surface.buffer, colours.buffer]);
      told = row + 1;
      due = performance.now() + PART;
    }
    yield share;
  }
  return image;
}

/** pixels between two looks at the clock */
const BATCH = 64;

function* again(
  { camera }: Cast,
  bodies: readonly Standing[],
  places: Uint32Array,
  offset: Recast['offset'],
): Generator<number, Recast & OwnImage> {
  const caster = new SceneCaster(bodies, { ...camera, offset });
  const image = emptyImage({ width: places.length, height: 1 });
  for (const [i, at] of places.entries()) {
    caster.pixel(image, i, at % camera.width, Math.floor(at / camera.width));
    if (i % BATCH === 0) yield i / places.length;
  }
  return { ...image, offset };
}

function say(message: FromExact): void {
  scope.postMessage(message, []);
}
