/**
 * What every style is told of the surface in a pixel, be it of triangles or of an image (imageSurface.ts): a style asks for nothing
 * else, so that it is written once.
 */
import { dFdx, dFdy, positionGeometry, positionView, vec2 } from 'three/tsl';
import { DoubleSide, type Node, NodeMaterial } from 'three/webgpu';
import { type FinishNodes, facingNormal, paintedColour, partColour, partFinish } from './light.ts';

export interface Surface {
  readonly name: string;
  /** unit, towards the viewer, view space */
  readonly normal: Node<'vec3'>;
  /** display values */
  readonly colour: Node<'vec3'>;
  readonly finish: FinishNodes;
  /** in the model, mm */
  readonly place: Node<'vec3'>;
  /** in view space, mm */
  readonly z: Node<'float'>;
  /** how much N · direction changes across one pixel where it is steepest */
  change(direction: Node<'vec3'>): Node<'float'>;
  /** A material for it, that shows what `pixel` gives. */
  material(name: string, pixel: () => Node<'vec4'>): NodeMaterial;
}

/** `painted`: each vertex has a colour of its own. */
export const triangles = (painted: boolean): Surface => ({
  name: painted ? ', painted' : '',
  normal: facingNormal,
  colour: painted ? paintedColour : partColour,
  finish: partFinish,
  place: positionGeometry.toVarying('rotund_place'),
  z: positionView.z,
  change: (direction) => pixelWidth(facingNormal.dot(direction).toVar()),
  material: (name, pixel) => {
    const material = new NodeMaterial();
    material.name = name;
    material.side = DoubleSide;
    material.fragmentNode = pixel();
    return material;
  },
});

/** How much the value changes across one pixel in the direction of its steepest slope. */
export function pixelWidth(value: Node<'float'>): Node<'float'> {
  return vec2(dFdx(value), dFdy(value)).length().max(1e-5);
}
