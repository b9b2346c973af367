/**
 * Items of the document → what three draws. An item's geometry is uploaded once and shared by its mesh in every
 * pass; items are told apart by id and compared by reference, since documents never change in place.
 *
 * three keeps pipelines and buffers of its own for every mesh until it is told that the mesh has gone; forgetting a
 * mesh leaks them, and with its last mesh a pipeline goes too. So a mesh outlives its geometry: one set of them is
 * kept for the next part, the others are told goodbye.
 */
import {
  BufferAttribute,
  BufferGeometry,
  type EventDispatcher,
  LineSegments,
  type Material,
  Sphere,
  Mesh as ThreeMesh,
  Scene as ThreeScene,
  Vector3,
  Vector4,
} from 'three/webgpu';
import { DEFAULT_FINISH, type Finish } from '../document/finish.ts';
import type { Mesh } from '../mesh/mesh.ts';
import { type DeviceMesh, isOnDevice } from './deviceMesh.ts';
import { DeviceWires } from './deviceWires.ts';
import { finishVectors } from './finish.ts';
import type { ItemFacts } from './imageInputs.ts';
import { displayRgb } from './look.ts';
import type { Seam } from './seam.ts';
import { MASK_ORDER } from './selection.ts';
import type { Ball } from './view.ts';

export interface SceneItem {
  readonly id: string;
  /** on WebGL2 arrays only */
  readonly mesh: Mesh | DeviceMesh;
  /** #rrggbb, display sRGB; of previews, and where the mesh has no colours of its own */
  readonly colour: string;
  /** how it answers light; without it as surfaces do that nobody gave one */
  readonly finish?: Finish;
  /** drawn lightly and without lines: not yet kept */
  readonly preview: boolean;
}

export interface Part extends Meshes {
  readonly item: SceneItem;
  readonly geometry: BufferGeometry;
}

/** What three draws of one part. */
interface Meshes {
  /** in all the passes, and where each belongs */
  readonly meshes: ReadonlyMap<ThreeMesh | LineSegments, ThreeScene>;
  /** those of the colour pass; a preview has none */
  readonly fill: ThreeMesh | null;
  readonly wire: ThreeMesh | LineSegments | null;
  /** those of the selection's mask; a preview has none */
  readonly silhouette: ThreeMesh | null;
  readonly mask: ThreeMesh | null;
}

/** What the parts are drawn with, one material a pass for all of them. */
export interface PartMaterials {
  readonly line: Material;
  readonly occluder: Material;
  readonly wire: Material;
  readonly lineWire: Material;
  readonly preview: Material;
  readonly silhouette: Material;
  readonly seen: Material;
}

/** The style's material, for parts of one colour or painted ones; made when first asked for. */
export type Fill = (painted: boolean) => Material;

/** Meshes are only taken over by parts that are drawn with the same materials, from the same sort of arrays. */
type Kind = 'kept' | 'painted' | 'preview' | 'painted on the device' | 'preview on the device';

/** One three scene a pass, so that a pass is a list of what it draws and nothing is switched on and off. */
export class Parts {
  readonly lines = named('lines');
  readonly colour = named('colour');
  readonly preview = named('preview');
  readonly selection = named('selection');
  /** around everything; radius 0 when there is nothing */
  readonly sphere = new Sphere(new Vector3(), 0);
  readonly #parts = new Map<string, Part>();
  readonly #materials: PartMaterials;
  readonly #seam: Seam;
  /** meshes without a part, of kept ones and of previews */
  readonly #spare = new Map<Kind, Meshes>();
  /** of meshes on the device, while wires are seen */
  readonly #wires = new Map<string, DeviceWires>();
  #fill: Fill;
  #wireframe = false;
  #selected: ReadonlySet<string> = new Set();

  constructor(materials: PartMaterials, fill: Fill, seam: Seam) {
    this.#materials = materials;
    this.#seam = seam;
    this.#fill = fill;
  }

  all(): Iterable<Part> {
    return this.#parts.values();
  }

  get hasPreview(): boolean {
    return [...this.#parts.values()].some((part) => part.item.preview);
  }

  get hasKept(): boolean {
    return [...this.#parts.values()].some((part) => !part.item.preview);
  }

  get hasSelected(): boolean {
    return [...this.#parts.values()].some(
      ({ item, silhouette }) => silhouette && this.#selected.has(item.id),
    );
  }

  /** The sphere as plain numbers, null when there is nothing. */
  get ball(): Ball | null {
    const { center, radius } = this.sphere;
    return radius > 0 ? { centre: center.toArray(), radius } : null;
  }

  /**
   * Returns whether geometry or what is a preview changed, in other words whether lines and bounds did. Throws, and changes nothing,
   * where a mesh on the device cannot be drawn.
   */
  sync(items: readonly SceneItem[]): boolean {
    for (const { mesh } of items) if (isOnDevice(mesh)) this.#seam.check(mesh);
    let changed = false;
    const wanted = new Set(items.map((item) => item.id));
    for (const [id, part] of this.#parts) {
      if (wanted.has(id)) continue;
      this.#remove(part);
      changed = true;
    }
    for (const item of items) changed = this.#put(item) || changed;
    if (changed) this.#measure();
    return changed;
  }

  setFill(fill: Fill): void {
    this.#fill = fill;
    for (const part of this.#parts.values()) if (part.fill) part.fill.material = fill(isPainted(part.item));
  }

  setWireframe(on: boolean): void {
    if (on === this.#wireframe) return;
    this.#wireframe = on;
    for (const part of this.#parts.values()) this.#wire(part);
  }

  /** Before each frame. */
  update(): void {
    for (const wires of this.#wires.values()) wires.update();
  }

  select(ids: readonly string[]): void {
    this.#selected = new Set(ids);
    for (const part of this.#parts.values()) this.#mark(part);
  }

  /** Does without the triangles of these, for which an image stands, but for their wires; returns what it has to be told of them. */
  leaveOut(ids: readonly string[]): readonly ItemFacts[] {
    return ids.map((id) => {
      const part = this.#parts.get(id);
      for (const mesh of part?.meshes.keys() ?? []) if (mesh !== part?.wire) mesh.layers.disableAll();
      const colour = part && !isPainted(part.item) ? displayRgb(part.item.colour) : null;
      const finish = finishVectors(part?.item.finish ?? DEFAULT_FINISH);
      return { colour, selected: this.#selected.has(id), finish };
    });
  }

  /** After `leaveOut`. */
  takeIn(ids: readonly string[]): void {
    for (const id of ids) for (const mesh of this.#parts.get(id)?.meshes.keys() ?? []) mesh.layers.set(0);
  }

  dispose(): void {
    this.sync([]);
    for (const { meshes } of this.#spare.values()) end(meshes);
    this.#spare.clear();
  }

  #put(item: SceneItem): boolean {
    const old = this.#parts.get(item.id);
    if (old && old.item.mesh === item.mesh && old.item.preview === item.preview) {
      if (old.item.colour !== item.colour || old.item.finish !== item.finish) this.#recolour(old, item);
      return false;
    }
    if (old) this.#remove(old);
    const geometry = this.#geometry(item);
    const part = { item, geometry, ...this.#meshes(kindOf(item)) };
    for (const [mesh, scene] of part.meshes) {
      mesh.geometry = geometry;
      mesh.name = item.id;
      scene.add(mesh);
    }
    if (part.fill) part.fill.material = this.#fill(isPainted(item));
    this.#wire(part);
    this.#parts.set(item.id, part);
    this.#recolour(part, item);
    this.#mark(part);
    return true;
  }

  #wire({ item, wire }: Part): void {
    this.#wires.get(item.id)?.end();
    this.#wires.delete(item.id);
    if (!wire) return;
    wire.visible = this.#wireframe;
    if (!this.#wireframe || !isOnDevice(item.mesh)) return;
    const wires = new DeviceWires(this.#seam, item.mesh);
    this.#wires.set(item.id, wires);
    wire.geometry = wires.geometry;
  }

  /** In the mask a part is either what is selected or what may hide it. */
  #mark({ item, silhouette, mask }: Part): void {
    if (!silhouette || !mask) return;
    const selected = this.#selected.has(item.id);
    silhouette.visible = selected;
    mask.material = selected ? this.#materials.seen : this.#materials.occluder;
    mask.renderOrder = selected ? MASK_ORDER.seen : MASK_ORDER.others;
  }

  #meshes(kind: Kind): Meshes {
    const spare = this.#spare.get(kind);
    this.#spare.delete(kind);
    if (spare) return spare;
    return kind.startsWith('preview')
      ? this.#lightly()
      : this.#fully(kind !== 'kept', kind.endsWith('device'));
  }

  #geometry(item: SceneItem): BufferGeometry {
    const { mesh, preview, id } = item;
    const geometry = isOnDevice(mesh) ? this.#seam.geometry(mesh, !preview) : toGeometry(mesh, !preview);
    geometry.name = id;
    return geometry;
  }

  #fully(painted: boolean, onDevice: boolean): Meshes {
    const fill = drawn(this.#fill(painted));
    // before the grid, which is blended over what is there
    const wire = onDevice ? lines(this.#materials.lineWire, 1) : drawn(this.#materials.wire, 1);
    const silhouette = drawn(this.#materials.silhouette, MASK_ORDER.silhouette);
    const mask = drawn(this.#materials.occluder);
    const meshes = new Map<ThreeMesh | LineSegments, ThreeScene>([
      [drawn(this.#materials.line), this.lines],
      [fill, this.colour],
      [wire, this.colour],
      [drawn(this.#materials.occluder), this.preview],
      [silhouette, this.selection],
      [mask, this.selection],
    ]);
    return { meshes, fill, wire, silhouette, mask };
  }

  /** Depth first, then colour where it is nearest: the inside of a light form never shows through it. */
  #lightly(): Meshes {
    const meshes = new Map([
      [drawn(this.#materials.occluder), this.preview],
      [drawn(this.#materials.preview, 1), this.preview],
    ]);
    return { meshes, fill: null, wire: null, silhouette: null, mask: null };
  }

  #recolour(part: Part, item: SceneItem): void {
    const colour = new Vector3(...displayRgb(item.colour));
    const { light, peak } = finishVectors(item.finish ?? DEFAULT_FINISH);
    const own = { colour, light: new Vector4(...light), peak: new Vector4(...peak) };
    for (const mesh of part.meshes.keys()) Object.assign(mesh.userData, own);
    if (part.item !== item) this.#parts.set(item.id, { ...part, item });
  }

  #remove({ item, geometry, ...meshes }: Part): void {
    for (const mesh of meshes.meshes.keys()) mesh.removeFromParent();
    this.#wires.get(item.id)?.end();
    this.#wires.delete(item.id);
    if (isOnDevice(item.mesh)) this.#seam.end(geometry);
    else geometry.dispose();
    this.#parts.delete(item.id);
    const kind = kindOf(item);
    if (this.#spare.has(kind)) end(meshes.meshes);
    else this.#spare.set(kind, meshes);
  }

  /** Grown from the items' own spheres: within a few per cent of the smallest. */
  #measure(): void {
    this.sphere.makeEmpty();
    for (const { geometry } of this.#parts.values()) {
      if (geometry.boundingSphere) this.sphere.union(geometry.boundingSphere);
    }
    if (this.sphere.isEmpty()) this.sphere.set(new Vector3(), 0);
  }
}

const isPainted = ({ mesh }: SceneItem): boolean => mesh.colours !== undefined;

function kindOf(item: SceneItem): Kind {
  const kind = item.preview ? 'preview' : isPainted(item) ? 'painted' : 'kept';
  return isOnDevice(item.mesh) && kind !== 'kept' ? `${kind} on the device` : kind;
}

function named(name: string): ThreeScene {
  const scene = new ThreeScene();
  scene.name = name;
  return scene;
}

/** Of a part that is still to come. */
function drawn(material: Material, order = 0): ThreeMesh {
  return placed(new ThreeMesh(undefined, material), order);
}

function lines(material: Material, order: number): LineSegments {
  return placed(new LineSegments(undefined, material), order);
}

function placed<T extends ThreeMesh | LineSegments>(mesh: T, order: number): T {
  mesh.matrixAutoUpdate = false;
  mesh.renderOrder = order;
  return mesh;
}

/** three listens for this event at every mesh it has drawn, though its types do not say so. */
function end(meshes: Meshes['meshes']): void {
  for (const mesh of meshes.keys())
    (mesh as EventDispatcher<{ dispose: object }>).dispatchEvent({ type: 'dispose' });
}

function toGeometry({ positions, normals, indices, colours }: Mesh, painted: boolean): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  if (colours && painted) geometry.setAttribute('colour', new BufferAttribute(colours, 3));
  geometry.setIndex(new BufferAttribute(indices, 1));
  geometry.computeBoundingSphere();
  return geometry;
}
