/** Lines of the program's own over the picture, in blue pencil: what lies before the parts is seen, what is in them not. */
import { uniform, vec4 } from 'three/tsl';
import {
  BufferAttribute,
  BufferGeometry,
  CustomBlending,
  LineSegments,
  MeshBasicNodeMaterial,
  OneFactor,
  OneMinusSrcAlphaFactor,
  Vector3,
} from 'three/webgpu';

const OPACITY = 0.5;

export class Guides {
  readonly lines: LineSegments;
  readonly #colour = uniform(new Vector3());
  #ends: Float32Array | null = null;

  constructor() {
    this.lines = new LineSegments(new BufferGeometry(), this.#material());
    this.lines.name = 'guides';
    this.lines.visible = false;
    this.lines.frustumCulled = false;
    // after the parts and the grid, over which they are blended
    this.lines.renderOrder = 3;
  }

  setColour(rgb: readonly [number, number, number]): void {
    this.#colour.value.set(...rgb);
  }

  /** Six numbers a line, mm; null: none. False where they are there already. */
  put(ends: Float32Array | null): boolean {
    if (ends === this.#ends) return false;
    this.#ends = ends;
    this.lines.visible = ends !== null && ends.length > 0;
    this.lines.geometry.dispose();
    this.lines.geometry = new BufferGeometry();
    if (ends) this.lines.geometry.setAttribute('position', new BufferAttribute(ends, 3));
    return true;
  }

  dispose(): void {
    this.lines.geometry.dispose();
    (this.lines.material as MeshBasicNodeMaterial).dispose();
  }

  #material(): MeshBasicNodeMaterial {
    const material = new MeshBasicNodeMaterial();
    material.name = 'guides';
    material.transparent = true;
    material.depthWrite = false;
    // premultiplied, see the page pass
    material.blending = CustomBlending;
    material.blendSrc = OneFactor;
    material.blendDst = OneMinusSrcAlphaFactor;
    material.fragmentNode = vec4(this.#colour.mul(OPACITY), OPACITY);
    return material;
  }
}
