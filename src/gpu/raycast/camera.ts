/** A camera as the device has it: seen from the body, which stays where it was made. */
import type { Colour } from '../../field/node.ts';
import type { RayCamera } from '../../field/rayImage.ts';
import type { Frame } from '../../field/rayScene.ts';
import { rotate3 } from '../../math/tuple.ts';
import type { Quat, Vec3 } from '../../math/vec.ts';
import { eyeDistance } from '../../stroke/plane.ts';
import type { DeviceBody } from './body.ts';
import { RAY_CAMERA } from './stages.ts';

/** bytes from one to the next: every device binds uniforms at multiples of it */
export const CAMERA_STRIDE = 256;

/** What a dispatch is told. */
export interface Shot {
  /** as seen from the body */
  readonly camera: RayCamera;
  /** null: nothing is cast */
  readonly body: Pick<DeviceBody, 'lattice' | 'leaves' | 'plain'> | null;
  /** of the body's placement */
  readonly rotation: Quat;
  /** the fourth of the colours */
  readonly number: number;
  readonly frame: Frame;
  /** pixels from row to row */
  readonly stride: number;
}

/** One after the other, `CAMERA_STRIDE` bytes each. */
export function packShots(shots: readonly Shot[]): ArrayBuffer {
  const bytes = new Uint8Array(CAMERA_STRIDE * shots.length);
  for (const [i, shot] of shots.entries())
    bytes.set(new Uint8Array(RAY_CAMERA.pack([recordOf(shot)])), CAMERA_STRIDE * i);
  return bytes.buffer;
}

function recordOf({ camera, body, rotation, number, frame, stride }: Shot) {
  const { view, width, height, offset } = camera;
  const axis = (v: Vec3) => rotate3(view.rotation, v);
  const { left, right, top, bottom } = frame;
  return {
    pivot: view.pivot,
    pixel: view.height / height,
    right: axis([1, 0, 0]),
    distance: eyeDistance(view) ?? 0,
    up: axis([0, 1, 0]),
    size: body ? sizeOf(body.lattice) : 0,
    back: axis([0, 0, 1]),
    leaves: body?.leaves ?? 0,
    picture: [width, height],
    offset,
    colour: colourOf(body?.plain ?? null),
    first: [left, top],
    end: [right, bottom],
    turn: [rotate3(rotation, [1, 0, 0]), rotate3(rotation, [0, 1, 0]), rotate3(rotation, [0, 0, 1])].flat(),
    stride,
    number,
  };
}

const sizeOf = ({ counts, step }: DeviceBody['lattice']): number => (Math.max(...counts) - 1) * step;

const colourOf = (plain: Colour | null): readonly number[] => (plain ? [...plain, 1] : [0, 0, 0, 0]);
