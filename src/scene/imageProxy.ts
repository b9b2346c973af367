/** What stands in the passes for the items that are drawn from an image: a triangle over all of the screen in each. */
import { BufferAttribute, BufferGeometry, type Material, Mesh, type Scene } from 'three/webgpu';
import { MASK_ORDER } from './selection.ts';

/** The passes, by their scenes. */
export interface Passes {
  readonly lines: Scene;
  readonly colour: Scene;
  readonly preview: Scene;
  readonly selection: Scene;
}

export interface ImageMaterials {
  ofImage(pass: 'line' | 'occluder' | 'silhouette' | 'others' | 'seen'): Material;
}

export class ImageProxy {
  readonly #geometry = new BufferGeometry();
  readonly #all: readonly Mesh[];
  readonly #fill: Mesh;

  constructor({ lines, colour, preview, selection }: Passes, materials: ImageMaterials) {
    const corners = new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]);
    this.#geometry.setAttribute('position', new BufferAttribute(corners, 3));
    const put = (scene: Scene, material: Material, order = 0): Mesh => {
      const mesh = new Mesh(this.#geometry, material);
      mesh.name = 'image';
      mesh.frustumCulled = false;
      mesh.matrixAutoUpdate = false;
      mesh.renderOrder = order;
      mesh.visible = false;
      scene.add(mesh);
      return mesh;
    };
    const occluder = materials.ofImage('occluder');
    this.#fill = put(colour, occluder);
    this.#all = [
      this.#fill,
      put(lines, materials.ofImage('line')),
      put(preview, occluder),
      put(selection, materials.ofImage('silhouette'), MASK_ORDER.silhouette),
      put(selection, materials.ofImage('others'), MASK_ORDER.others),
      put(selection, materials.ofImage('seen'), MASK_ORDER.seen),
    ];
  }

  set fill(material: Material) {
    this.#fill.material = material;
  }

  set visible(on: boolean) {
    for (const mesh of this.#all) mesh.visible = on;
  }

  dispose(): void {
    for (const mesh of this.#all) mesh.removeFromParent();
    this.#geometry.dispose();
  }
}
