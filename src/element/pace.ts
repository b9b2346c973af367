/** How fast a graphics device casts rays, by what they took last; waiting for the device, and what else it drew, are counted in. */

/** from one band to the next: what was seen so far may have been paper */
const GROWTH = 4;
/** rays of the first band of all */
const FIRST = 1 << 14;

export class Pace {
  /** ms a ray; null: not known yet */
  #ray: number | null = null;
  #band = FIRST;

  /** So many rays took so long. */
  hear(rays: number, milliseconds: number): void {
    if (rays <= 0) return;
    this.#ray = milliseconds / rays;
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
