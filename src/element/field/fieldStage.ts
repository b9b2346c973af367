/** The picture of the field page: one painted part, its camera, and frames only when something moved. */
import { longest } from '../../field/boxes.ts';
import type { FieldMesh } from '../../field/brickMesh.ts';
import type { Comparison } from '../../field/zhuImage.ts';
import { cos, PI, sin } from '../../math/trig.ts';
import type { Quat } from '../../math/vec.ts';
import { bounds } from '../../mesh/measure.ts';
import type { Box } from '../../mesh/mesh.ts';
import { type DeviceMesh, isOnDevice } from '../../scene/deviceMesh.ts';
import type { Look, Scene } from '../../scene/index.ts';
import { FRONT_VIEW, holds, type Margins } from '../../scene/view.ts';
import type { View } from '../../stroke/stroke.ts';
import type { ShownBody } from '../caster.ts';
import { Exact } from '../exact.ts';
import { Rays } from '../rays.ts';
import { ZhuCaster } from '../zhuCaster.ts';

/** From the right and a little above: degrees. */
const [YAW, PITCH] = [32, -14];

function turned(yaw: number, pitch: number): Quat {
  const half = PI / 360;
  const [cy, sy, cx, sx] = [cos(yaw * half), sin(yaw * half), cos(pitch * half), sin(pitch * half)];
  return [cy * sx, sy * cx, -sy * sx, cy * cx];
}

/** Where the page looks from at first. */
const FIRST_VIEW: View = { ...FRONT_VIEW, rotation: turned(YAW, PITCH) };

/** as many times as large as what the picture was fitted to */
const OUTGROWN = 1.8;

/** null: nothing is to be seen; what is on the device may be empty all the same */
function boxOf(mesh: FieldMesh | DeviceMesh): Box | null {
  if (isOnDevice(mesh)) return mesh.box;
  return mesh.indices.length > 0 ? bounds(mesh) : null;
}

/** What has to be in sight, x y z each. */
function pointsOf(mesh: FieldMesh | DeviceMesh): ArrayLike<number> {
  if (!isOnDevice(mesh)) return mesh.positions;
  const ends = [mesh.box.min, mesh.box.max];
  return Array.from({ length: 24 }, (_, i) => ends[(Math.floor(i / 3) >> (i % 3)) & 1]![i % 3]!);
}

/** Whose rays: ours, or Zhu et al.'s beside them. */
export type RayScheme = 'bricks' | 'zhu';

/** Whether a body is to fill the picture: always; where it grows under the controls; where it is of quite another size. */
export type Fit = 'always' | 'covered' | 'never';

/** ms in which a body goes over into a finer one of itself */
const FADE = 120;
/** ms from one frame to the next, for the first one of them */
const FRAME = 16;

export class FieldStage {
  scene: Scene | null = null;
  /** of the picture, that the controls cover */
  margins = (): Margins => ({ left: 0.1, top: 0.1, right: 0.1, bottom: 0.1 });
  /** what rays are cast at; null: it is not made yet */
  cast: ShownBody | null = null;
  readonly rays = new Rays();
  readonly #exact: Readonly<Record<RayScheme, Exact>>;
  readonly #zhu = new ZhuCaster();
  #scheme: RayScheme = 'bricks';
  #guides: Float32Array | null = null;
  /** rises with every change of what the picture shows, but for the view */
  #version = 0;
  readonly #drawn: () => void;
  #mesh: FieldMesh | DeviceMesh | null = null;
  #box: Box | null = null;
  /** mm, of the longest side of what was fitted last */
  #fitted = 1;
  #view: View = FIRST_VIEW;
  #look: Look;
  #size = { width: 1, height: 1, ratio: 1 };
  #fit = true;
  #frame = 0;
  #last = 0;
  /** from when on, and in which view, the body before is going; null: it is gone */
  #fading: { from: number | null; readonly view: string } | null = null;

  /** `drawn` is called after each frame, `told` when there is something to say of rays. */
  constructor(look: Look, drawn: () => void, told: () => void = () => {}) {
    const changed = () => {
      told();
      this.wake();
    };
    this.#exact = { bricks: new Exact(changed, this.rays), zhu: new Exact(changed, this.#zhu) };
    this.#look = look;
    this.#drawn = drawn;
  }

  /** Of the rays in hand. */
  get exact(): Exact {
    return this.#exact[this.#scheme];
  }

  /** How Zhu's rays did beside ours; null: they are not cast. */
  get comparison(): Comparison | null {
    return this.#scheme === 'zhu' ? this.#zhu.comparison : null;
  }

  setRays(scheme: RayScheme): void {
    if (scheme === this.#scheme) return;
    this.exact.rest();
    this.#scheme = scheme;
    this.wake();
  }

  /** Lines over the picture, six numbers each, mm; compared by reference. */
  guide(ends: Float32Array | null): void {
    if (ends === this.#guides) return;
    this.#guides = ends;
    this.#version++;
    this.scene?.guide(ends);
    this.wake();
  }

  get view(): View {
    return this.scene?.rig.view() ?? this.#view;
  }

  get look(): Look {
    return this.#look;
  }

  attach(scene: Scene, reducedMotion: boolean): void {
    this.scene = scene;
    // images lie on the device of the scene before
    for (const exact of Object.values(this.#exact)) exact.drop();
    this.rays.use(scene);
    this.#version++;
    scene.rig.reducedMotion = reducedMotion;
    scene.rig.setView(this.#view, false);
    scene.setLook(this.#look);
    if (this.#guides) scene.guide(this.#guides);
    scene.resize(this.#size.width, this.#size.height, this.#size.ratio);
    this.#sync();
  }

  detach(): void {
    this.#fading = null;
    for (const exact of Object.values(this.#exact)) exact.stop();
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#view = this.view;
    // the next scene may be on another device, or on none
    if (this.#mesh && isOnDevice(this.#mesh)) this.#mesh = null;
    this.scene?.dispose();
    this.scene = null;
  }

  setLook(change: Partial<Look>): void {
    this.#look = { ...this.#look, ...change };
    this.#version++;
    this.scene?.setLook(this.#look);
    this.wake();
  }

  /** CSS pixels, and device pixels a CSS pixel. */
  resize(width: number, height: number, ratio: number): void {
    this.#size = { width, height, ratio };
    this.scene?.resize(width, height, ratio);
    this.wake();
  }

  /** False where it is there already. What `refines` the body before it comes gently. */
  show(mesh: FieldMesh | DeviceMesh, fit: Fit, refines = false): boolean {
    if (mesh === this.#mesh) return false;
    this.#beginFading(refines);
    const wasFree = fit === 'covered' && this.#isFree;
    this.#mesh = mesh;
    this.#version++;
    this.#box = boxOf(mesh);
    this.#fit ||= fit === 'always' || this.#outgrown || (wasFree && !this.#isFree);
    this.#sync();
    return true;
  }

  showAll(animate: boolean): void {
    if (this.#box) {
      this.scene?.rig.fit(this.#box, animate, this.margins());
      this.#fitted = longest(this.#box);
    }
    this.wake();
  }

  /** All of the body is between the controls. */
  get #isFree(): boolean {
    const { width, height } = this.#size;
    return this.#mesh === null || holds(this.view, pointsOf(this.#mesh), width / height, this.margins());
  }

  /** Too large for the picture it was fitted into, or a dot in it. */
  get #outgrown(): boolean {
    const share = this.#box ? longest(this.#box) / this.#fitted : 1;
    return share > OUTGROWN || share < 1 / OUTGROWN;
  }

  /** Back to where one looked from at first, with all of the body in the picture. */
  reset(): void {
    this.scene?.rig.setView({ ...FIRST_VIEW, fov: this.view.fov }, false);
    this.showAll(false);
  }

  wake(): void {
    if (this.scene) this.#frame ||= requestAnimationFrame((now) => this.#tick(now));
  }

  #sync(): void {
    const mesh = this.#mesh;
    const items = mesh && this.#box ? [{ id: 'body', mesh, colour: '#a5a29a', preview: false }] : [];
    this.scene?.sync(items);
    if (this.#fit && this.scene && this.#box && this.#size.width > 1) {
      this.#fit = false;
      this.showAll(false);
    }
    this.wake();
  }

  /** Not where motion is unwelcome or a frame takes a tenth of a second, and of nothing that was not yet seen. */
  #beginFading(refines: boolean): void {
    const { scene } = this;
    this.#fading = null;
    if (!scene || !refines || this.#frame || scene.rig.reducedMotion || scene.description?.software) return;
    if (scene.keep()) this.#fading = { from: null, view: this.#viewKey };
  }

  /** How much is seen of the body before: a picture, which is of one view only. */
  #fadingAt(now: number): number {
    const fading = this.#fading;
    if (fading?.view !== this.#viewKey) return 0;
    fading.from ??= now - FRAME;
    return Math.max(0, 1 - (now - fading.from) / FADE);
  }

  get #viewKey(): string {
    return JSON.stringify(this.view);
  }

  /** Whether the surface itself is seen, and all is drawn. */
  #isExact(isMoving: boolean): boolean {
    const { scene, cast, view } = this;
    if (isMoving || !scene || !cast || this.#look.mode !== 'exact') {
      this.exact.rest();
      return false;
    }
    return this.exact.frame({ scene, bodies: [cast], view, version: this.#version });
  }

  /** Whether what moves is drawn by rays. */
  #live(): boolean {
    const { scene, cast, view } = this;
    if (!scene || !cast || this.#look.mode !== 'exact') return false;
    return this.exact.live({ scene, bodies: [cast], view });
  }

  #tick(now: number): void {
    this.#frame = 0;
    const seconds = Math.min(0.1, (now - this.#last) / 1000);
    this.#last = now;
    const moving = this.scene?.rig.update(seconds) ?? false;
    const share = this.#fadingAt(now);
    if (share === 0) this.#fading = null;
    if (!this.#isExact(moving || share > 0) && !(share === 0 && this.#live())) {
      this.scene?.fade(share);
      this.scene?.render();
    }
    this.#drawn();
    if (moving || share > 0) this.wake();
  }
}
