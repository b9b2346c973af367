/** What rays have found so far for one picture: kept on the page, so that another style or colour casts none anew. */
import type { FromExact, Rows } from '../field/exactWork.ts';
import { imageThrough, OFFSETS, type Recast } from '../field/rayEdges.ts';
import type { RayCamera } from '../field/rayImage.ts';
import { emptyImage, type OwnImage } from '../field/rayScene.ts';
import type { SurfaceImage } from '../scene/index.ts';
import type { CastImages } from './caster.ts';

export class ExactImages implements CastImages {
  readonly whole = 1 + OFFSETS.length;
  known = 0;
  /** bodies are looked for, then rows cast */
  share = 0;
  evaluationsAPixel: number | null = null;
  milliseconds = 0;
  readonly #camera: RayCamera;
  /** ids of the items */
  readonly #items: readonly string[];
  readonly #base: OwnImage;
  #edges: Uint32Array | null = null;
  readonly #recasts: Recast[] = [];

  constructor(camera: RayCamera, items: readonly string[]) {
    this.#camera = camera;
    this.#items = items;
    this.#base = emptyImage(camera);
  }

  hear(said: Exclude<FromExact, { readonly type: 'refused' }>): void {
    switch (said.type) {
      case 'locating':
        this.share = Math.min(said.share, 1);
        return;
      case 'rows':
        this.#put(said);
        return;
      case 'edges':
        this.#edges = said.places;
        this.known = 1;
        ({ evaluationsAPixel: this.evaluationsAPixel, milliseconds: this.milliseconds } = said);
        return;
      case 'again':
        this.#recasts.push(said.recast);
    }
  }

  get count(): number {
    return this.#edges ? 1 + this.#recasts.length : 0;
  }

  image(number: number): SurfaceImage {
    const recast = this.#recasts[number - 1];
    const [camera, items] = [this.#camera, this.#items];
    if (!recast || !this.#edges) return { camera, items, ...arraysOf(this.#base) };
    const { surface, colours } = imageThrough(this.#base, camera, this.#edges, recast);
    return { camera: { ...camera, offset: recast.offset }, items, surface, colours };
  }

  #put({ from, to, share, surface, colours }: Rows): void {
    const { width, height } = this.#camera;
    this.#base.surface.set(surface, 4 * from * width);
    this.#base.colours.set(colours, 4 * from * width);
    this.share = share;
    this.known = Math.min(to / height, 1 - 1 / height);
  }
}

const arraysOf = ({ surface, colours }: OwnImage) => ({ surface, colours });
