/**
 * The light all styles share. Theory: Phong's equation with one directional light, V = (0, 0, 1) and the halfway
 * vector (thesis 7.1); every number is a display value, nothing is ever converted between colour spaces.
 *
 * Departures: the thesis' light vector subtracts a clip-space position from (1, 1, 1) and so turns with the
 * projection; ours is fixed to the camera, upper left. Its shaders flip the normal where N.z < 0, which draws
 * bright rims in perspective; ours flip by the side of the face.
 */
import {
  attribute,
  cameraProjectionMatrix,
  cameraViewMatrix,
  Fn,
  frontFacing,
  mix,
  normalGeometry,
  positionView,
  userData,
  vec3,
  vec4,
} from 'three/tsl';
import { InterpolationSamplingMode, InterpolationSamplingType, type Node } from 'three/webgpu';
import { AMBIENT_LIGHT, LAMP_LIGHT } from './finish.ts';

const DIAGONAL = 1 / Math.sqrt(3);
/** towards the light, view space */
export const LIGHT = vec3(-DIAGONAL, DIAGONAL, DIAGONAL);
/** halfway between the light and the viewer at (0, 0, 1): normalize(LIGHT + V) */
const HALFWAY_LENGTH = Math.hypot(-DIAGONAL, DIAGONAL, DIAGONAL + 1);
export const HALFWAY = vec3(
  -DIAGONAL / HALFWAY_LENGTH,
  DIAGONAL / HALFWAY_LENGTH,
  (DIAGONAL + 1) / HALFWAY_LENGTH,
);

export const AMBIENT = vec3(...AMBIENT_LIGHT);
export const GAIN = vec3(...LAMP_LIGHT);
/** The part's own colour, display values 0–1, set on the object that is drawn. */
export const partColour = userData('colour', 'vec3') as unknown as Node<'vec3'>;

/** A finish in a shader (finish.ts). */
export interface FinishNodes {
  readonly ambient: Node<'float'>;
  readonly diffuse: Node<'float'>;
  readonly white: Node<'float'>;
  readonly gleam: Node<'float'>;
  readonly exponent: Node<'float'>;
  readonly cut: Node<'float'>;
  readonly chalk: Node<'float'>;
}

export const finishNodes = (light: Node<'vec4'>, peak: Node<'vec4'>): FinishNodes => ({
  ambient: light.x,
  diffuse: light.y,
  white: light.z,
  gleam: light.w,
  exponent: peak.x,
  cut: peak.y,
  chalk: peak.z,
});

/** The part's own, set on the object that is drawn. */
export const partFinish = finishNodes(
  userData('light', 'vec4') as unknown as Node<'vec4'>,
  userData('peak', 'vec4') as unknown as Node<'vec4'>,
);

/** Linear light, 0–1 → display values (sRGB's own curve). */
export function displayed(linear: Node<'vec3'>): Node<'vec3'> {
  const curve = linear
    .max(0)
    .pow(1 / 2.4)
    .mul(1.055)
    .sub(0.055);
  return mix(curve, linear.mul(12.92), vec3(linear.lessThanEqual(0.0031308)));
}

/** A painted mesh's colours, which are linear, as display values 0–1, of the vertex stage. */
export const vertexColour = displayed(attribute<'vec3'>('colour', 'vec3'));

/** The vertex normal in view space, outward, of the vertex stage. Parts are never scaled, so no inverse is due. */
export const vertexNormal = cameraViewMatrix.mul(vec4(normalGeometry, 0)).xyz;

/**
 * Vertex → pixel, at a covered place of the pixel: at its middle, outside a sliver of the outline, a normal would
 * run on far beyond the form and draw dark specks along the rim.
 */
export function interpolated(value: Node<'vec3'>, name: string): Node<'vec3'> {
  return value
    .toVarying(name)
    .setInterpolation(InterpolationSamplingType.PERSPECTIVE, InterpolationSamplingMode.CENTROID);
}

/** The same from vertex to pixel, in place of `partColour`. */
export const paintedColour = interpolated(vertexColour, 'rotund_colour');

const interpolatedNormal = interpolated(vertexNormal, 'rotund_normal');

// 1 in perspective, 0 in orthographic projection
const perspective = cameraProjectionMatrix.mul(vec4(0, 0, 1, 0)).w.negate();

/** From a place in view space, unit. */
export const eyeFrom = (place: Node<'vec3'>): Node<'vec3'> =>
  place
    .negate()
    .mul(perspective)
    .add(vec3(0, 0, perspective.oneMinus()))
    .normalize();

/** Sine of the angle to the outline within which a back face keeps its outward normal. */
export const RIM = 0.15;

/**
 * The unit normal that faces the viewer, view space, of the fragment stage. At poles and tips interpolation may
 * meet a zero vector; the floor keeps it finite, so no pixel flickers.
 *
 * On the outline of a closed form front and back faces meet so steeply that the depth test, which sees corners
 * snapped to fractions of a pixel, lets some samples of the back through. Flipped, they would draw a rim in the
 * colour of the other side; so near the outline the normal stays as it is.
 */
export const facingNormal = Fn(() => {
  const outward = interpolatedNormal.div(interpolatedNormal.length().max(1e-6)).toVar();
  const turnedAway = frontFacing.not().and(outward.dot(eyeFrom(positionView)).lessThan(-RIM));
  return turnedAway.select(outward.negate(), outward);
})().toVar();
