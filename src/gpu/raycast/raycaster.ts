/**
 * Rays onto fields on the GPU, a thread a pixel. Twin of field/rayImage.ts: what is cast lies in two buffers on the device; bodies that are
 * cast one after the other cover each other. The application does not use it yet: the scene's images have padded rows and numbers of bodies.
 */

import { bindField } from '../../field/bind.ts';
import { Tally } from '../../field/near.ts';
import type { Colour, FieldNode } from '../../field/node.ts';
import type { PackedBricks } from '../../field/packedBricks.ts';
import { NOWHERE, type RayCamera, type RayImage } from '../../field/rayImage.ts';
import { rotate3 } from '../../math/tuple.ts';
import type { Vec3 } from '../../math/vec.ts';
import { shapes } from '../../shape/index.ts';
import { eyeDistance } from '../../stroke/plane.ts';
import { boundedProgram } from '../bricks/bounds.ts';
import { isCulledOnDevice } from '../bricks/cullsOnDevice.ts';
import { namesOf } from '../ingredients.ts';
import { Buffers, readBack, type Slice, USAGE } from '../polygonize/buffers.ts';
import { uploadField } from '../polygonize/encode.ts';
import { type ListedBricks, packBricks } from '../polygonize/lists.ts';
import { type Program, programOf } from '../program.ts';
import { RAY_CAMERA, RAY_STAGES, type RayStages, rayStagesOn } from './stages.ts';

/** A picture on the device; vec4f a pixel each, as in RayImage. */
export interface DeviceImage {
  readonly width: number;
  readonly height: number;
  readonly surface: GPUBuffer;
  readonly colours: GPUBuffer;
  /** Asks the device: terms that were asked, nearly (rounded up to sixteen a ray), and rays that were given up. */
  work(): Promise<{ readonly terms: number; readonly lost: number }>;
  read(): Promise<RayImage>;
  destroy(): void;
}

/** A body and where its surface may be. */
export interface CastBody {
  readonly node: FieldNode;
  readonly bricks: ListedBricks | PackedBricks;
}

export interface GpuRaycaster {
  /** Resolves when the device has taken the work. RangeError for trees that it has no bounds for (`castsOnDevice`). */
  cast(bodies: readonly CastBody[], camera: RayCamera): Promise<DeviceImage>;
  destroy(): void;
}

/** Whether the device knows bounds for all that the tree is made of. FieldError for what has no field. */
export const castsOnDevice = (node: FieldNode): boolean => isCastOnDevice(programOf(node));

/** Maps of cross sections, and shapes whose values are no distances, say nothing of what is ahead. */
const isCastOnDevice = (program: Program): boolean =>
  isCulledOnDevice(program) &&
  program.ingredients.sections.size === 0 &&
  namesOf(program.ingredients, 'shapes').every((name) => shapes[name].exact);

const GROUP = 8;
/** of one dispatch */
const MOST_RAYS = 1 << 17;

export function gpuRaycaster(device: GPUDevice): GpuRaycaster {
  const stages = rayStagesOn(device);
  const work = new Buffers(device);
  return {
    async cast(bodies, camera) {
      const own = new Buffers(device);
      const image = imageOf(own, camera);
      clear(device, image, camera);
      try {
        for (const { node, bricks } of bodies) {
          const program = programOf(node);
          if (!isCastOnDevice(program))
            throw new RangeError('a tree that rays on the device know no bounds of');
          const packed = 'lists' in bricks ? bricks : packBricks(node, bricks);
          castOne(device, await stages(program.ingredients), work, image, camera, {
            packed,
            ...boundedProgram(node, program),
            program,
            plain: bindField(node).near(new Tally()).plain,
          });
        }
      } catch (error) {
        own.destroy();
        throw error;
      }
      return deviceImage(device, own, image, camera);
    },
    destroy() {
      work.destroy();
    },
  };
}

interface Image {
  readonly surface: Slice;
  readonly colours: Slice;
  readonly work: Slice;
}

function imageOf(buffers: Buffers, { width, height }: RayCamera): Image {
  const usage = USAGE.storage | USAGE.copySource | USAGE.copyTarget;
  return {
    surface: buffers.get('surface', 16 * width * height, usage),
    colours: buffers.get('colours', 16 * width * height, usage),
    work: buffers.get('work', 8, usage),
  };
}

function clear(device: GPUDevice, { surface, colours, work }: Image, { width, height }: RayCamera): void {
  const nowhere = new Float32Array(4 * width * height);
  for (let i = 3; i < nowhere.length; i += 4) nowhere[i] = NOWHERE;
  device.queue.writeBuffer(surface.buffer, 0, nowhere);
  const encoder = device.createCommandEncoder();
  for (const slice of [colours, work]) encoder.clearBuffer(slice.buffer, 0, slice.size);
  device.queue.submit([encoder.finish()]);
}

interface Body {
  readonly program: ReturnType<typeof programOf>;
  readonly records: ArrayBuffer;
  readonly leaves: number;
  readonly packed: PackedBricks;
  readonly plain: Colour | null;
}

function castOne(
  device: GPUDevice,
  stages: RayStages,
  work: Buffers,
  image: Image,
  camera: RayCamera,
  { program, records, leaves, packed, plain }: Body,
): void {
  const field = uploadField(work, { ...program, records }, packed, { vertices: 0, triangles: 0 });
  const { counts, step } = packed.lattice;
  const blocks = counts.reduce((product, nodes) => product * Math.ceil((nodes - 1) / 16), 1);
  const size = (Math.max(...counts) - 1) * step;
  const shared = { ...field, ...image, blocks: work.get('blocks', 4 * blocks, USAGE.storage) };
  const encoder = device.createCommandEncoder({ label: 'raycast blocks' });
  const pass = encoder.beginComputePass({ label: 'raycast blocks' });
  bind(device, pass, stages.blocks, 0, RAY_STAGES.blocks, shared);
  pass.dispatchWorkgroups(Math.ceil(blocks / 64));
  pass.end();
  device.queue.submit([encoder.finish()]);
  // in parts: what takes a slow device long in one piece it is thought to have died of
  const rows = GROUP * Math.max(1, Math.floor(MOST_RAYS / camera.width / GROUP));
  for (let row = 0; row < camera.height; row += rows) {
    const record = cameraRecord(camera, leaves, size, plain, row);
    castRows(
      device,
      stages,
      { ...shared, camera: work.put('camera', RAY_CAMERA.pack([record]), USAGE.uniform) },
      [Math.ceil(camera.width / GROUP), Math.ceil(Math.min(rows, camera.height - row) / GROUP)],
    );
  }
}

function castRows(
  device: GPUDevice,
  stages: RayStages,
  bound: Readonly<Record<string, Slice>>,
  groups: readonly [x: number, y: number],
): void {
  const encoder = device.createCommandEncoder({ label: 'raycast' });
  const pass = encoder.beginComputePass({ label: 'raycast' });
  bind(device, pass, stages.cast, 0, RAY_STAGES.cast, bound);
  bind(device, pass, stages.cast, 1, { records: 0, lists: 1 }, bound);
  pass.dispatchWorkgroups(...groups);
  pass.end();
  device.queue.submit([encoder.finish()]);
}

function bind(
  device: GPUDevice,
  pass: GPUComputePassEncoder,
  pipeline: GPUComputePipeline,
  index: number,
  bindings: Readonly<Record<string, number>>,
  bound: Readonly<Record<string, Slice>>,
): void {
  const entries = Object.entries(bindings).map(([name, binding]) => ({ binding, resource: bound[name]! }));
  pass.setPipeline(pipeline);
  pass.setBindGroup(index, device.createBindGroup({ layout: pipeline.getBindGroupLayout(index), entries }));
}

function cameraRecord(
  { view, width, height, offset }: RayCamera,
  leaves: number,
  size: number,
  plain: Colour | null,
  row: number,
) {
  const axis = (v: Vec3) => rotate3(view.rotation, v);
  return {
    pivot: view.pivot,
    pixel: view.height / height,
    right: axis([1, 0, 0]),
    distance: eyeDistance(view) ?? 0,
    up: axis([0, 1, 0]),
    size,
    back: axis([0, 0, 1]),
    leaves,
    picture: [width, height],
    offset,
    colour: plain ? [...plain, 1] : [0, 0, 0, 0],
    row,
  };
}

function deviceImage(
  device: GPUDevice,
  own: Buffers,
  { surface, colours, work }: Image,
  { width, height }: RayCamera,
): DeviceImage {
  return {
    width,
    height,
    surface: surface.buffer,
    colours: colours.buffer,
    async work() {
      const [bytes] = await readBack(device, [work]);
      const [sixteenths, lost] = new Uint32Array(bytes!);
      return { terms: 16 * sixteenths!, lost: lost! };
    },
    async read() {
      const [at, painted] = await readBack(device, [surface, colours]);
      return { width, height, surface: new Float32Array(at!), colours: new Float32Array(painted!) };
    },
    destroy: () => own.destroy(),
  };
}
