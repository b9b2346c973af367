/**
 * Rays onto fields on the GPU, a thread a pixel. Twin of field/rayImage.ts: what is cast lies in two buffers on the device, which the scene
 * draws from where they are; bodies that are cast one after the other cover each other.
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
  /** Asks the device: what was asked of skels, in terms at places. */
  work(): Promise<number>;
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

export function gpuRaycaster(device: GPUDevice): GpuRaycaster {
  const stages = rayStagesOn(device);
  const work = new Buffers(device);
  return {
    async cast(bodies, camera) {
      const own = new Buffers(device);
      const image = imageOf(own, camera);
      clear(device, image, camera);
      for (const { node, bricks } of bodies) {
        const program = programOf(node);
        if (!isCulledOnDevice(program))
          throw new RangeError('a tree that rays on the device know no bounds of');
        const packed = 'lists' in bricks ? bricks : packBricks(node, bricks);
        castOne(device, await stages(program.ingredients), work, image, camera, {
          packed,
          ...boundedProgram(node, program),
          program,
          plain: bindField(node).near(new Tally()).plain,
        });
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
    work: buffers.get('work', 4, usage),
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
  const bound = {
    ...field,
    ...image,
    blocks: work.get('blocks', 4 * blocks, USAGE.storage),
    camera: work.put('camera', RAY_CAMERA.pack([cameraRecord(camera, leaves, size, plain)]), USAGE.uniform),
  };
  const encoder = device.createCommandEncoder({ label: 'raycast' });
  const pass = encoder.beginComputePass({ label: 'raycast' });
  bind(device, pass, stages.blocks, 0, RAY_STAGES.blocks, bound);
  pass.dispatchWorkgroups(Math.ceil(blocks / 64));
  bind(device, pass, stages.cast, 0, RAY_STAGES.cast, bound);
  bind(device, pass, stages.cast, 1, { records: 0, lists: 1 }, bound);
  pass.dispatchWorkgroups(Math.ceil(camera.width / GROUP), Math.ceil(camera.height / GROUP));
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
      return new Uint32Array(bytes!)[0]!;
    },
    async read() {
      const [at, painted] = await readBack(device, [surface, colours]);
      return { width, height, surface: new Float32Array(at!), colours: new Float32Array(painted!) };
    },
    destroy: () => own.destroy(),
  };
}
