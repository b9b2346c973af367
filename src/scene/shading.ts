/**
 * Smooth shading: the same light as toon without thresholds. Gouraud lights the vertices and interpolates the
 * colours; Phong interpolates the normal and lights every pixel, with a quarter of the ambient light, as the
 * thesis' shaders have it.
 */
import { frontFacing, vec3, vec4 } from 'three/tsl';
import { DoubleSide, type Node, NodeMaterial } from 'three/webgpu';
import {
  AMBIENT,
  GAIN,
  HALFWAY,
  interpolated,
  LIGHT,
  partColour,
  SHININESS,
  vertexColour,
  vertexNormal,
} from './light.ts';
import type { Surface } from './surface.ts';

const PHONG_AMBIENT = 0.25;
/** Full ambient and full diffuse light add up to 1.26; at .7 a lit form is as bright as toon's lightest band. */
const GOURAUD_GAIN = 0.7;
/** white added at the middle of the highlight: it stays tinted, as wax or fruit do */
const HIGHLIGHT = 0.25;

/** Light that reaches a surface with this unit normal: what multiplies its colour, and what is added to it. */
function lighting(normal: Node<'vec3'>, ambient: Node<'vec3'>, gain: number) {
  const facing = normal.dot(LIGHT).max(0);
  const highlight = normal.dot(HALFWAY).max(0).pow(SHININESS);
  return { diffuse: ambient.add(GAIN.mul(facing.mul(gain))), highlight: highlight.mul(HIGHLIGHT) };
}

function shaded(colour: Node<'vec3'>, normal: Node<'vec3'>, ambient: Node<'vec3'>, gain: number) {
  const { diffuse, highlight } = lighting(normal, ambient, gain);
  return colour.mul(diffuse).add(vec3(highlight)).clamp(0, 1);
}

export const phongMaterial = (surface: Surface): NodeMaterial =>
  surface.material('phong', () =>
    vec4(shaded(surface.colour, surface.normal, AMBIENT.mul(PHONG_AMBIENT), 1), 1),
  );

/** Gouraud's light where there are no vertices: every pixel is one. */
export const evenMaterial = (surface: Surface): NodeMaterial =>
  surface.material('gouraud', () => vec4(shaded(surface.colour, surface.normal, AMBIENT, GOURAUD_GAIN), 1));

export function gouraudMaterial(painted: boolean): NodeMaterial {
  const colour = painted ? vertexColour : partColour;
  // A vertex does not know which side of its faces will be seen: both are lit, the pixel chooses.
  const outward = vertexNormal.div(vertexNormal.length().max(1e-6));
  const front = interpolated(shaded(colour, outward, AMBIENT, GOURAUD_GAIN), 'rotund_front');
  const back = interpolated(shaded(colour, outward.negate(), AMBIENT, GOURAUD_GAIN), 'rotund_back');
  const material = new NodeMaterial();
  material.name = painted ? 'gouraud, painted' : 'gouraud';
  material.side = DoubleSide;
  material.fragmentNode = vec4(frontFacing.select(front, back), 1);
  return material;
}
