/**
 * The private seam: three.js draws buffers that it has not made. For every attribute three's backend keeps a record, and takes
 * the record's `buffer` where there is one instead of making its own; so ours is put there before the first draw, and the attribute's own
 * array stays empty. Nothing is copied, nothing goes up, nothing is read back.
 *
 * three does not promise any of this. Its version is pinned, and tests/scene/seam.test.ts and e2e/scene/device.spec.ts say what must hold.
 */
import {
  BufferAttribute,
  BufferGeometry,
  type DataTexture,
  IndirectStorageBufferAttribute,
  Sphere,
  Vector3,
  type WebGPURenderer,
} from 'three/webgpu';
import type { DeviceMesh } from './deviceMesh.ts';

/** What this file needs of three's backend. */
interface Backend {
  readonly isWebGPUBackend?: boolean;
  readonly device: GPUDevice;
  /** the record of an attribute, made when it is first asked for */
  get(attribute: object): { buffer?: Destroyable; texture?: GPUTexture };
}

interface Destroyable {
  destroy(): void;
}

/** What is drawn of some vertices. */
type Drawn = Pick<DeviceMesh, 'indices' | 'draw'>;
type Role = 'positions' | 'normals' | 'colours' | 'indices' | 'draw';

/** STORAGE: compute passes write all of them, and read the triangles again for their wires */
const NEEDED: Readonly<Record<Role, readonly ('VERTEX' | 'INDEX' | 'INDIRECT' | 'STORAGE')[]>> = {
  positions: ['VERTEX'],
  normals: ['VERTEX'],
  colours: ['VERTEX'],
  indices: ['INDEX', 'STORAGE'],
  draw: ['INDIRECT', 'STORAGE'],
};
/** floats a vertex: a compute pass writes vec4 without gaps */
const FLOATS = 4;
/** in place of a buffer that is taken back: three destroys what it finds */
const NOTHING: Destroyable = { destroy() {} };

export class Seam {
  readonly #backend: Backend;
  readonly #renderer: WebGPURenderer;

  constructor(renderer: WebGPURenderer) {
    this.#renderer = renderer;
    this.#backend = renderer.backend as unknown as Backend;
  }

  /** Throws, in words, where the mesh cannot be drawn. */
  check(mesh: DeviceMesh): void {
    if (!this.#backend.isWebGPUBackend)
      throw new Error(
        'A mesh on the graphics device needs WebGPU, and this picture is drawn by WebGL2: give the scene a mesh of arrays.',
      );
    for (const [role, usage] of Object.entries(NEEDED)) {
      const missing = usage.find((name) => !(mesh[role as Role].usage & GPUBufferUsage[name]));
      if (missing)
        throw new Error(`The buffer “${role}” of a mesh on the graphics device lacks the usage ${missing}.`);
    }
  }

  /** Where the buffers must be from. */
  get device(): GPUDevice {
    return this.#backend.device;
  }

  /** Draws the mesh's buffers; to be given to `end`, never only disposed. */
  geometry(mesh: DeviceMesh, painted: boolean): BufferGeometry {
    const geometry = this.#places(mesh, mesh);
    geometry.setAttribute('normal', this.#lent(mesh.normals));
    if (painted) geometry.setAttribute('colour', this.#lent(mesh.colours));
    return geometry;
  }

  /** The same for lines between the mesh's vertices. */
  lines(mesh: DeviceMesh, lines: Drawn): BufferGeometry {
    return this.#places(mesh, lines);
  }

  /** Copies a buffer of four f32 a texel into a texture, on the device; `stride`: texels from row to row. */
  fill(texture: DataTexture, buffer: GPUBuffer, stride: number): void {
    const { width, height } = texture.image;
    this.#renderer.initTexture(texture);
    const { device } = this.#backend;
    const encoder = device.createCommandEncoder();
    const target = (this.#backend.get(texture) as { readonly texture: GPUTexture }).texture;
    encoder.copyBufferToTexture({ buffer, bytesPerRow: 16 * stride }, { texture: target }, [width, height]);
    device.queue.submit([encoder.finish()]);
  }

  /** Takes the buffers back, which stay as they are; what three made for them goes. */
  end(geometry: BufferGeometry): void {
    const { index, indirect } = geometry;
    const lent = [...Object.values(geometry.attributes), index, indirect].filter((each) => each !== null);
    for (const attribute of lent) this.#backend.get(attribute).buffer = NOTHING;
    geometry.dispose();
    // three forgets this one
    indirect?.dispose();
  }

  #places({ positions, box }: DeviceMesh, { indices, draw }: Drawn): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.#lent(positions));
    geometry.setIndex(this.#lend(new BufferAttribute(new Uint32Array(0), 1), indices));
    geometry.setIndirect(this.#lend(new IndirectStorageBufferAttribute(new Uint32Array(0), 1), draw));
    geometry.boundingSphere = sphereAround(box);
    return geometry;
  }

  #lent(buffer: GPUBuffer): BufferAttribute {
    return this.#lend(new BufferAttribute(new Float32Array(0), FLOATS), buffer);
  }

  #lend<A extends BufferAttribute>(attribute: A, buffer: GPUBuffer): A {
    this.#backend.get(attribute).buffer = buffer;
    return attribute;
  }
}

function sphereAround({ min, max }: DeviceMesh['box']): Sphere {
  const corner = new Vector3(...max);
  const centre = new Vector3(...min).add(corner).multiplyScalar(0.5);
  return new Sphere(centre, centre.distanceTo(corner));
}
