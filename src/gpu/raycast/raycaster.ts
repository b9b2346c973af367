/**
 * Rays onto fields on the GPU, a thread a pixel. Twin of field/rayScene.ts: several bodies, each where it was put, in each pixel the nearest;
 * a body is asked only where its lattice may be seen, and before what is there already. What is cast stays on the device, as the
 * scene draws it (scene/surfaceImage.ts).
 */
import type { FieldNode } from '../../field/node.ts';
import type { RayCamera, RayImage } from '../../field/rayImage.ts';
import { type Frame, frameOf, viewFrom } from '../../field/rayScene.ts';
import { type Placement, UNMOVED } from '../../math/placement.ts';
import { Buffers, readBack, type Slice, USAGE } from '../polygonize/buffers.ts';
import type { Where } from '../polygonize/polygonizer.ts';
import { bindGroup } from './bindGroup.ts';
import { BodyMaker, type DeviceBody } from './body.ts';
import { CAMERA_STRIDE, packShots, type Shot } from './camera.ts';
import { loadClear, RAY_CAMERA, RAY_STAGES } from './stages.ts';

/** A picture on the device; vec4f a pixel each, as in RayImage. */
export interface DeviceImage {
  readonly width: number;
  readonly height: number;
  /** pixels from row to row: rows that are copied into textures begin at multiples of 256 bytes */
  readonly stride: number;
  readonly surface: GPUBuffer;
  readonly colours: GPUBuffer;
  /** Asks the device: terms that were asked, nearly (rounded up to sixteen a ray), and rays that were given up. */
  work(): Promise<{ readonly terms: number; readonly lost: number }>;
  read(): Promise<RayImage>;
  destroy(): void;
}

/** A body in the model. */
export interface PlacedBody {
  readonly body: DeviceBody;
  readonly placement: Placement;
}

export interface GpuRaycaster {
  /** Brings a body onto the device; see BodyMaker.make. */
  body(node: FieldNode, where: Where): Promise<DeviceBody>;
  /** Room for a picture. RangeError for more than every device binds. */
  image(width: number, height: number): DeviceImage;
  /**
   * Begins rows of a picture, from … to before …: first of all row 0, with which what was there goes. The fourth of the colours is 1 + the
   * place of the body in the list. The camera has the picture's size. What the device refuses is told to its error scopes. Returns how many
   * rays there are, a pixel's of each body.
   */
  cast(
    image: DeviceImage,
    bodies: readonly PlacedBody[],
    camera: RayCamera,
    from?: number,
    to?: number,
  ): number;
  /** Gives all back but bodies and images. */
  destroy(): void;
}

const GROUP = 8;
/** of one dispatch: what takes a slow device long in one piece it is thought to have died of */
const MOST_RAYS = 1 << 17;
/** pixels: of four f32 each in 256 bytes */
const ROW_PIXELS = 16;

export async function gpuRaycaster(device: GPUDevice): Promise<GpuRaycaster> {
  const clear = await loadClear(device);
  const maker = new BodyMaker(device);
  const work = new Buffers(device);
  return {
    body: (node, where) => maker.make(node, where),
    image: (width, height) => new Picture(device, width, height),
    cast(image, bodies, camera, from = 0, to = camera.height) {
      const picture = image as Picture;
      if (from === 0) picture.clear(work, clear, camera);
      const rows = GROUP * Math.max(1, Math.floor(MOST_RAYS / camera.width / GROUP));
      let rays = 0;
      for (let row = from; row < to; row += rows)
        rays += castRows(device, work, picture, bodies, camera, [row, Math.min(row + rows, to)]);
      return rays;
    },
    destroy() {
      maker.destroy();
      work.destroy();
    },
  };
}

/** All bodies, one after the other: what is there already ends the rays of the next. */
function castRows(
  device: GPUDevice,
  work: Buffers,
  picture: Picture,
  bodies: readonly PlacedBody[],
  camera: RayCamera,
  rows: readonly [from: number, to: number],
): number {
  const shots = bodies
    .map((each, i) => shotOf(each, i + 1, camera, picture.stride, rows))
    .filter(({ frame }) => frame.left < frame.right && frame.top < frame.bottom);
  if (shots.length === 0) return 0;
  const cameras = work.put('cameras', packShots(shots), USAGE.uniform);
  const encoder = device.createCommandEncoder({ label: 'raycast' });
  const pass = encoder.beginComputePass({ label: 'raycast' });
  for (const [i, { body, frame }] of shots.entries()) {
    const own = { ...cameras, offset: CAMERA_STRIDE * i, size: RAY_CAMERA.size };
    const bound = { ...body.bound, ...picture.bound, camera: own };
    const { cast } = body.stages;
    pass.setPipeline(cast);
    pass.setBindGroup(0, bindGroup(device, cast, 0, RAY_STAGES.cast, bound));
    pass.setBindGroup(1, bindGroup(device, cast, 1, { records: 0, lists: 1 }, bound));
    pass.dispatchWorkgroups(...groupsOver(frame));
  }
  pass.end();
  device.queue.submit([encoder.finish()]);
  return shots.reduce((sum, { frame }) => sum + areaOf(frame), 0);
}

const areaOf = ({ left, right, top, bottom }: Frame): number => (right - left) * (bottom - top);

function shotOf(
  { body, placement }: PlacedBody,
  number: number,
  camera: RayCamera,
  stride: number,
  [from, to]: readonly [from: number, to: number],
): Shot & { readonly body: DeviceBody } {
  const own = { ...camera, view: viewFrom(placement, camera.view) };
  const { left, right, top, bottom } = frameOf(body.lattice, own);
  const frame = { left, right, top: Math.max(top, from), bottom: Math.min(bottom, to) };
  return { camera: own, body, rotation: placement.rotation, number, frame, stride };
}

const groupsOver = ({ left, right, top, bottom }: Frame): [x: number, y: number] => [
  Math.ceil((right - left) / GROUP),
  Math.ceil((bottom - top) / GROUP),
];

class Picture implements DeviceImage {
  readonly width: number;
  readonly height: number;
  readonly stride: number;
  readonly bound: Readonly<Record<'surface' | 'colours' | 'work', Slice>>;
  readonly #device: GPUDevice;
  readonly #own: Buffers;

  constructor(device: GPUDevice, width: number, height: number) {
    this.#device = device;
    this.#own = new Buffers(device);
    this.width = width;
    this.height = height;
    this.stride = ROW_PIXELS * Math.ceil(width / ROW_PIXELS);
    const usage = USAGE.storage | USAGE.copySource;
    const bytes = 16 * this.stride * height;
    this.bound = {
      surface: this.#own.get('surface', bytes, usage),
      colours: this.#own.get('colours', bytes, usage),
      work: this.#own.get('work', 8, usage | USAGE.copyTarget),
    };
  }

  get surface(): GPUBuffer {
    return this.bound.surface.buffer;
  }

  get colours(): GPUBuffer {
    return this.bound.colours.buffer;
  }

  clear(work: Buffers, pipeline: GPUComputePipeline, camera: RayCamera): void {
    const device = this.#device;
    const frame = { left: 0, right: this.stride, top: 0, bottom: this.height };
    const { rotation } = UNMOVED;
    const shot = { camera, body: null, rotation, number: 0, frame, stride: this.stride };
    const bound = { ...this.bound, camera: work.put('whole', packShots([shot]), USAGE.uniform) };
    const encoder = device.createCommandEncoder({ label: 'raycast clear' });
    encoder.clearBuffer(this.bound.work.buffer);
    const pass = encoder.beginComputePass({ label: 'raycast clear' });
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, bindGroup(device, pipeline, 0, RAY_STAGES.clear, bound));
    pass.dispatchWorkgroups(...groupsOver(frame));
    pass.end();
    device.queue.submit([encoder.finish()]);
  }

  async work(): Promise<{ readonly terms: number; readonly lost: number }> {
    const [bytes] = await readBack(this.#device, [this.bound.work]);
    const [sixteenths, lost] = new Uint32Array(bytes!);
    return { terms: 16 * sixteenths!, lost: lost! };
  }

  async read(): Promise<RayImage> {
    const { width, height, stride, bound } = this;
    const rows = (bytes: ArrayBuffer) => {
      const padded = new Float32Array(bytes);
      const pixels = new Float32Array(4 * width * height);
      for (let row = 0; row < height; row++)
        pixels.set(padded.subarray(4 * stride * row, 4 * (stride * row + width)), 4 * width * row);
      return pixels;
    };
    const [surface, colours] = await readBack(this.#device, [bound.surface, bound.colours]);
    return { width, height, surface: rows(surface!), colours: rows(colours!) };
  }

  destroy(): void {
    this.#own.destroy();
  }
}
