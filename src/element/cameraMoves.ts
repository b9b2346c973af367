/** What hands, keys and the view ball do to the camera. Nothing moves while the pen is down: it would tear the stroke. */
import { draftSolids, solids } from '../document/build.ts';
import { partsWith } from '../document/chosen.ts';
import type { Vec3 } from '../math/vec.ts';
import { bounds } from '../mesh/measure.ts';
import type { Box, Mesh } from '../mesh/mesh.ts';
import type { CameraRig } from '../scene/index.ts';
import type { View } from '../stroke/stroke.ts';
import type { Session } from './session.ts';
import type { Axis } from './viewBall.ts';

export class CameraMoves {
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
  }

  /** CSS pixels of a drag across the picture. */
  orbit(dx: number, dy: number): void {
    this.#move((rig) => rig.orbit(dx, dy));
  }

  pan(dx: number, dy: number): void {
    this.#move((rig) => rig.pan(dx, dy));
  }

  /** radians */
  roll(angle: number): void {
    this.#move((rig) => rig.roll(angle));
  }

  /** towards a point of the picture, CSS pixels */
  zoom(factor: number, x: number, y: number): void {
    this.#move((rig) => rig.zoom(factor, x, y));
  }

  face(axis: Axis): void {
    this.#move((rig) => rig.face(axis, true));
  }

  showAll(animate = true): void {
    const { document } = this.#session;
    const meshes = [...solids(document), ...draftSolids(document)].map(({ mesh }) => mesh);
    this.#move((rig) => rig.fit(boxOf(meshes), animate, this.#session.margins()));
  }

  /** Comes to where these parts, or those that these groups are in, fill the picture. */
  show(ids: readonly string[]): void {
    const { document } = this.#session;
    const wanted = new Set(partsWith(document, ids).map(({ id }) => id));
    const meshes = solids(document).filter(({ id }) => wanted.has(id));
    if (meshes.length > 0) {
      const box = boxOf(meshes.map(({ mesh }) => mesh));
      this.#move((rig) => rig.fit(box, true, this.#session.margins()));
    }
  }

  /** For tools that know from where something is to be seen. */
  lookFrom(view: View): void {
    this.#session.scene?.rig.setView(view, true);
    this.#session.frames.wake();
  }

  reset(): void {
    this.#move((rig) => rig.reset(true));
  }

  setPerspective(on: boolean): void {
    this.#move((rig) => rig.setPerspective(on));
    this.#session.update();
  }

  #move(move: (rig: CameraRig) => void): void {
    const { scene, state } = this.#session;
    if (!scene || state.wet || state.still) return;
    move(scene.rig);
    this.#session.frames.wake();
  }
}

/** The box around all of them; null around nothing. */
export function boxOf(meshes: readonly Mesh[]): Box | null {
  if (meshes.length === 0) return null;
  const boxes = meshes.map(bounds);
  const over = (pick: (a: number, b: number) => number, corner: 'min' | 'max'): Vec3 => {
    const at = (axis: 0 | 1 | 2) => boxes.map((box) => box[corner][axis]).reduce((a, b) => pick(a, b));
    return [at(0), at(1), at(2)];
  };
  return { min: over(Math.min, 'min'), max: over(Math.max, 'max') };
}
