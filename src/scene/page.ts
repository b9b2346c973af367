/**
 * The last pass: the sheet with everything on it. Colour and preview come premultiplied; all of it is display
 * values, so the blending is that of a paint program, and a toon band arrives on the screen unchanged.
 */
import { mix, screenCoordinate, screenUV, texture, uniform, vec2, vec4 } from 'three/tsl';
import { type Node, NodeMaterial, type Texture, Vector2, Vector3 } from 'three/webgpu';
import { TILE } from './paper.ts';
import { contourCoverage, type SelectionUniforms } from './selection.ts';

/** Opacity of forms not yet kept; behind a guide they step back. */
export const PREVIEW = { opacity: 0.86, faint: 0.3 } as const;

export class PageUniforms {
  readonly paper = uniform(new Vector3());
  readonly line = uniform(new Vector3());
  /** greatest departure from the paper's luminance; 0 = smooth */
  readonly grain = uniform(0);
  /** device pixels a CSS pixel */
  readonly pixelRatio = uniform(1);
  /** half the distance of the four looks at the coverage, in parts of the screen */
  readonly tent = uniform(new Vector2());
  /** 1 when this frame has lines */
  readonly lined = uniform(0);
  /** of forms not yet kept */
  readonly preview = uniform(PREVIEW.opacity);
}

export interface PageTextures {
  readonly grain: Texture;
  readonly colour: Texture | null;
  readonly edges: Texture | null;
  readonly preview: Texture | null;
  readonly selection: Texture | null;
}

export function pageMaterial(
  { page: uniforms, selection }: { readonly page: PageUniforms; readonly selection: SelectionUniforms },
  textures: PageTextures,
): NodeMaterial {
  let page: Node<'vec3'> = paper(uniforms, textures.grain);
  if (textures.colour) page = over(page, texture(textures.colour, screenUV));
  if (textures.edges) page = mix(page, uniforms.line, smoothCoverage(textures.edges, uniforms).x);
  if (textures.preview) page = over(page, texture(textures.preview, screenUV));
  if (textures.selection) page = mix(page, selection.pencil, contourCoverage(textures.selection, selection));
  const material = new NodeMaterial();
  material.name = 'page';
  material.depthTest = false;
  material.depthWrite = false;
  material.fragmentNode = vec4(page, 1);
  return material;
}

function paper(uniforms: PageUniforms, grain: Texture): Node<'vec3'> {
  const place = screenCoordinate.xy.div(uniforms.pixelRatio).div(TILE);
  // The tile's values gather around ½; twice the spread makes the grain's ±1.5 % its real reach.
  const noise = texture(grain, place).x.sub(0.5).mul(4).clamp(-1, 1);
  return uniforms.paper.mul(noise.mul(uniforms.grain).add(1));
}

/** Four linear looks around the pixel: a tent over 3 × 3 or 4 × 4 texels of coverage and nearness. */
export function smoothCoverage(edges: Texture, uniforms: PageUniforms): Node<'vec2'> {
  const look = (x: number, y: number): Node<'vec2'> =>
    texture(edges, screenUV.add(vec2(x, y).mul(uniforms.tent))).xy;
  return look(-1, -1).add(look(1, -1)).add(look(-1, 1)).add(look(1, 1)).mul(0.25);
}

function over(below: Node<'vec3'>, above: Node<'vec4'>): Node<'vec3'> {
  return below.mul(above.w.oneMinus()).add(above.xyz);
}
