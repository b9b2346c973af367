/** The triangles of a mesh on the device, as lines: three.js would make them from arrays, so the device makes them itself. */
import type { BufferGeometry } from 'three/webgpu';
import { Wires } from '../gpu/wires.ts';
import type { DeviceMesh } from './deviceMesh.ts';
import type { Seam } from './seam.ts';

export class DeviceWires {
  readonly geometry: BufferGeometry;
  readonly #wires: Wires;
  readonly #seam: Seam;

  constructor(seam: Seam, mesh: DeviceMesh) {
    this.#seam = seam;
    this.#wires = new Wires(seam.device, mesh.indices, mesh.draw);
    this.geometry = seam.lines(mesh, this.#wires);
  }

  /** Before each frame: nobody tells when the triangles are others. */
  update(): void {
    this.#wires.update();
  }

  end(): void {
    this.#seam.end(this.geometry);
    this.#wires.destroy();
  }
}
