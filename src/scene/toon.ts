/**
 * Toon shading (thesis 7.1): both dot products of Phong's equation are cut into bands. N·L below .1, .2, .7 and
 * above becomes .1, .3, .5, .7; the highlight is on where (N·H)^shininess exceeds .8.
 *
 * Departures: the thresholds are display values of 2006, so they are applied in display space (shaded linearly the
 * bands come out as .35 .58 .74 .85, washed out). Borders are ramps one pixel wide, because multisampling smooths
 * the edges of triangles only. The highlight is cut on N·H instead of its 40th power: the same curve, but its
 * slope stays moderate, so that the width of a pixel is measured well on small tips.
 */
import {
  cameraProjectionMatrix,
  cameraViewMatrix,
  float,
  mix,
  positionGeometry,
  vec3,
  vec4,
} from 'three/tsl';
import {
  CustomBlending,
  MeshBasicNodeMaterial,
  type Node,
  type NodeMaterial,
  OneFactor,
  OneMinusSrcAlphaFactor,
} from 'three/webgpu';
import { AMBIENT, GAIN, HALFWAY, LIGHT } from './light.ts';
import type { Surface } from './surface.ts';

export const THRESHOLDS = [0.1, 0.2, 0.7] as const;
/** Every band is one step above the last: .1 .3 .5 .7. */
export const LOWEST_BAND = 0.1;
export const BAND_STEP = 0.2;
const WIRE_OPACITY = 0.25;

/** 0 below the threshold, 1 above, a ramp of one pixel between, across which the value changes by `width`. */
function pixelStep(
  value: Node<'float'>,
  width: Node<'float'>,
  threshold: number | Node<'float'>,
): Node<'float'> {
  return value.sub(threshold).div(width).add(0.5).clamp(0, 1);
}

/** .1 .3 .5 .7 */
export function bandOf(surface: Surface): Node<'float'> {
  const facing = surface.normal.dot(LIGHT).toVar();
  const width = surface.change(LIGHT).toVar();
  const steps = THRESHOLDS.map((threshold) => pixelStep(facing, width, threshold).mul(BAND_STEP));
  return steps.reduce<Node<'float'>>((sum, step) => sum.add(step), float(LOWEST_BAND));
}

/** The colour of a surface in toon's light, display values. */
export function toonOf(surface: Surface): Node<'vec3'> {
  const { colour, finish } = surface;
  const light = AMBIENT.mul(finish.ambient).add(GAIN.mul(bandOf(surface).mul(finish.diffuse)));
  const lit = colour.mul(light).clamp(0, 1);
  return mix(lit, vec3(1), highlightOf(surface).mul(finish.white));
}

/** 1 on the highlight, 0 beside it. */
export const highlightOf = (surface: Surface): Node<'float'> =>
  pixelStep(surface.normal.dot(HALFWAY).toVar(), surface.change(HALFWAY).toVar(), surface.finish.cut);

export const toonMaterial = (surface: Surface): NodeMaterial =>
  surface.material('toon', () => vec4(toonOf(surface), 1));

/** Hides what is behind and shows nothing itself. */
export function occluderMaterial(surface: Surface): NodeMaterial {
  const material = surface.material('occluder', () => vec4(0));
  material.colorWrite = false;
  return material;
}

/** Moves wires towards the viewer, in parts of the depth range, so that their own triangles do not hide them. */
const WIRE_LIFT = 5e-4;

/** The triangles' edges, faintly, in the colour of the lines; `made`: three.js makes them of the triangles. */
export function wireMaterial(colour: Node<'vec3'>, made: boolean): NodeMaterial {
  // The base class lacks `wireframe`, which the renderer asks every material for.
  const material = new MeshBasicNodeMaterial();
  material.name = 'wire';
  material.wireframe = made;
  material.transparent = true;
  material.depthWrite = false;
  material.blending = CustomBlending;
  material.blendSrc = OneFactor;
  material.blendDst = OneMinusSrcAlphaFactor;
  const place = cameraProjectionMatrix.mul(cameraViewMatrix).mul(vec4(positionGeometry, 1)).toVar();
  material.vertexNode = vec4(place.xy, place.z.sub(place.w.mul(WIRE_LIFT)), place.w);
  material.fragmentNode = vec4(colour.mul(WIRE_OPACITY), WIRE_OPACITY);
  return material;
}
