/**
 * The camera, driven by methods only: the pen router decides what a pointer means. camera-controls keeps orbit, pan
 * and distance, and turns about the camera's own up; it is never connected to events. Movements of the hand take
 * effect at once; moves of the program are eased here, from view to view, because the library's damping neither
 * ends at a fixed time nor turns the up direction.
 *
 * The visible height at the pivot is the only zoom: both cameras are derived from the distance, so switching between
 * orthographic and perspective keeps the framing.
 */
import CameraControls from 'camera-controls';
import {
  Box3,
  Matrix4,
  OrthographicCamera,
  PerspectiveCamera,
  Quaternion,
  Raycaster,
  Sphere,
  Spherical,
  Vector2,
  Vector3,
  Vector4,
} from 'three/webgpu';
import type { Quat, Vec3 } from '../math/vec.ts';
import type { Box } from '../mesh/mesh.ts';
import type { View } from '../stroke/stroke.ts';
import { project } from './projection.ts';
import {
  axes,
  type Ball,
  between,
  ease,
  FACE_ROTATION,
  type Face,
  FRONT_VIEW,
  fitted,
  heightLimits,
  kept,
  type Margins,
} from './view.ts';

CameraControls.install({
  THREE: { Vector2, Vector3, Vector4, Quaternion, Matrix4, Spherical, Box3, Sphere, Raycaster },
});

/** vertical opening of the perspective camera, degrees */
const FOV = 30;
/** seconds a move takes */
const MOVE = 0.36;
/** a drag across the screen's height turns the form once */
const TURN = 2 * Math.PI;
/** radians a press of an arrow key */
const STEP = Math.PI / 12;
/** how far a rotation's squared length may be from 1 */
const UNIT = 1e-12;
/** A screen-parallel up: how far right may leave the horizon and still count as level. */
const LEVEL = 1e-9;

interface Move {
  readonly from: View;
  readonly to: View;
  /** seconds gone */
  time: number;
}

export class CameraRig {
  /** Moves become cuts. */
  reducedMotion = false;
  readonly #orthographic = new OrthographicCamera(-1, 1, 1, -1);
  readonly #perspective = new PerspectiveCamera(FOV);
  readonly #controls: CameraControls;
  #perspectiveOn = false;
  #width = 1;
  #height = 1;
  #ball: Ball | null = null;
  #move: Move | null = null;
  // the view as it was set, until a hand moves it: a view that is set comes back to the bit
  #exact: View | null = null;

  constructor() {
    this.#controls = new CameraControls(this.#orthographic);
    // The limits that matter depend on the scene, see `kept`.
    this.#controls.minDistance = 0;
    this.#controls.maxDistance = Infinity;
    this.setView(FRONT_VIEW, false);
  }

  get camera(): OrthographicCamera | PerspectiveCamera {
    return this.#perspectiveOn ? this.#perspective : this.#orthographic;
  }

  get moving(): boolean {
    return this.#move !== null;
  }

  /** The size of the picture, CSS pixels. */
  resize(width: number, height: number): void {
    this.#width = Math.max(1, width);
    this.#height = Math.max(1, height);
    this.#project();
  }

  /** What must not get lost: the sphere around the scene, null when it is empty. */
  setBounds(ball: Ball | null): void {
    this.#ball = ball;
    this.#project();
  }

  /** CSS pixels; a drag to the right turns the form to the right. */
  orbit(dx: number, dy: number): void {
    this.#byHand(() =>
      this.#controls.rotate((-TURN * dx) / this.#height, (-TURN * dy) / this.#height, false),
    );
  }

  /** CSS pixels; the form follows the finger. */
  pan(dx: number, dy: number): void {
    const pixel = this.view().height / this.#height;
    this.#byHand(() => this.#controls.truck(-dx * pixel, -dy * pixel, false));
  }

  /** Radians; positive turns the picture counter-clockwise. */
  roll(angle: number): void {
    this.#byHand(() => {
      const [, up, back] = axes(this.view().rotation);
      // The camera turns against the picture.
      this.camera.up.set(...up).applyAxisAngle(new Vector3(...back), -angle);
      this.#controls.applyCameraUp();
    });
  }

  /** > 1 comes nearer; x, y (CSS pixels from the upper left) stay over the same point of the pivot's plane. */
  zoom(factor: number, x: number = this.#width / 2, y: number = this.#height / 2): void {
    const view = this.view();
    const [least, most] = heightLimits(this.#ball);
    const height = Math.min(most, Math.max(least, view.height / factor));
    const right = ((x - this.#width / 2) / this.#height) * (view.height - height);
    const down = ((y - this.#height / 2) / this.#height) * (view.height - height);
    this.#byHand(() => {
      this.#controls.truck(right, down, false);
      this.#controls.dollyTo(this.#distance(height), false);
    });
  }

  /** Shows the whole box from where the camera looks; null = the default height around the origin. */
  fit(box: Box | null, animate: boolean, margins?: Margins): void {
    const view = this.goal();
    const aspect = this.#width / this.#height;
    const { pivot, height } = FRONT_VIEW;
    this.setView(box ? fitted(view, box, aspect, margins) : { ...view, pivot, height }, animate);
  }

  /** The front view of the default page. */
  reset(animate: boolean): void {
    this.setView({ ...FRONT_VIEW, fov: this.goal().fov }, animate);
  }

  /** Looks at one side; the pivot and the height stay. */
  face(side: Face, animate: boolean): void {
    this.setView({ ...this.goal(), rotation: FACE_ROTATION[side] }, animate);
  }

  /** One press of an arrow key, in steps of 15°. */
  orbitStep(right: number, up: number, animate: boolean): void {
    const from = this.view();
    if (this.#move) this.#apply(this.#move.to);
    this.#controls.rotate(-STEP * right, STEP * up, false);
    this.#controls.update(0);
    this.#exact = null;
    const to = this.view();
    this.#apply(from);
    this.setView(to, animate);
  }

  setPerspective(on: boolean): void {
    this.setView({ ...this.goal(), fov: on ? FOV : 0 }, false);
  }

  setView(view: View, animate: boolean): void {
    const to = kept(view, this.#ball, this.#width / this.#height);
    if (!animate || this.reducedMotion) {
      this.#move = null;
      this.#apply(to);
      return;
    }
    this.#move = { from: this.view(), to, time: 0 };
  }

  /** How the model is looked at now. */
  view(): View {
    if (this.#exact) return this.#exact;
    const { x, y, z } = this.#controls.getTarget(new Vector3());
    const rotation = this.camera.quaternion.toArray() as unknown as Quat;
    const height = this.#controls.distance * 2 * Math.tan((this.#perspective.fov * Math.PI) / 360);
    return { pivot: [x, y, z], rotation, height, fov: this.#perspectiveOn ? this.#perspective.fov : 0 };
  }

  /** Where the camera will be when it has come to rest. */
  goal(): View {
    return this.#move?.to ?? this.view();
  }

  /** Goes on with a move by some seconds; true while there is one, so that another frame is wanted. */
  update(seconds: number): boolean {
    const move = this.#move;
    if (!move) return false;
    move.time += seconds;
    const part = move.time / MOVE;
    if (part >= 1) this.#move = null;
    this.#apply(between(move.from, move.to, ease(part)));
    return this.#move !== null;
  }

  dispose(): void {
    this.#controls.dispose();
  }

  #byHand(change: () => void): void {
    this.#move = null;
    change();
    this.#controls.update(0);
    this.#exact = null;
    const now = this.view();
    const limited = kept(now, this.#ball, this.#width / this.#height);
    if (limited.height !== now.height || limited.pivot.some((value, i) => value !== now.pivot[i])) {
      const [x, y, z] = limited.pivot;
      this.#controls.moveTo(x, y, z, false);
      this.#controls.dollyTo(this.#distance(limited.height), false);
      this.#controls.update(0);
    }
    this.#project();
  }

  #apply(view: View): void {
    this.#perspectiveOn = view.fov > 0;
    if (view.fov > 0) this.#perspective.fov = view.fov;
    const [right, up, back] = axes(view.rotation);
    this.camera.up.set(...levelUp(right, up));
    this.#controls.camera = this.camera;
    const distance = this.#distance(view.height);
    const [x, y, z] = view.pivot;
    this.#controls.setLookAt(x + back[0] * distance, y + back[1] * distance, z + back[2] * distance, x, y, z);
    // Straight up or down the position does not tell the heading; right always does.
    if (this.camera.up.y === 1) this.#controls.rotateAzimuthTo(Math.atan2(-right[2], right[0]), false);
    this.#controls.update(0);
    const { quaternion } = this.camera;
    quaternion.set(...view.rotation);
    // What is a rotation already keeps its bits: a view that is kept and brought back is the very same.
    if (Math.abs(quaternion.lengthSq() - 1) > UNIT) quaternion.normalize();
    this.#exact = { ...view, rotation: this.camera.quaternion.toArray() as unknown as Quat };
    this.#project();
  }

  /** mm from the camera to the pivot for a visible height at the pivot */
  #distance(height: number): number {
    return height / (2 * Math.tan((this.#perspective.fov * Math.PI) / 360));
  }

  #project(): void {
    const { pivot, height } = this.view();
    const framing = { pivot, height, distance: this.#distance(height), aspect: this.#width / this.#height };
    project(this.camera, framing, this.#ball);
  }
}

/**
 * The up direction to turn about: the world's when the horizon is level, else the picture's own. (A rolled camera
 * that turned about the world's up would lose its roll.)
 */
function levelUp(right: Vec3, up: Vec3): Vec3 {
  return Math.abs(right[1]) < LEVEL && up[1] > -LEVEL ? [0, 1, 0] : up;
}
