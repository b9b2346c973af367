/**
 * The paper: its colour, and a grain of ±1.5 % luminance made once as a tile of 512 × 512 texels: low clouds, a
 * finer tooth, and fibres (noise stretched along two directions). Integer hashing makes it the same on every
 * device; it lies still on the screen, like the sheet under a drawing.
 */
import { float, floor, fract, hash, screenCoordinate, vec2, vec4 } from 'three/tsl';
import {
  LinearFilter,
  type Node,
  NodeMaterial,
  QuadMesh,
  RedFormat,
  RenderTarget,
  RepeatWrapping,
  UnsignedByteType,
  type WebGPURenderer,
} from 'three/webgpu';

/** texels a side, one to a CSS pixel */
export const TILE = 512;
/** greatest departure from the paper's luminance */
export const GRAIN = 0.015;

/** cells a tile along x and y, and share; each pair divides the tile, so that it repeats without a seam */
const LAYERS: readonly (readonly [x: number, y: number, share: number])[] = [
  // clouds
  [8, 8, 0.25],
  [32, 32, 0.2],
  // tooth
  [256, 256, 0.25],
  // fibres, lying and standing
  [32, 256, 0.2],
  [256, 64, 0.1],
];

/** A tile of noise, 0–1, ½ on the average. */
export function makeGrain(renderer: WebGPURenderer): RenderTarget {
  const target = new RenderTarget(TILE, TILE, {
    type: UnsignedByteType,
    format: RedFormat,
    depthBuffer: false,
    minFilter: LinearFilter,
    magFilter: LinearFilter,
    wrapS: RepeatWrapping,
    wrapT: RepeatWrapping,
  });
  target.texture.name = 'paper grain';
  const material = new NodeMaterial();
  material.name = 'paper grain';
  material.fragmentNode = vec4(grain(screenCoordinate.xy.div(TILE)), 0, 0, 1);
  renderer.setRenderTarget(target);
  new QuadMesh(material).render(renderer);
  renderer.setRenderTarget(null);
  material.dispose();
  return target;
}

function grain(uv: Node<'vec2'>): Node<'float'> {
  let sum: Node<'float'> = float(0);
  LAYERS.forEach(([x, y, share], layer) => {
    sum = sum.add(valueNoise(uv, x, y, layer).mul(share));
  });
  return sum;
}

/** Smooth noise through random values at the corners of x × y cells. */
function valueNoise(uv: Node<'vec2'>, x: number, y: number, layer: number): Node<'float'> {
  const place = uv.mul(vec2(x, y));
  const cell = floor(place);
  const inside = fract(place);
  const blend = inside.mul(inside).mul(inside.mul(-2).add(3));
  const corner = (right: number, down: number): Node<'float'> => {
    const column = cell.x.add(right).mod(x);
    const row = cell.y.add(down).mod(y);
    // one number a corner, different in every layer
    return hash(
      row
        .mul(x)
        .add(column)
        .add(layer * TILE * TILE),
    ) as Node<'float'>;
  };
  const top = corner(0, 0).add(corner(1, 0).sub(corner(0, 0)).mul(blend.x));
  const bottom = corner(0, 1).add(corner(1, 1).sub(corner(0, 1)).mul(blend.x));
  return top.add(bottom.sub(top).mul(blend.y));
}
