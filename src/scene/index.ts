/** The picture: items in, pixels out. The only folder that knows three.js. */
import type { DeviceDescription } from '../gpu/device.ts';
import { CameraRig } from './cameraRig.ts';
import type { Look } from './look.ts';
import type { SceneItem } from './part.ts';
import { type Hit, pick } from './pick.ts';
import { type PictureOptions, Studio, takePicture } from './picture.ts';
import {
  FINE_LINE_TEXELS,
  LINE_TEXELS,
  LINE_TEXELS_IN_SOFTWARE,
  Pipeline,
  type Refining,
} from './pipeline.ts';
import { type Backend, createRenderer, type SceneRenderer } from './renderer.ts';
import type { SurfaceImage } from './surfaceImage.ts';

export type { DeviceDescription } from '../gpu/device.ts';
export { CameraRig } from './cameraRig.ts';
export type { DeviceMesh } from './deviceMesh.ts';
export { type Background, DEFAULT_LOOK, type KernelChoice, type Look, type Style } from './look.ts';
export type { SceneItem } from './part.ts';
export type { Hit } from './pick.ts';
export type { PictureOptions } from './picture.ts';
export type { Refining } from './pipeline.ts';
export type { Backend } from './renderer.ts';
export type { SurfaceImage } from './surfaceImage.ts';
export { type Face, FRONT_VIEW } from './view.ts';

export interface Scene {
  /** what three.js really uses */
  readonly backend: Backend;
  /** the shared device for compute passes; null on WebGL2 */
  readonly device: GPUDevice | null;
  /** null on WebGL2 */
  readonly description: DeviceDescription | null;
  /** why there is no WebGPU; null when there is */
  readonly fallbackReason: string | null;
  /** Resolves, with the reason, when the device is gone or of no use: make a new scene on a new canvas. */
  readonly lost: Promise<string>;
  /** Its first frame could not be drawn: another device of the same back end is of no use. */
  readonly useless: boolean;
  readonly rig: CameraRig;
  /** of the last frame, over all passes; without meshes on the device, whose numbers only the device knows */
  readonly drawCalls: number;
  readonly triangles: number;
  /**
   * Puts in what is new, changes what changed, disposes what left; compares by reference. Throws, and changes nothing, where a mesh on the
   * device cannot be drawn: on WebGL2, or for want of a usage of its buffers.
   */
  sync(items: readonly SceneItem[]): void;
  setLook(look: Look): void;
  /** Forms not yet kept step back behind a guide. */
  setFaint(on: boolean): void;
  /** Lines over the picture on the screen, six numbers each, mm; compared by reference. Null: none. */
  guide(ends: Float32Array | null): void;
  /** CSS pixels, and device pixels a CSS pixel */
  resize(width: number, height: number, devicePixelRatio: number): void;
  /** CSS pixels from the upper left; previews too, the id tells; items with the ids of `except` are looked through */
  pick(x: number, y: number, except?: readonly string[]): Hit | null;
  /** of the picture, device pixels */
  readonly pixels: { readonly width: number; readonly height: number };
  /** One frame, now. */
  render(): void;
  /**
   * The last frame once more, with surfaces from an image in place of the triangles of some items: from the mean of this picture and of those
   * before it since that frame, whose places in the pixel were others. The view and all else must be as they were. False where there was no frame.
   */
  refine(image: SurfaceImage, how?: Refining): boolean;
  /** Images in the mean of pictures that is seen, 0: triangles only; null: there is no frame, or another look or size undid it. */
  readonly refined: number | null;
  /**
   * Keeps the picture of the last frame: it lies over the frames to come, as `fade` says, until the look or the size changes.
   * False where there is none.
   */
  keep(): boolean;
  /** How much is seen of the picture that is kept, 0–1; at 0 it goes. */
  fade(share: number): void;
  /** The parts with a blue contour. */
  select(ids: readonly string[]): void;
  /**
   * A picture of 16 to 8192 pixels a side, without disturbing the one on the screen: kept parts only, nothing
   * selected. Fails, with words for people, when the device cannot hold it or is lost.
   */
  picture(options: PictureOptions): Promise<ImageData>;
  /** Draws a frame and resolves when it is on the screen with all its pipelines compiled. */
  compile(): Promise<void>;
  dispose(): void;
}

export interface SceneOptions {
  /** auto = WebGPU where it works, else WebGL2 */
  readonly backend?: 'auto' | 'webgl2';
  /** why WebGL2 is asked for, in words */
  readonly because?: string | undefined;
  /** the most texels lines are found in: twice the screen's resolution as long as they suffice; 12 bytes each */
  readonly lineTexels?: number;
  /** lines for a picture, where time is no matter */
  readonly fine?: boolean;
}

/** ms: what failed because the device was lost is heard of sooner than the loss. */
const LOSS_FIRST = 100;

/** Never fails for want of WebGPU; throws only when there is no WebGL2 either. */
export async function createScene(canvas: HTMLCanvasElement, options: SceneOptions = {}): Promise<Scene> {
  const made = await createRenderer(canvas, options.backend ?? 'auto', options.because);
  try {
    return makeScene(made, options);
  } catch (error) {
    made.dispose();
    throw error;
  }
}

function makeScene(made: SceneRenderer, options: SceneOptions): Scene {
  const { renderer, device } = made;
  const rig = new CameraRig();
  const affordable = made.description?.software ? LINE_TEXELS_IN_SOFTWARE : LINE_TEXELS;
  const lineTexels = options.lineTexels ?? (options.fine ? FINE_LINE_TEXELS : affordable);
  const pipeline = new Pipeline(renderer, { lineTexels, maxSide: made.maxSide });
  let studio: Studio | null = null;
  let drawing: 'not yet' | 'begun' | 'failed' = 'not yet';
  let giveUp: (reason: string) => void = () => {};
  const lost = new Promise<string>((resolve) => {
    giveUp = resolve;
  });
  void made.lost.then(giveUp);
  const fail = (error: unknown) => {
    drawing = 'failed';
    const reason = `it could not draw: ${error instanceof Error ? error.message : error}`;
    setTimeout(() => giveUp(reason), LOSS_FIRST);
  };
  let width = 1;
  let height = 1;
  const scene: Scene = {
    backend: made.backend,
    device,
    description: made.description,
    fallbackReason: made.fallbackReason,
    lost,
    get useless() {
      return drawing === 'failed' && made.gone === null;
    },
    rig,
    get drawCalls() {
      return pipeline.drawCalls;
    },
    get triangles() {
      return pipeline.triangles;
    },
    sync(items) {
      if (pipeline.parts.sync(items)) rig.setBounds(pipeline.parts.ball);
    },
    setLook: (look) => pipeline.setLook(look),
    setFaint: (on) => pipeline.setFaint(on),
    guide: (ends) => pipeline.guide(ends),
    resize(newWidth, newHeight, devicePixelRatio) {
      width = newWidth;
      height = newHeight;
      rig.resize(width, height);
      pipeline.resize(width, height, devicePixelRatio);
    },
    pick: (x, y, except) =>
      pick(pipeline.parts.all(), rig.camera, (2 * x) / width - 1, 1 - (2 * y) / height, except),
    render() {
      // A lost device takes commands without a word, but three complains of what it gets from it.
      if (made.gone !== null || drawing === 'failed') return;
      const draw = () => pipeline.render(rig.camera, rig.view());
      if (drawing === 'begun') draw();
      // What the self-test did not find out shows at the first frame.
      else made.watched(async () => draw()).catch(fail);
      if (drawing === 'not yet') drawing = 'begun';
    },
    get pixels() {
      return pipeline.pixels;
    },
    refine: (image, how) =>
      made.gone === null && drawing === 'begun' && pipeline.refine(rig.camera, rig.view(), image, how),
    get refined() {
      return pipeline.refined;
    },
    keep: () => made.gone === null && drawing === 'begun' && pipeline.keep(),
    fade(share) {
      pipeline.fade = share;
    },
    select: (ids) => pipeline.parts.select(ids),
    picture: (wanted) => takePicture(made, () => (studio ??= new Studio(made)), wanted),
    async compile() {
      scene.render();
      await made.finished();
    },
    dispose() {
      studio?.dispose();
      pipeline.dispose();
      rig.dispose();
      made.dispose();
    },
  };
  return scene;
}
