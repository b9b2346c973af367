/** The scene with a mesh whose arrays are on the device: made there from a mesh of arrays, changed there, drawn, counted. */

import { bounds } from '../../src/mesh/measure.ts';
import type { Box, Mesh } from '../../src/mesh/mesh.ts';
import {
  createScene,
  DEFAULT_LOOK,
  type DeviceMesh,
  FRONT_VIEW,
  type Hit,
  type Look,
  type Scene,
  type SceneItem,
} from '../../src/scene/index.ts';
import { makeMesh } from './meshes.ts';

/** What a test does with the one body on its page. */
export interface DeviceStage {
  /** The same body, from arrays or from buffers; `selected`: with the blue contour. */
  show(how: 'arrays' | 'buffers', more?: { preview?: boolean; selected?: boolean }): void;
  /** The body is drawn from buffers with room for more, then those before are destroyed. */
  grow(): void;
  /** The GPU alone makes the number of indices half of what it is. */
  halve(): Promise<void>;
  /** The same with arrays. */
  showHalf(): void;
  /** Data address of a PNG; without a look in the last one. */
  picture(look?: Partial<Look>): string;
  /** The same as a picture for a file, from buffers. */
  file(look: Partial<Look>): Promise<string>;
  pick(x: number, y: number): Hit | null;
  keep(): boolean;
  fade(share: number): void;
  /** Vertices, indices and draw counts that went up while `work` ran, bytes. */
  upwards(work: () => void): number;
  /** Whether the body's buffers can still be read on the device. */
  areAlive(): Promise<boolean>;
  /** What the scene says to a body whose indices are no index buffer. */
  refusal(): string;
  clear(): void;
  dispose(): void;
}

declare global {
  interface Window {
    openDeviceStage: typeof openDeviceStage;
    stage: DeviceStage;
  }
}

const SIZE = 256;
const COLOUR = '#d9cb4a';

/** A sphere with all colours of the cube around it. */
function body(): Mesh {
  const sphere = makeMesh({ kind: 'sphere', radius: 60, rings: 64 });
  return { ...sphere, colours: sphere.normals.map((value) => value / 2 + 0.5) };
}

const half = (mesh: Mesh): Mesh => ({ ...mesh, indices: mesh.indices.slice(0, mesh.indices.length / 2) });

/** Three a vertex → four, the last of which is nonsense. */
function fours(threes: Float32Array): Float32Array<ArrayBuffer> {
  return Float32Array.from({ length: (threes.length / 3) * 4 }, (_, i) =>
    i % 4 === 3 ? Number.NaN : threes[3 * (i >> 2) + (i % 4)]!,
  );
}

/** As a compute pass would leave them; `room` times as large as they must be, the rest filled with nonsense. */
function toDevice(device: GPUDevice, mesh: Mesh, room: number): DeviceMesh {
  const { VERTEX, INDEX, INDIRECT, STORAGE, COPY_DST, COPY_SRC } = GPUBufferUsage;
  const made = (usage: number, data: Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>, times = room) => {
    const size = data.byteLength * times;
    const buffer = device.createBuffer({ size, usage: usage | STORAGE | COPY_DST | COPY_SRC });
    device.queue.writeBuffer(buffer, 0, new Uint8Array(size).fill(0x7f));
    device.queue.writeBuffer(buffer, 0, data);
    return buffer;
  };
  return {
    positions: made(VERTEX, fours(mesh.positions)),
    normals: made(VERTEX, fours(mesh.normals)),
    colours: made(VERTEX, fours(mesh.colours!)),
    indices: made(INDEX, new Uint32Array(mesh.indices)),
    draw: made(INDIRECT, new Uint32Array([mesh.indices.length, 1, 0, 0, 0]), 1),
    box: bounds(mesh),
  };
}

const buffersOf = ({ positions, normals, colours, indices, draw }: DeviceMesh) => [
  positions,
  normals,
  colours,
  indices,
  draw,
];

function halveOnDevice(device: GPUDevice, draw: GPUBuffer): void {
  const code = `@group(0) @binding(0) var<storage, read_write> draw: array<u32>;
    @compute @workgroup_size(1) fn main() { draw[0] = draw[0] / 2u; }`;
  const module = device.createShaderModule({ code });
  const pipeline = device.createComputePipeline({ layout: 'auto', compute: { module } });
  const entries = [{ binding: 0, resource: { buffer: draw } }];
  const encoder = device.createCommandEncoder();
  const pass = encoder.beginComputePass();
  pass.setPipeline(pipeline);
  pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }));
  pass.dispatchWorkgroups(1);
  pass.end();
  device.queue.submit([encoder.finish()]);
}

/** Bytes of what draws triangles that were written or made with content while `work` ran. */
function counted(device: GPUDevice, work: () => void): number {
  const { VERTEX, INDEX, INDIRECT } = GPUBufferUsage;
  let bytes = 0;
  const add = (usage: number, size: number) => {
    if (usage & (VERTEX | INDEX | INDIRECT)) bytes += size;
  };
  const { queue } = device;
  device.createBuffer = (descriptor) => {
    add(descriptor.usage, descriptor.size);
    return GPUDevice.prototype.createBuffer.call(device, descriptor);
  };
  queue.writeBuffer = (...of: Parameters<GPUQueue['writeBuffer']>) => {
    add(of[0].usage, of[4] ?? of[2].byteLength);
    GPUQueue.prototype.writeBuffer.apply(queue, of);
  };
  try {
    work();
  } finally {
    Reflect.deleteProperty(device, 'createBuffer');
    Reflect.deleteProperty(queue, 'writeBuffer');
  }
  return bytes;
}

class Stage implements DeviceStage {
  readonly #scene: Scene;
  readonly #canvas: HTMLCanvasElement;
  readonly #mesh = body();
  readonly #frame = cornersOf(bounds(this.#mesh));
  #onDevice: DeviceMesh | null = null;

  constructor(scene: Scene, canvas: HTMLCanvasElement) {
    this.#scene = scene;
    this.#canvas = canvas;
    scene.resize(SIZE, SIZE, 1);
    scene.rig.setView(FRONT_VIEW, false);
  }

  show(how: 'arrays' | 'buffers', { preview = false, selected = false } = {}): void {
    this.#sync(how === 'arrays' ? this.#mesh : this.#buffers(), preview);
    this.#scene.select(selected ? ['body'] : []);
  }

  grow(): void {
    const old = this.#buffers();
    this.#onDevice = toDevice(this.#scene.device!, this.#mesh, 3);
    this.#sync(this.#onDevice);
    for (const buffer of buffersOf(old)) buffer.destroy();
  }

  async halve(): Promise<void> {
    halveOnDevice(this.#scene.device!, this.#buffers().draw);
  }

  showHalf(): void {
    this.#sync(half(this.#mesh));
  }

  picture(look?: Partial<Look>): string {
    if (look) this.#scene.setLook({ ...DEFAULT_LOOK, ...look });
    this.#scene.render();
    // in the task that drew it the canvas still holds its picture
    return png((context) => context.drawImage(this.#canvas, 0, 0));
  }

  async file(look: Partial<Look>): Promise<string> {
    const image = await this.#scene.picture({
      width: SIZE,
      height: SIZE,
      view: FRONT_VIEW,
      look: { ...DEFAULT_LOOK, ...look },
      items: [{ id: 'body', mesh: this.#buffers(), colour: COLOUR, preview: false }, this.#frame],
    });
    return png((context) => context.putImageData(image, 0, 0));
  }

  pick(x: number, y: number): Hit | null {
    return this.#scene.pick(x, y);
  }

  keep(): boolean {
    return this.#scene.keep();
  }

  fade(share: number): void {
    this.#scene.fade(share);
  }

  upwards(work: () => void): number {
    return counted(this.#scene.device!, work);
  }

  async areAlive(): Promise<boolean> {
    const device = this.#scene.device!;
    device.pushErrorScope('validation');
    const encoder = device.createCommandEncoder();
    const target = device.createBuffer({ size: 16, usage: GPUBufferUsage.COPY_DST });
    for (const buffer of buffersOf(this.#buffers())) encoder.copyBufferToBuffer(buffer, 0, target, 0, 16);
    device.queue.submit([encoder.finish()]);
    target.destroy();
    return (await device.popErrorScope()) === null;
  }

  refusal(): string {
    const mesh = this.#buffers();
    try {
      this.#sync({ ...mesh, indices: mesh.positions });
      return '';
    } catch (error) {
      return (error as Error).message;
    }
  }

  clear(): void {
    this.#scene.sync([this.#frame]);
  }

  dispose(): void {
    this.#scene.dispose();
    for (const buffer of this.#onDevice ? buffersOf(this.#onDevice) : []) buffer.destroy();
    this.#canvas.remove();
  }

  #buffers(): DeviceMesh {
    const { device } = this.#scene;
    // without a device there are none, and the scene has to refuse before it looks
    if (!device) return { draw: {}, box: bounds(this.#mesh) } as DeviceMesh;
    this.#onDevice ??= toDevice(device, this.#mesh, 1);
    return this.#onDevice;
  }

  #sync(mesh: SceneItem['mesh'], preview = false): void {
    this.#scene.sync([{ id: 'body', mesh, colour: COLOUR, preview }, this.#frame]);
  }
}

/** Data address. */
function png(draw: (context: CanvasRenderingContext2D) => void): string {
  const copy = document.createElement('canvas');
  copy.width = copy.height = SIZE;
  draw(copy.getContext('2d')!);
  return copy.toDataURL('image/png');
}

/** Nothing to be seen, around which the sphere is that of the box: lines and ink measure depth over it. */
function cornersOf({ min, max }: Box): SceneItem {
  const ends = new Float32Array([...min, ...max]);
  const mesh = { positions: ends, normals: ends, uvs: new Float32Array(4), indices: new Uint32Array(0) };
  return { id: 'corners', mesh, colour: COLOUR, preview: false };
}

export async function openDeviceStage(backend: 'auto' | 'webgl2' = 'auto'): Promise<DeviceStage> {
  const canvas = document.body.appendChild(document.createElement('canvas'));
  const scene = await createScene(canvas, { backend });
  window.stage = new Stage(scene, canvas);
  return window.stage;
}
