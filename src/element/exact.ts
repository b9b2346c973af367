/**
 * The exact surface of bodies in the picture. While anything moves their meshes are seen, or fewer rays where a graphics device casts them in time;
 * where all rests rays are cast beside the page, and their image takes the place of the meshes, then gets smoother edges. Any change gives it up
 * at once.
 *
 * The mesh is the workers' reduced resolution: it is less than a pixel off, has smooth edges and is there at once; a coarse image of rays is none of
 * these. So that nothing pops, no image weighs more than a third in the first picture: what is there of the first (bands from the middle outwards,
 * with a soft border, at most three times) shows as lightly as all of it will, and with the third the mesh is gone. Everything is cast anew where
 * one of several bodies moves: which pixels another body's shape or its absence leaves alone was not worth the care.
 */
import { cellsMade } from '../document/bodies.ts';
import type { Document } from '../document/document.ts';
import { bodiesOf } from '../document/fieldParts.ts';
import type { RayCamera } from '../field/rayImage.ts';
import type { Scene, SurfaceImage } from '../scene/index.ts';
import type { View } from '../stroke/stroke.ts';
import { type Caster, type CastImages, MIDDLE, MOST_RAYS, type ShownBody } from './caster.ts';
import { keyOf, RayWorker } from './rayWorker.ts';
import { WORDS } from './words.ts';

/** ms without a change until rays are cast, or until what was cast is shown again */
const REST = 120;
/** ms that rays may take of a frame of something that moves */
const LIVE = 12;
/** images after which nothing of the meshes is seen any more: fewer leave edges jagged */
const ENOUGH = 3;
/**
 * What is there of the first image is drawn when this is more than was drawn, of its rows, and so many ms after it: a software adapter takes
 * half a second, which the rays could have.
 */
const PART = 0.3;
const PAUSE = 1500;
/** ms without a wish until workers end and images go: bricks are worth keeping while somebody goes back and forth */
const IDLE = 20_000;

/** Of one picture; made when they are drawn. */
type Images = readonly (() => SurfaceImage)[];

/** What is on the screen. */
export interface Seen {
  readonly scene: Scene;
  readonly bodies: readonly ShownBody[];
  readonly view: View;
  /** rises with every change of what the picture shows, but for the view */
  readonly version: number;
}

export class Exact {
  /** why there is none, in words; null: there is one, or none is wanted */
  problem: string | null = null;
  readonly #changed: () => void;
  readonly #caster: Caster;
  #images: CastImages | null = null;
  /** what the images are of, and what is drawn of them; '': nothing is wanted */
  #cast = '';
  #drawn = '';
  /** images that are drawn */
  #count = 0;
  /** ms, when the rays began, or what was there of them was drawn last */
  #drawnAt = 0;
  #known = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #idle: ReturnType<typeof setTimeout> | undefined;
  #rested = false;
  /** a picture is made: the screen waits */
  #isBusy = false;
  /** of that picture, which may be those of the screen */
  #lent: CastImages | null = null;
  /** ends with the pictures before */
  #turn: Promise<unknown> = Promise.resolve();

  /** `changed` asks for another frame. */
  constructor(changed: () => void, caster: Caster = new RayWorker()) {
    this.#changed = changed;
    this.#caster = caster;
  }

  /** Draws the frame, or leaves it as it is; false: it is to be drawn with meshes. */
  frame(seen: Seen): boolean {
    const { scene, bodies, view, version } = seen;
    if (bodies.length === 0) this.rest();
    if (bodies.length === 0 || this.#isBusy) return false;
    this.#keep();
    const camera = cameraOf(view, scene.pixels);
    const cast = nameOf(bodies, camera);
    const drawn = `${version} ${cast}`;
    if (drawn !== this.#drawn) {
      if (cast !== this.#cast) this.#giveUp();
      this.#cast = cast;
      this.#drawn = drawn;
      this.#wait();
      return false;
    }
    if (!this.#rested) return false;
    if (!this.#images) this.#begin(bodies, camera);
    const isDrawn = this.#refine(scene);
    if (this.isWhole) this.#letGo();
    return isDrawn;
  }

  /** Draws a frame of something that moves by rays as well, where they are fast enough; false: it is to be drawn with meshes. */
  live({ scene, bodies, view }: Omit<Seen, 'version'>): boolean {
    if (bodies.length === 0 || this.#isBusy || this.problem !== null) return false;
    // only the style is another, or the selection; rows that are lost are seen through no image alone
    const isKept = this.#isKept && !this.#images?.lost;
    const isSame = isKept && nameOf(bodies, cameraOf(view, scene.pixels)) === this.#cast;
    const image = isSame ? this.#images!.image(0) : this.#caster.live?.(bodies, view, scene.pixels, LIVE);
    // what moves for long is wanted as long
    if (image) this.#letGo();
    return image ? scene.refine(image, { alone: true }) : false;
  }

  /** Nothing is wanted for now: images that are whole are kept for when the same is wanted again. */
  rest(): void {
    if (this.#drawn === '') return;
    if (!this.#isKept) this.drop();
    this.#leave();
    this.#letGo();
  }

  /** Nothing is wanted, and nothing kept: images may lie on a device that goes. */
  drop(): void {
    this.#giveUp();
    this.#cast = '';
    this.#leave();
  }

  /** Nobody is there to see them. */
  stop(): void {
    this.drop();
    this.#keep();
    this.#caster.end();
  }

  /** 0–1 of what is there until the first image is seen; null: it is, or none is wanted, or there is none. */
  get share(): number | null {
    if (this.#drawn === '' || this.#count > 0 || this.problem !== null) return null;
    const images = this.#images;
    return images ? (images.count > 0 ? 1 : images.share) : 0;
  }

  /** Of the image that is seen, in values of one skel; null: none is. */
  get evaluationsAPixel(): number | null {
    return this.#count > 0 ? (this.#images?.evaluationsAPixel ?? null) : null;
  }

  /** Some rows of what is seen, or will be, are triangles: nobody could cast them. */
  get isInPart(): boolean {
    return (this.#images?.lost ?? null) !== null && this.problem === null;
  }

  /** ms that the first image took */
  get milliseconds(): number {
    return this.#images?.milliseconds ?? 0;
  }

  /** All that can be seen is seen. */
  get isWhole(): boolean {
    return this.problem !== null || this.#count === this.#images?.whole;
  }

  /** Has a picture of its own drawn with images that are there as long as that takes; what is on the screen waits. Rejects where there are none, or rows that nobody could cast. */
  async picture<T>(
    bodies: readonly ShownBody[],
    view: View,
    pixels: Scene['pixels'],
    draw: (images: Images) => Promise<T>,
  ): Promise<T> {
    if (bodies.length === 0) return draw([]);
    const turn = this.#turn.then(() => this.#whole(bodies, cameraOf(view, pixels), draw));
    this.#turn = turn.catch(() => {});
    return turn;
  }

  /** What is whole on the screen stays, and serves where it is the same. */
  async #whole<T>(
    bodies: readonly ShownBody[],
    camera: RayCamera,
    draw: (images: Images) => Promise<T>,
  ): Promise<T> {
    if (!this.#isKept) this.drop();
    this.#keep();
    this.#isBusy = true;
    try {
      const isSame = nameOf(bodies, camera) === this.#cast && !this.#images?.lost;
      const images = (isSame ? this.#images : null) ?? (await this.#allOf(bodies, camera));
      this.#lent = images;
      if (images.lost) throw new Error(WORDS.picturePart);
      return await draw(Array.from({ length: images.whole }, (_, i) => () => images.image(i)));
    } finally {
      if (this.#lent !== this.#images) this.#lent?.drop?.();
      this.#lent = null;
      this.#isBusy = false;
      this.#letGo();
      this.#changed();
    }
  }

  #allOf(bodies: readonly ShownBody[], camera: RayCamera): Promise<CastImages> {
    return new Promise((resolve, reject) => {
      const casting = this.#caster.cast(bodies, camera, {
        changed: () => casting.count === casting.whole && resolve(casting),
        spare: () => this.#spare(),
        refused: (why) => reject(new Error(why)),
      });
    });
  }

  /** Gives back what is whole on the screen, which is cast anew after the picture. */
  #spare(): boolean {
    if (!this.#images) return false;
    this.#giveUp();
    this.#cast = '';
    return true;
  }

  #keep(): void {
    clearTimeout(this.#idle);
  }

  #letGo(): void {
    if (this.#isBusy) return;
    this.#keep();
    this.#idle = setTimeout(() => {
      if (this.#drawn === '') this.drop();
      this.#caster.idle?.();
    }, IDLE);
  }

  #leave(): void {
    this.#drawn = '';
    this.#count = 0;
    this.#rested = false;
    clearTimeout(this.#timer);
  }

  /** All images are there. */
  get #isKept(): boolean {
    const images = this.#images;
    return images !== null && images.count === images.whole && this.problem === null;
  }

  #giveUp(): void {
    // what is whole is nothing to stop: by now others may be cast
    if (this.#images && !this.#isKept) this.#caster.stop();
    if (this.#images !== this.#lent) this.#images?.drop?.();
    this.#images = null;
    this.#count = 0;
    this.problem = null;
  }

  #wait(): void {
    this.#count = 0;
    this.#rested = false;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      this.#rested = true;
      this.#changed();
    }, REST);
  }

  #begin(bodies: readonly ShownBody[], camera: RayCamera): void {
    this.#drawnAt = performance.now();
    this.#known = 0;
    this.#images = this.#caster.cast(bodies, camera, {
      changed: () => this.#changed(),
      refused: (why) => {
        this.problem = why;
        this.#changed();
      },
    });
  }

  /** More rows of the first, now and then. */
  #inPart(scene: Scene, images: CastImages): boolean {
    const { known } = images;
    if (this.problem !== null) return false;
    const [now, share] = [performance.now(), known[1] - known[0]];
    if (share - this.#known < PART || now - this.#drawnAt < PAUSE) return true;
    this.#drawnAt = now;
    this.#known = share;
    return scene.refine(images.image(0), { known, enough: ENOUGH });
  }

  /** One more image. */
  #refine(scene: Scene): boolean {
    const images = this.#images;
    if (!images) return false;
    // somebody drew another frame, or undid it; or others took the picture over, and began anew
    if (scene.refined !== this.#count || images.count < this.#count) {
      this.#wait();
      return false;
    }
    if (images.count === 0) return this.#inPart(scene, images);
    if (this.#count === images.count) return true;
    if (!scene.refine(images.image(this.#count), { enough: ENOUGH })) return false;
    this.#count++;
    this.#changed();
    return true;
  }
}

/** Those of a document that are seen, with lattices as those of their meshes. */
export const shownBodies = (document: Document): readonly ShownBody[] =>
  bodiesOf(document)
    .filter(({ hidden }) => !hidden)
    .map(({ id, node, placement }) => ({ id, node, placement, cells: cellsMade(node) }));

/** What rays are cast at, and from where: the same for the same images. */
const nameOf = (bodies: readonly ShownBody[], camera: RayCamera): string =>
  JSON.stringify([
    camera,
    bodies.map(({ id, node, placement, cells }) => [id, keyOf(node), placement, cells]),
  ]);

function cameraOf(view: View, { width, height }: Scene['pixels']): RayCamera {
  const shrunk = Math.min(1, Math.sqrt(MOST_RAYS / (width * height)));
  const side = (pixels: number) => Math.max(1, Math.round(pixels * shrunk));
  return { view, width: side(width), height: side(height), offset: MIDDLE };
}
