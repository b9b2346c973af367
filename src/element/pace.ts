/**
 * How fast a graphics device casts rays, by what they took last: as long as it takes to answer when it was asked for nothing counts for no ray
 * (counted in, a device that answers after 20 ms was given row by row, 600 an image). What takes longer is believed at once, what
 * is faster by and by, so that moving pictures do not change their resolution from frame to frame.
 */

/** from one band to the next: what was seen so far may have been paper */
const GROWTH = 4;
/** share of what was seen last */
const BELIEF = 0.4;
/** rays a pixel: what the next picture or band is thought to have at least, though the last one was paper */
export const SPARSE = 0.25;
/** rays of the first band of all */
const FIRST = 1 << 14;
/** of an answer: what is the rays' at least */
const LEAST = 0.125;

export class Pace {
  /** ms a ray; null: not known yet */
  #ray: number | null = null;
  /** ms there and back */
  #way = Infinity;
  #band = FIRST;

  /** Nothing took so long. */
  answered(milliseconds: number): void {
    const way = (1 - BELIEF) * this.#way + BELIEF * milliseconds;
    this.#way = Math.min(milliseconds, way);
  }

  /** So many rays took so long. */
  hear(rays: number, milliseconds: number): void {
    if (rays <= 0) return;
    const way = this.#way === Infinity ? 0 : this.#way;
    const now = Math.max(milliseconds - way, LEAST * milliseconds) / rays;
    this.#ray = Math.max(now, (1 - BELIEF) * (this.#ray ?? now) + BELIEF * now);
    this.#band = Math.max(FIRST, rays);
  }

  /** How many rays to begin with, of which `milliseconds` may be needed. */
  rays(milliseconds: number): number {
    if (this.#ray === null) return FIRST;
    return Math.min(milliseconds / this.#ray, GROWTH * this.#band);
  }

  /** What they take, ms; null: not known yet. */
  milliseconds(rays: number): number | null {
    return this.#ray === null ? null : rays * this.#ray;
  }
}
