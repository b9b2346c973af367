/** A mesh whose arrays lie on the graphics device, where compute passes write them; how long they are only the device knows. */
import type { Box, Mesh } from '../mesh/mesh.ts';

/**
 * Buffers of the scene's own device, with the usage VERTEX, INDEX or INDIRECT that drawing needs, and STORAGE for the last two. Whoever made them writes them as
 * often as he likes and destroys them, once the scene has been given others; the scene never reads, copies or destroys them.
 */
export interface DeviceMesh {
  /** x y z and a fourth per vertex that nobody reads, f32, mm */
  readonly positions: GPUBuffer;
  /** unit x y z and a fourth, f32, outward */
  readonly normals: GPUBuffer;
  /** red green blue and a fourth, f32, 0–1, linear */
  readonly colours: GPUBuffer;
  /** u32, three per triangle, outward triangles counter-clockwise */
  readonly indices: GPUBuffer;
  /** five u32: number of indices, 1, first index, 0, 0 */
  readonly draw: GPUBuffer;
  /**
   * Around all that is drawn, mm. What is outside may be cut off by the camera, picking knows nothing finer, and lines and ink measure
   * depth over the sphere around it.
   */
  readonly box: Box;
}

export function isOnDevice(mesh: Mesh | DeviceMesh): mesh is DeviceMesh {
  return 'draw' in mesh;
}
