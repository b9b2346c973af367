/**
 * Smooth shading: the same light as toon without thresholds. Gouraud lights the vertices and interpolates the
 * colours; Phong interpolates the normal and lights every pixel, with a quarter of the ambient light, as the
 * thesis' shaders have it.
 */
import { frontFacing, vec3, vec4 } from 'three/tsl';
import { DoubleSide, type Node, NodeMaterial } from 'three/webgpu';
import {
  AMBIENT,
  type FinishNodes,
  GAIN,
  HALFWAY,
  interpolated,
  LIGHT,
  partColour,
  partFinish,
  vertexColour,
  vertexNormal,
} from './light.ts';
import type { Surface } from './surface.ts';

const PHONG_AMBIENT = 0.25;
/** Full ambient and full diffuse light add up to 1.26; at .7 a lit form is as bright as toon's lightest band. */
const GOURAUD_GAIN = 0.7;

/** Light that reaches a surface with this unit normal: what multiplies its colour, and what is added to it. */
function lighting(normal: Node<'vec3'>, finish: FinishNodes, ambient: Node<'vec3'>, gain: number) {
  const facing = normal.dot(LIGHT).max(0);
  const highlight = normal.dot(HALFWAY).max(0).pow(finish.exponent);
  const lamp = GAIN.mul(facing.mul(gain).mul(finish.diffuse));
  return { diffuse: ambient.mul(finish.ambient).add(lamp), highlight: highlight.mul(finish.gleam) };
}

function shaded(
  { colour, normal, finish }: Pick<Surface, 'colour' | 'normal' | 'finish'>,
  ambient: Node<'vec3'>,
  gain: number,
) {
  const { diffuse, highlight } = lighting(normal, finish, ambient, gain);
  return colour.mul(diffuse).add(vec3(highlight)).clamp(0, 1);
}

export const phongMaterial = (surface: Surface): NodeMaterial =>
  surface.material('phong', () => vec4(shaded(surface, AMBIENT.mul(PHONG_AMBIENT), 1), 1));

/** Gouraud's light where there are no vertices: every pixel is one. */
export const evenMaterial = (surface: Surface): NodeMaterial =>
  surface.material('gouraud', () => vec4(shaded(surface, AMBIENT, GOURAUD_GAIN), 1));

export function gouraudMaterial(painted: boolean): NodeMaterial {
  const colour = painted ? vertexColour : partColour;
  // A vertex does not know which side of its faces will be seen: both are lit, the pixel chooses.
  const outward = vertexNormal.div(vertexNormal.length().max(1e-6));
  const lit = (normal: Node<'vec3'>) => shaded({ colour, normal, finish: partFinish }, AMBIENT, GOURAUD_GAIN);
  const front = interpolated(lit(outward), 'rotund_front');
  const back = interpolated(lit(outward.negate()), 'rotund_back');
  const material = new NodeMaterial();
  material.name = painted ? 'gouraud, painted' : 'gouraud';
  material.side = DoubleSide;
  material.fragmentNode = vec4(frontFacing.select(front, back), 1);
  return material;
}
