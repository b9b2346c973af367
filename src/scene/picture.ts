/**
 * A picture of any size for files and thumbnails: the passes of the screen once more, at their own size and into a
 * texture that is read back. The canvas, its items and its camera are not touched, so nothing flashes.
 *
 * All drawing happens in the task that asks, and the memory it took is given back in the same task; only the pixels
 * are waited for. The materials stay, because making them takes longer than drawing with them.
 */
import type { WebGPURenderer } from 'three/webgpu';
import { PICTURE_SIDE } from '../document/look.ts';
import type { View } from '../stroke/stroke.ts';
import { CameraRig } from './cameraRig.ts';
import type { Look } from './look.ts';
import type { SceneItem } from './part.ts';
import { FINE_LINE_TEXELS, Pipeline } from './pipeline.ts';
import type { SceneRenderer } from './renderer.ts';
import type { SurfaceImage } from './surfaceImage.ts';
import { makeOutput } from './targets.ts';

export interface PictureOptions {
  /** pixels */
  readonly width: number;
  readonly height: number;
  readonly view: View;
  readonly look: Look;
  readonly items: readonly SceneItem[];
  /** of surfaces in place of triangles, each looked at through another place of the pixels; made when they are drawn */
  readonly images?: readonly (() => SurfaceImage)[];
}

export async function takePicture(
  made: SceneRenderer,
  studio: () => Studio,
  options: PictureOptions,
): Promise<ImageData> {
  const { width, height } = options;
  checkSize(width, height, made.maxSide);
  try {
    const pixels = await made.watched(async () => studio().draw(options));
    return new ImageData(upright(pixels, width, height, made.backend === 'WebGL2'), width, height);
  } catch (error) {
    const reason = made.gone ?? (error instanceof Error ? error.message : 'the graphics device was lost');
    throw new Error(`The picture of ${width} × ${height} pixels could not be drawn: ${reason}`);
  }
}

function checkSize(width: number, height: number, maxSide: number): void {
  const { least } = PICTURE_SIDE;
  const most = Math.min(PICTURE_SIDE.most, maxSide);
  for (const side of [width, height]) {
    if (Number.isInteger(side) && side >= least && side <= most) continue;
    throw new Error(`A picture has ${least} to ${most} pixels a side; ${width} × ${height} was asked for.`);
  }
}

/** Where pictures are drawn: made at the first one, kept for the life of the scene. */
export class Studio {
  readonly #renderer: WebGPURenderer;
  readonly #output = makeOutput();
  readonly #pipeline: Pipeline;
  readonly #rig = new CameraRig();

  constructor({ renderer, maxSide }: SceneRenderer) {
    this.#renderer = renderer;
    this.#pipeline = new Pipeline(renderer, { lineTexels: FINE_LINE_TEXELS, maxSide, output: this.#output });
  }

  /** Draws and asks for the pixels; nothing large is left when it returns. */
  async draw({ width, height, look, view, items, images = [] }: PictureOptions): Promise<Uint8Array> {
    const pipeline = this.#pipeline;
    const rig = this.#rig;
    try {
      pipeline.resize(width, height, 1);
      pipeline.parts.sync(items.filter((item) => !item.preview));
      pipeline.setLook(look);
      rig.resize(width, height);
      rig.setBounds(pipeline.parts.ball);
      rig.setView(view, false);
      pipeline.render(rig.camera, rig.view());
      for (const image of images) pipeline.refine(rig.camera, rig.view(), image());
      // The copy is in the queue before this returns: what is copied may go before the copy is there.
      const reading = this.#renderer.readRenderTargetPixelsAsync(this.#output, 0, 0, width, height);
      return reading as Promise<Uint8Array>;
    } finally {
      pipeline.parts.sync([]);
      pipeline.resize(1, 1, 1);
    }
  }

  dispose(): void {
    this.#rig.dispose();
    this.#pipeline.dispose();
    this.#output.dispose();
  }
}

/** WebGL hands rows out from the bottom. */
function upright(
  pixels: Uint8Array,
  width: number,
  height: number,
  flip: boolean,
): Uint8ClampedArray<ArrayBuffer> {
  const row = 4 * width;
  const result = new Uint8ClampedArray(row * height);
  for (let y = 0; y < height; y++) {
    const from = row * (flip ? height - 1 - y : y);
    result.set(pixels.subarray(from, from + row), row * y);
  }
  return result;
}
