/**
 * What of a picture is still to be cast, in the order in which it is wanted: bands of rows from the middle outwards, then the rays at edges, one
 * image after the other. Whoever is idle takes the next, so that nobody waits for who has the dear ones.
 *
 * Bands of all columns, not squares: what is there is then all between two rows, which the picture shows (scene/fade.ts). What was changed or is
 * looked at is mostly in the middle; a row costs what the next one does, so that the last to finish has hardly more than a band to do alone.
 */
import type { AgainJob, BandJob } from '../field/exactWork.ts';
import { OFFSETS } from '../field/rayEdges.ts';

export type Job =
  | Pick<BandJob, 'type' | 'from' | 'to'>
  | (Pick<AgainJob, 'type' | 'offset' | 'first'> & { readonly count: number });

/** rows */
export const BAND = 16;
/** pixels that are cast again at a time, some 50 ms */
const MOST = 1024;

export class RayJobs {
  readonly #bands: Job[];
  readonly #givenBack: Job[] = [];
  /** pixels that were handed out, for each offset */
  readonly #handed = OFFSETS.map(() => 0);

  constructor(height: number) {
    const bands = Array.from({ length: Math.ceil(height / BAND) }, (_, i) => i * BAND);
    const off = (from: number) => Math.abs(from + BAND / 2 - height / 2);
    this.#bands = bands
      .toSorted((a, b) => off(a) - off(b))
      .map((from) => ({ type: 'band', from, to: Math.min(from + BAND, height) }));
  }

  /** `places`: pixels that are known to be at edges; null: nothing for now. */
  next(places: number): Job | null {
    return this.#givenBack.pop() ?? this.#bands.shift() ?? this.#again(places);
  }

  /** Nobody did them. */
  giveBack(jobs: readonly Job[]): void {
    this.#givenBack.push(...jobs);
  }

  #again(places: number): Job | null {
    const offset = this.#handed.findIndex((handed) => handed < places);
    if (offset < 0) return null;
    const first = this.#handed[offset]!;
    const count = Math.min(places - first, MOST);
    this.#handed[offset] = first + count;
    return { type: 'again', offset, first, count };
  }
}
