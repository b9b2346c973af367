/**
 * The camera as rays had it that went through other places of their pixels than the middle: what triangles show in the middle of a pixel is
 * then what rays saw there, so that pictures with both can be averaged (accumulation buffer, Haeberli & Akeley 1990).
 */
import { Matrix4, type OrthographicCamera, type PerspectiveCamera, type WebGPURenderer } from 'three/webgpu';
import type { RayCamera } from '../field/rayImage.ts';

export type ViewCamera = OrthographicCamera | PerspectiveCamera;

export function jittered<T>(
  camera: ViewCamera,
  renderer: Pick<WebGPURenderer, 'coordinateSystem'>,
  { width, height, offset }: RayCamera,
  draw: () => T,
): T {
  const { projectionMatrix, projectionMatrixInverse } = camera;
  // three would make it anew for this in mid-frame
  camera.coordinateSystem = renderer.coordinateSystem;
  camera.updateProjectionMatrix();
  projectionMatrix.premultiply(widened(aspectOf(camera) / (width / height)));
  projectionMatrix.premultiply(moved((1 - 2 * offset[0]) / width, (2 * offset[1] - 1) / height));
  projectionMatrixInverse.copy(projectionMatrix).invert();
  try {
    return draw();
  } finally {
    camera.updateProjectionMatrix();
  }
}

const moved = (x: number, y: number): Matrix4 => new Matrix4().makeTranslation(x, y, 0);

/** The picture's pixels are squares, though its sides in CSS pixels may not be whole numbers of them. */
const widened = (x: number): Matrix4 => new Matrix4().makeScale(x, 1, 1);

function aspectOf(camera: ViewCamera): number {
  if ('aspect' in camera) return camera.aspect;
  return (camera.right - camera.left) / (camera.top - camera.bottom);
}
