/** Vectors: gl-matrix's functions on plain arrays (its default Float32Array would cost us the float64 truth). */
import { glMatrix, quat, vec2, vec3 } from 'gl-matrix';

glMatrix.setMatrixArrayType(Array as unknown as ArrayConstructor);

export type Vec2 = readonly [x: number, y: number];
export type Vec3 = readonly [x: number, y: number, z: number];
/** A unit quaternion, scalar last. */
export type Quat = readonly [x: number, y: number, z: number, w: number];

export { quat, vec2, vec3 };
