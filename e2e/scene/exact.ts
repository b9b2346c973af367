/** The scene with a ball of triangles and one that rays are cast for, which goes through it. */

import { bindField } from '../../src/field/bind.ts';
import { locating } from '../../src/field/polygonize.ts';
import { edgesOf, imageThrough, OFFSETS } from '../../src/field/rayEdges.ts';
import type { RayCamera, RayImage } from '../../src/field/rayImage.ts';
import { emptyImage, SceneCaster, type Standing } from '../../src/field/rayScene.ts';
import { finished } from '../../src/math/finished.ts';
import { placed } from '../../src/mesh/placed.ts';
import {
  createScene,
  DEFAULT_LOOK,
  FRONT_VIEW,
  type Scene,
  type SurfaceImage,
} from '../../src/scene/index.ts';
import { BALLS, type ExactPicture, SIZE } from './exactScene.ts';
import { makeMesh } from './meshes.ts';

export interface ExactStage {
  /** Data addresses of PNGs: with triangles for both, and with the image. */
  draw(picture: ExactPicture): readonly [mesh: string, exact: string];
  /** The same as a picture for a file. */
  file(picture: ExactPicture): Promise<string>;
  dispose(): void;
}

declare global {
  interface Window {
    openExactStage: typeof openExactStage;
    exactStage: ExactStage;
  }
}

const [, BODY] = BALLS;
const BODIES: readonly Standing[] = [
  {
    located: finished(
      locating(bindField({ type: 'shape', shape: { type: 'sphere', radius: BODY.radius } }), 64),
    ),
    placement: { rotation: [0, 0, 0, 1], translation: BODY.centre },
  },
];

const items = (['triangles', 'rays'] as const).map((id, i) => {
  const { centre, radius, colour } = BALLS[i]!;
  const mesh = placed(makeMesh({ kind: 'sphere', radius, rings: 128 }), {
    rotation: [0, 0, 0, 1],
    translation: centre,
  });
  return { id, mesh, colour, preview: false };
});

const viewOf = ({ fov = 0, height = 200 }: ExactPicture) => ({ ...FRONT_VIEW, fov, height });

function imagesOf(picture: ExactPicture): readonly RayImage[] {
  const camera = cameraOf(picture);
  const base = emptyImage(camera);
  const caster = new SceneCaster(BODIES, camera);
  for (let y = 0; y < camera.height; y++) caster.row(base, y);
  const edges = edgesOf(base, camera);
  const others = OFFSETS.map((offset) => {
    const again = emptyImage({ width: edges.length, height: 1 });
    const beside = new SceneCaster(BODIES, { ...camera, offset });
    for (const [i, at] of edges.entries())
      beside.pixel(again, i, at % camera.width, Math.floor(at / camera.width));
    return imageThrough(base, camera, edges, { offset, ...again });
  });
  return [base, ...others];
}

function cameraOf(picture: ExactPicture): RayCamera {
  const [width, height] = picture.cast ?? SIZE;
  return { view: viewOf(picture), width, height, offset: [0.5, 0.5] };
}

function surfaceImages(picture: ExactPicture, device: GPUDevice | null): readonly SurfaceImage[] {
  const camera = cameraOf(picture);
  return imagesOf(picture).map((image, i) => {
    const of = { camera: { ...camera, offset: OFFSETS[i - 1] ?? camera.offset }, items: ['rays'] };
    if (picture.from !== 'buffers' || !device)
      return { ...of, surface: image.surface, colours: image.colours };
    // rows on the device begin at multiples of 256 bytes
    const stride = 16 * Math.ceil(camera.width / 16);
    const upload = (pixels: Float32Array) => {
      const buffer = device.createBuffer({
        size: 16 * stride * camera.height,
        usage: GPUBufferUsage.COPY_SRC | GPUBufferUsage.COPY_DST | GPUBufferUsage.STORAGE,
      });
      for (let y = 0; y < camera.height; y++)
        device.queue.writeBuffer(
          buffer,
          16 * stride * y,
          pixels as Float32Array<ArrayBuffer>,
          4 * camera.width * y,
          4 * camera.width,
        );
      return buffer;
    };
    return { ...of, surface: upload(image.surface), colours: upload(image.colours), stride };
  });
}

function show(scene: Scene, picture: ExactPicture): void {
  scene.resize(...SIZE, 1);
  scene.sync(items);
  scene.select(picture.selected ?? []);
  scene.setLook({ ...DEFAULT_LOOK, ...picture.look });
  scene.rig.setView(viewOf(picture), false);
}

export async function openExactStage(backend: 'auto' | 'webgl2' = 'auto'): Promise<ExactStage> {
  const canvas = document.body.appendChild(document.createElement('canvas'));
  const scene = await createScene(canvas, { backend, lineTexels: 9e6 });
  const png = (draw: (context: CanvasRenderingContext2D) => void): string => {
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = SIZE;
    draw(copy.getContext('2d')!);
    return copy.toDataURL('image/png');
  };
  const stage: ExactStage = {
    draw(picture) {
      show(scene, picture);
      scene.render();
      const mesh = png((context) => context.drawImage(canvas, 0, 0));
      const { known } = picture;
      const images = surfaceImages(picture, scene.device);
      // in part twice, as rows come
      const drawn = known === undefined ? images : [images[0]!, images[0]!];
      for (const image of drawn)
        if (!scene.refine(image, known === undefined ? {} : { known, enough: 2 }))
          throw new Error('no frame to refine');
      return [mesh, png((context) => context.drawImage(canvas, 0, 0))];
    },
    async file(picture) {
      const [width, height] = SIZE;
      const images = surfaceImages(picture, scene.device).map((image) => () => image);
      const look = { ...DEFAULT_LOOK, ...picture.look };
      const taken = await scene.picture({ width, height, view: viewOf(picture), look, items, images });
      return png((context) => context.putImageData(taken, 0, 0));
    },
    dispose() {
      scene.dispose();
      canvas.remove();
    },
  };
  window.exactStage = stage;
  return stage;
}
