/** What a picture is asked for with: checked, and turned into what the scene takes. */
import { solids } from '../document/build.ts';
import type { Document } from '../document/document.ts';
import {
  BACKGROUNDS,
  type Background,
  type Look,
  MODES,
  type Mode,
  PICTURE_SIDE,
  STYLES,
  type Style,
} from '../document/look.ts';
import { FileError } from '../document/serialize.ts';
import { type Quat, quat } from '../math/vec.ts';
import type { Mesh } from '../mesh/mesh.ts';
import type { PictureOptions } from '../scene/index.ts';
import { FACE_ROTATION, type Face, fitted } from '../scene/view.ts';
import type { View } from '../stroke/stroke.ts';
import { boxOf } from './cameraMoves.ts';
import { screenBox } from './place.ts';

export interface Angles {
  /** degrees around the vertical axis; 90 looks from the right */
  readonly yaw: number;
  /** degrees above the horizon; 90 looks from the top */
  readonly pitch: number;
  /** degrees the picture is turned counter-clockwise */
  readonly roll?: number;
}

export interface Shot {
  /** pixels; without them as large as the element on the screen */
  readonly width?: number;
  readonly height?: number;
  /** a side or a direction, from which the whole model is framed; without it as one looks now */
  readonly camera?: Face | Angles;
  readonly style?: Style;
  /** what is seen of bodies */
  readonly mode?: Mode;
  readonly background?: Background;
}

/**
 * What the element looks like now.
 * @internal
 */
export interface Now {
  readonly document: Document;
  readonly view: View;
  readonly look: Look;
  /** device pixels */
  readonly width: number;
  readonly height: number;
  /** the whole model is about to be framed */
  readonly fit: boolean;
}

/** @internal */
export function pictureOptions(shot: Shot, now: Now): PictureOptions {
  const width = pixels('width', shot.width ?? now.width);
  const height = pixels('height', shot.height ?? now.height);
  const style = oneOf('style', STYLES, shot.style ?? now.look.style);
  const mode = oneOf('mode', MODES, shot.mode ?? now.look.mode);
  const background = oneOf('background', BACKGROUNDS, shot.background ?? now.look.background);
  const items = solids(now.document).map((solid) => ({ ...solid, preview: false }));
  const meshes = items.map(({ mesh }) => mesh);
  const box = boxOf(meshes);
  const rotation = shot.camera === undefined ? now.view.rotation : rotationOf(shot.camera);
  const turned = { ...now.view, rotation };
  const frame = box !== null && (shot.camera !== undefined || now.fit);
  const view = frame ? fitted(turned, box, width / height) : whole(turned, meshes, width / height);
  return { width, height, view, look: { ...now.look, style, mode, background }, items };
}

/** width over height: the picture a view is expected to be seen in */
const USUAL_ASPECT = 4 / 3;
/** Air beside a model that decides how much is seen. */
const BESIDE = 1.06;

/** A narrower picture than usual still shows all of a model that is whole in a usual one. */
function whole(view: View, meshes: readonly Mesh[], aspect: number): View {
  const usual = screenBox(meshes, view, { width: USUAL_ASPECT, height: 1 });
  if (!usual || aspect >= USUAL_ASPECT) return view;
  const { left, right, top, bottom } = usual;
  // Somebody went near on purpose.
  if (left < 0 || right > USUAL_ASPECT || top < 0 || bottom > 1) return view;
  const reach = Math.max(USUAL_ASPECT / 2 - left, right - USUAL_ASPECT / 2);
  return { ...view, height: view.height * Math.max(1, (2 * BESIDE * reach) / aspect) };
}

function pixels(place: string, value: number): number {
  if (Number.isInteger(value) && value >= PICTURE_SIDE.least && value <= PICTURE_SIDE.most) return value;
  throw wrong(place, `a whole number of pixels from ${PICTURE_SIDE.least} to ${PICTURE_SIDE.most}`, value);
}

function oneOf<T extends string>(place: string, known: readonly T[], value: T): T {
  if (known.includes(value)) return value;
  throw wrong(place, `one of ${known.join(', ')}`, value);
}

function rotationOf(camera: Face | Angles): Quat {
  const sides = Object.keys(FACE_ROTATION) as Face[];
  if (typeof camera === 'string') return FACE_ROTATION[oneOf('camera', sides, camera)];
  const { yaw, pitch, roll = 0 } = camera ?? {};
  for (const [name, value] of Object.entries({ yaw, pitch, roll }))
    if (!Number.isFinite(value)) throw wrong(`camera.${name}`, 'degrees', value);
  const angles = [turn('y', yaw), turn('x', -pitch), turn('z', -roll)] as const;
  const [around, over, upright] = angles;
  const looking = quat.multiply([0, 0, 0, 1], around, over);
  return quat.multiply(looking, looking, upright) as unknown as Quat;
}

function turn(axis: 'x' | 'y' | 'z', degrees: number): [number, number, number, number] {
  const half = (degrees * Math.PI) / 360;
  const sine = Math.sin(half);
  const along = (name: string) => (name === axis ? sine : 0);
  return [along('x'), along('y'), along('z'), Math.cos(half)];
}

const wrong = (place: string, expected: string, found: unknown) =>
  new FileError('picture', place, `expected ${expected}, found ${JSON.stringify(found) ?? String(found)}`);

/**
 * PNG; the picture has no transparent part.
 * @internal
 */
export async function pngOf(image: ImageData): Promise<Blob> {
  const canvas = document.createElement('canvas');
  canvas.width = image.width;
  canvas.height = image.height;
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser has no room for the picture.');
  context.putImageData(image, 0, 0);
  return new Promise((resolve, reject) =>
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new Error('This picture is too large.'))),
      'image/png',
    ),
  );
}
