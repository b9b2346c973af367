/**
 * The blue contour of what is selected. One pass draws a mask: red is the selected parts' silhouette whatever lies
 * before it, green where they are really seen. The page pass then draws a line along the edge of red: in full where
 * green is beside it, lightly where another part hides it, so that one sees what is selected behind a form.
 */
import { float, screenUV, texture, uniform, vec2, vec4 } from 'three/tsl';
import { type Node, type NodeMaterial, type Texture, Vector2, Vector3 } from 'three/webgpu';
import type { Surface } from './surface.ts';

/** CSS pixels: how far the line reaches outward and inward of the silhouette; the drawn contour stays in sight inside */
const REACH = { out: 2.2, in: 1 } as const;
/** opacity where the edge is hidden */
const HIDDEN = 0.35;
/** looks at the mask around a pixel */
const LOOKS = 12;

export class SelectionUniforms {
  readonly pencil = uniform(new Vector3());
  /** one CSS pixel, in parts of the screen */
  readonly pixel = uniform(new Vector2());
}

export const MASK_ORDER = { silhouette: -1, others: 0, seen: 1 } as const;

/** Red, through everything. */
export function silhouetteMaterial(surface: Surface): NodeMaterial {
  const material = surface.material('silhouette', () => vec4(1, 0, 0, 1));
  material.depthTest = false;
  material.depthWrite = false;
  return material;
}

/** Green as well, where nothing is before it. */
export const seenMaterial = (surface: Surface): NodeMaterial =>
  surface.material('selected', () => vec4(1, 1, 0, 1));

/** How much of a pixel is contour, 0–1. */
export function contourCoverage(mask: Texture, { pixel }: SelectionUniforms): Node<'float'> {
  const ring = (reach: number): Node<'vec2'>[] =>
    Array.from({ length: LOOKS }, (_, i) => {
      const angle = (2 * Math.PI * (i + 0.5)) / LOOKS;
      const away = vec2(Math.cos(angle) * reach, Math.sin(angle) * reach);
      return texture(mask, screenUV.add(away.mul(pixel))).xy.toVar();
    });
  const outer = ring(REACH.out);
  const inner = ring(REACH.in);
  const most = outer.reduce<Node<'float'>>((value, look) => value.max(look.x), float(0));
  const least = inner.reduce<Node<'float'>>((value, look) => value.min(look.x), float(1));
  const seen = outer.reduce<Node<'float'>>((value, look) => value.max(look.y), float(0)).clamp(0, 1);
  return most
    .sub(least)
    .clamp(0, 1)
    .mul(seen.mul(1 - HIDDEN).add(HIDDEN));
}
