/**
 * Forms not yet kept: the bands of toon, lightly and without contour, because the person's own strokes are the
 * contour. They are a layer of their own over the drawn page, premultiplied; a line of a kept part that lies before
 * the form is cut out of the layer, so that it keeps its full width and colour.
 */
import { float, vec4 } from 'three/tsl';
import { NoBlending, type NodeMaterial, type Texture } from 'three/webgpu';
import { type LineUniforms, sceneDepth } from './hbed.ts';
import { type PageUniforms, smoothCoverage } from './page.ts';
import { triangles } from './surface.ts';
import { toonOf } from './toon.ts';

/** How much nearer a line must be than the form, in parts of the scene's depth; 8 bits keep 1/255. */
const NEARER = 0.01;

export function previewMaterial(edges: Texture, lines: LineUniforms, page: PageUniforms): NodeMaterial {
  const surface = triangles(false);
  const line = smoothCoverage(edges, page).toVar();
  const lineDepth = float(1).sub(line.y.div(line.x.max(1e-3)));
  const before = lineDepth.lessThan(sceneDepth(surface, lines).sub(NEARER)).select(line.x, 0);
  const opacity = before.mul(page.lined).oneMinus().mul(page.preview);
  const material = surface.material('preview', () => vec4(toonOf(surface).mul(opacity), opacity));
  // after the depth of all forms, and without writing it again
  material.transparent = true;
  material.blending = NoBlending;
  material.depthWrite = false;
  return material;
}
