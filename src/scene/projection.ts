/** The projection of a camera that already stands where it should: framing, and depths around the scene. */
import { OrthographicCamera, type PerspectiveCamera, Vector3 } from 'three/webgpu';
import type { Vec3 } from '../math/vec.ts';
import { type Ball, FRONT_VIEW } from './view.ts';

export interface Framing {
  /** mm */
  readonly pivot: Vec3;
  /** visible height at the pivot, mm */
  readonly height: number;
  /** from the camera to the pivot, mm */
  readonly distance: number;
  /** width / height of the picture */
  readonly aspect: number;
}

/** Near plane of a perspective camera amid the scene, in parts of the far one: what 24 bits of depth still tell. */
const NEAREST = 1e-4;

export function project(
  camera: OrthographicCamera | PerspectiveCamera,
  framing: Framing,
  ball: Ball | null,
): void {
  camera.updateMatrixWorld();
  const [near, far] = depths(camera, framing, ball);
  if (camera instanceof OrthographicCamera) {
    camera.top = framing.height / 2;
    camera.bottom = -camera.top;
    camera.right = camera.top * framing.aspect;
    camera.left = -camera.right;
    // An orthographic camera may stand amid the scene.
    camera.near = near;
  } else {
    camera.aspect = framing.aspect;
    camera.near = Math.max(near, far * NEAREST);
  }
  camera.far = far;
  camera.updateProjectionMatrix();
}

/** Around the scene's sphere and the pivot, where grid and strokes lie, with a little air. */
function depths(
  camera: OrthographicCamera | PerspectiveCamera,
  { pivot, distance }: Framing,
  ball: Ball | null,
): readonly [near: number, far: number] {
  const { centre, radius } = ball ?? { centre: pivot, radius: FRONT_VIEW.height };
  const middle = -new Vector3(...centre).applyMatrix4(camera.matrixWorldInverse).z;
  const air = 0.01 * radius + 0.01;
  return [Math.min(middle - radius, distance) - air, Math.max(middle + radius, distance) + air];
}
