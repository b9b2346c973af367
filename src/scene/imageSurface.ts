/**
 * The surface that an image shows, for the same styles as triangles: the nearest texel says whether there is any, how deep and how
 * turned; what lies before it or behind it is for the depth test to tell, in every pixel.
 */
import {
  cameraProjectionMatrix,
  cameraProjectionMatrixInverse,
  cameraViewMatrix,
  cameraWorldMatrix,
  Fn,
  float,
  ivec2,
  mix,
  positionGeometry,
  vec2,
  vec4,
} from 'three/tsl';
import { type Node, NodeMaterial, WebGLCoordinateSystem, type WebGPURenderer } from 'three/webgpu';
import { FACTS, FLAGS, type ImageInputs, MOST_ITEMS } from './imageInputs.ts';
import { displayed, eyeFrom, finishNodes, RIM } from './light.ts';
import type { Surface } from './surface.ts';

/** Which items of the image are drawn. */
export type Kept = 'all' | 'selected' | 'others';

/** mm: what is as far behind is NOWHERE (field/rayImage.ts) */
const BEYOND = -1e29;
/** more than any normal changes */
const MOST = 4;

export function imageSurface(inputs: ImageInputs, kept: Kept, renderer: WebGPURenderer): Surface {
  const { size, pivot } = inputs;
  const screen = positionGeometry.xy.toVarying('rotund_screen');
  const texel = vec2(screen.x.add(1), screen.y.oneMinus()).mul(0.5).mul(size).floor().toVar();
  const look = (right: number, down: number): Node<'vec4'> =>
    inputs.surface.load(ivec2(texel.add(vec2(right, down)).clamp(vec2(0), size.sub(1)))) as Node<'vec4'>;
  const here = look(0, 0).toVar();
  const painted = (inputs.colours.load(ivec2(texel)) as Node<'vec4'>).toVar();
  const told = (row: number): Node<'vec4'> => {
    const item = ivec2(vec2(painted.w.sub(1).clamp(0, MOST_ITEMS - 1), row));
    return (inputs.facts.load(item) as Node<'vec4'>).toVar();
  };
  const facts = told(FACTS.colour);

  const z = here.w.add(pivot).toVar();
  const clip = cameraProjectionMatrix.mul(vec4(0, 0, z, 1)).toVar();
  const deep = clip.z.div(clip.w).toVar();
  const from = cameraProjectionMatrixInverse.mul(vec4(screen, deep, 1)).toVar();
  const place = from.xyz.div(from.w).toVar();

  const outward = cameraViewMatrix.mul(vec4(here.xyz, 0)).xyz.toVar();
  // seen from within, where the camera is
  const side = outward.dot(eyeFrom(place)).lessThan(-RIM).select(float(-1), float(1)).toVar();
  const isThere = here.w.greaterThan(BEYOND);
  const isSelected = facts.w.greaterThan(FLAGS.selected - 0.5);
  const isKept = {
    all: isThere,
    selected: isThere.and(isSelected),
    others: isThere.and(isSelected.not()),
  }[kept];
  const hasColour = facts.w.mod(2).greaterThan(FLAGS.coloured - 0.5);

  /** Of the two neighbours along an axis the one that differs less: beyond an edge lies another surface, or nothing. */
  const least = (value: Node<'float'>, along: Node<'vec3'>, right: number, down: number): Node<'float'> => {
    const off = (sign: 1 | -1): Node<'float'> => {
      const other = look(sign * right, sign * down).toVar();
      const change = other.xyz.dot(along).sub(value).abs();
      return other.w.greaterThan(BEYOND).select(change, float(MOST));
    };
    const change = off(1).min(off(-1)).toVar();
    return change.lessThan(MOST).select(change, float(0));
  };

  return {
    name: `, of an image, ${kept}`,
    normal: outward.mul(side).toVar(),
    colour: mix(displayed(painted.xyz), facts.xyz, hasColour.select(float(1), float(0))).toVar(),
    finish: finishNodes(told(FACTS.light), told(FACTS.peak)),
    place: cameraWorldMatrix.mul(vec4(place, 1)).xyz.toVar(),
    z,
    change: (direction) => {
      const along = cameraWorldMatrix.mul(vec4(direction, 0)).xyz.toVar();
      const value = here.xyz.dot(along).toVar();
      return vec2(least(value, along, 1, 0), least(value, along, 0, 1))
        .length()
        .max(1e-5);
    },
    material: (name, pixel) => {
      const material = new NodeMaterial();
      material.name = `${name}, of an image`;
      material.vertexNode = vec4(positionGeometry.xy, 0, 1);
      material.fragmentNode = Fn(() => {
        isKept.not().discard();
        return pixel();
      })();
      const isWebGL = renderer.coordinateSystem === WebGLCoordinateSystem;
      material.depthNode = (isWebGL ? deep.mul(0.5).add(0.5) : deep).clamp(0, 1);
      return material;
    },
  };
}
