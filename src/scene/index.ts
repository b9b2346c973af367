/** The picture: items in, pixels out. The only folder that knows three.js. */
import type { DeviceDescription } from '../gpu/device.ts';
import type { View } from '../stroke/stroke.ts';
import { CameraRig } from './cameraRig.ts';
import type { Look } from './look.ts';
import type { SceneItem } from './part.ts';
import { type Hit, pick } from './pick.ts';
import { LINE_TEXELS, LINE_TEXELS_IN_SOFTWARE, Pipeline } from './pipeline.ts';
import { type Backend, createRenderer } from './renderer.ts';

export type { DeviceDescription } from '../gpu/device.ts';
export { CameraRig } from './cameraRig.ts';
export { type Background, DEFAULT_LOOK, type KernelChoice, type Look, type Style } from './look.ts';
export type { SceneItem } from './part.ts';
export type { Hit } from './pick.ts';
export type { Backend } from './renderer.ts';
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
  /** Resolves, with the reason, when the device is gone: make a new scene on a new canvas. */
  readonly lost: Promise<string>;
  readonly rig: CameraRig;
  /** of the last frame, over all passes */
  readonly drawCalls: number;
  readonly triangles: number;
  /** Puts in what is new, changes what changed, disposes what left; compares by reference. */
  sync(items: readonly SceneItem[]): void;
  setLook(look: Look): void;
  /** CSS pixels, and device pixels a CSS pixel */
  resize(width: number, height: number, devicePixelRatio: number): void;
  /** CSS pixels from the upper left; previews too, the id tells */
  pick(x: number, y: number): Hit | null;
  /** One frame, now. */
  render(): void;
  /** The parts with a blue contour. */
  select(ids: readonly string[]): void;
  /** A picture of any size, without disturbing the one on the screen: kept parts only, nothing selected. */
  picture(options: PictureOptions): Promise<ImageData>;
  /** Draws a frame and resolves when it is on the screen with all its pipelines compiled. */
  compile(): Promise<void>;
  dispose(): void;
}

export interface PictureOptions {
  /** pixels */
  readonly width: number;
  readonly height: number;
  readonly view: View;
  readonly look: Look;
  readonly items: readonly SceneItem[];
}

export interface SceneOptions {
  /** auto = WebGPU where it works, else WebGL2 */
  readonly backend?: 'auto' | 'webgl2';
  /** the most texels lines are found in: twice the screen's resolution as long as they suffice; 12 bytes each */
  readonly lineTexels?: number;
}

/** Never fails for want of WebGPU; throws only when there is no WebGL2 either. */
export async function createScene(canvas: HTMLCanvasElement, options: SceneOptions = {}): Promise<Scene> {
  const made = await createRenderer(canvas, options.backend ?? 'auto');
  const { renderer, device } = made;
  const rig = new CameraRig();
  const affordable = made.description?.software ? LINE_TEXELS_IN_SOFTWARE : LINE_TEXELS;
  const pipeline = new Pipeline(renderer, options.lineTexels ?? affordable);
  let width = 1;
  let height = 1;
  const scene: Scene = {
    backend: made.backend,
    device,
    description: made.description,
    fallbackReason: made.fallbackReason,
    lost: made.lost,
    rig,
    get drawCalls() {
      return renderer.info.render.drawCalls;
    },
    get triangles() {
      return renderer.info.render.triangles;
    },
    sync(items) {
      if (!pipeline.parts.sync(items)) return;
      const { center, radius } = pipeline.parts.sphere;
      rig.setBounds(radius > 0 ? { centre: center.toArray(), radius } : null);
    },
    setLook: (look) => pipeline.setLook(look),
    resize(newWidth, newHeight, devicePixelRatio) {
      width = newWidth;
      height = newHeight;
      rig.resize(width, height);
      pipeline.resize(width, height, devicePixelRatio);
    },
    pick: (x, y) => pick(pipeline.parts.all(), rig.camera, (2 * x) / width - 1, 1 - (2 * y) / height),
    render: () => pipeline.render(rig.camera, rig.view()),
    select() {},
    picture: () => Promise.reject(new Error('not yet')),
    async compile() {
      scene.render();
      await device?.queue.onSubmittedWorkDone();
    },
    dispose() {
      pipeline.dispose();
      rig.dispose();
      made.dispose();
    },
  };
  return scene;
}
