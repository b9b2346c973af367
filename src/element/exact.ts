/**
 * The exact surface of bodies in the picture. While anything moves their meshes are seen; where all rests rays are cast beside the page, and
 * their image takes the place of the meshes row by row, then gets smoother edges. Any change gives it up at once.
 */
import { bodyMade, CELLS } from '../document/bodies.ts';
import { type Document, isBody } from '../document/document.ts';
import type { ExactBody } from '../field/exactWork.ts';
import type { FieldNode } from '../field/node.ts';
import { OFFSETS } from '../field/rayEdges.ts';
import type { RayCamera } from '../field/rayImage.ts';
import type { Placement } from '../math/placement.ts';
import type { Scene, SurfaceImage } from '../scene/index.ts';
import type { View } from '../stroke/stroke.ts';
import { ExactImages } from './exactImages.ts';
import { RayWorker } from './rayWorker.ts';

/** ms without a change until rays are cast, or until what was cast is shown again */
const REST = 120;
/** images after which nothing of the meshes is seen any more: fewer leave edges jagged */
const ENOUGH = 3;
/** of the rows of the first image: what more than this is drawn at once */
const PART = 0.12;
/** rays a picture: larger ones have a ray for several pixels */
const MOST_RAYS = 2.4e6;

const WHOLE = 1 + OFFSETS.length;

const MIDDLE = [0.5, 0.5] as const;

/** Of one picture; made when they are drawn. */
type Images = readonly (() => SurfaceImage)[];

/** A body, and the item of the scene that is its mesh. */
export interface ShownBody {
  readonly id: string;
  readonly node: FieldNode;
  readonly placement: Placement;
  /** of its lattice, along the longest side */
  readonly cells: number;
}

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
  readonly #worker: RayWorker;
  #images: ExactImages | null = null;
  /** what the images are of, and what is drawn of them */
  #cast = '';
  #drawn = '';
  /** images that are drawn */
  #count = 0;
  /** how much of the first image is drawn before it is whole */
  #known = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #rested = false;
  /** a picture is made: the screen waits */
  #isBusy = false;
  /** ends with the pictures before */
  #turn: Promise<unknown> = Promise.resolve();

  /** `changed` asks for another frame. */
  constructor(changed: () => void, worker = new RayWorker()) {
    this.#changed = changed;
    this.#worker = worker;
  }

  /** Draws the frame, or leaves it as it is; false: it is to be drawn with meshes. */
  frame(seen: Seen): boolean {
    const { scene, bodies, view, version } = seen;
    if (bodies.length === 0 || this.#isBusy) {
      this.rest();
      return false;
    }
    const camera = cameraOf(view, scene.pixels);
    const cast = JSON.stringify([
      camera,
      bodies.map(({ node, placement, cells }) => [keyOf(node), placement, cells]),
    ]);
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
    return this.#refine(scene);
  }

  /** Nothing is wanted. */
  rest(): void {
    if (this.#cast === '' && !this.#images) return;
    this.#giveUp();
    this.#cast = '';
    this.#drawn = '';
    clearTimeout(this.#timer);
    this.#rested = false;
  }

  /** Nobody is there to see them. */
  stop(): void {
    this.rest();
    this.#worker.end();
  }

  /** 0–1 of what is being done; null: nothing is. */
  get share(): number | null {
    const images = this.#images;
    return images && images.count === 0 && this.problem === null ? images.share : null;
  }

  /** Of the image that is seen, in values of one skel; null: none is. */
  get evaluationsAPixel(): number | null {
    return this.#count > 0 ? (this.#images?.evaluationsAPixel ?? null) : null;
  }

  /** ms that the first image took */
  get milliseconds(): number {
    return this.#images?.milliseconds ?? 0;
  }

  /** All that can be seen is seen. */
  get isWhole(): boolean {
    return this.problem !== null || this.#count === WHOLE;
  }

  /** For a picture of its own; what is on the screen waits. Rejects where there are none. */
  async images(bodies: readonly ShownBody[], view: View, pixels: Scene['pixels']): Promise<Images> {
    if (bodies.length === 0) return [];
    const turn = this.#turn.then(() => this.#whole(bodies, cameraOf(view, pixels)));
    this.#turn = turn.catch(() => {});
    return turn;
  }

  async #whole(bodies: readonly ShownBody[], camera: RayCamera): Promise<Images> {
    this.#giveUp();
    this.#isBusy = true;
    const images = new ExactImages(camera, idsOf(bodies));
    try {
      await new Promise<void>((resolve, reject) => {
        this.#worker.cast({ bodies: bodies.map(exactBody), camera }, (said) => {
          if (said.type === 'refused') reject(new Error(said.message));
          else images.hear(said);
          if (images.count === WHOLE) resolve();
        });
      });
    } finally {
      this.#isBusy = false;
      this.#changed();
    }
    return Array.from({ length: WHOLE }, (_, i) => () => images.image(i));
  }

  #giveUp(): void {
    if (this.#images && this.#images.count < WHOLE) this.#worker.stop();
    this.#images = null;
    this.#count = 0;
    this.problem = null;
  }

  #wait(): void {
    this.#count = 0;
    this.#known = 0;
    this.#rested = false;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      this.#rested = true;
      this.#changed();
    }, REST);
  }

  #begin(bodies: readonly ShownBody[], camera: RayCamera): void {
    const images = new ExactImages(camera, idsOf(bodies));
    this.#images = images;
    this.#worker.cast({ bodies: bodies.map(exactBody), camera }, (said) => {
      if (this.#images !== images) return;
      if (said.type === 'refused') this.problem = said.message;
      else images.hear(said);
      this.#changed();
    });
  }

  /** More rows of the first; few at a time would cost more than they show. */
  #inPart(scene: Scene, images: ExactImages): boolean {
    const { known } = images;
    if (this.problem !== null) return false;
    if (known - this.#known < PART) return true;
    this.#known = known;
    return scene.refine(images.image(0), { known, enough: ENOUGH });
  }

  /** One more image. */
  #refine(scene: Scene): boolean {
    const images = this.#images;
    if (!images) return false;
    // somebody drew another frame, or undid it
    if (scene.refined !== this.#count) {
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
export const shownBodies = ({ parts }: Document): readonly ShownBody[] =>
  parts
    .filter(isBody)
    .filter(({ hidden }) => !hidden)
    .map(({ id, node, placement }) => ({ id, node, placement, cells: bodyMade(node)?.cells ?? CELLS }));

const idsOf = (bodies: readonly ShownBody[]): readonly string[] => bodies.map(({ id }) => id);

const exactBody = ({ node, placement, cells }: ShownBody): ExactBody => ({
  key: keyOf(node),
  node,
  placement,
  cells,
});

const keys = new WeakMap<FieldNode, number>();
let lastKey = 0;

function keyOf(node: FieldNode): number {
  const key = keys.get(node) ?? ++lastKey;
  keys.set(node, key);
  return key;
}

function cameraOf(view: View, { width, height }: Scene['pixels']): RayCamera {
  const shrunk = Math.min(1, Math.sqrt(MOST_RAYS / (width * height)));
  const side = (pixels: number) => Math.max(1, Math.round(pixels * shrunk));
  return { view, width: side(width), height: side(height), offset: MIDDLE };
}
