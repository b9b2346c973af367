/** The materials of all passes: made when first used, kept for the life of the scene. */
import type { NodeMaterial, RenderTarget, Texture, WebGPURenderer } from 'three/webgpu';
import { edgeMaterial, type Kernel, type LineUniforms, lineMaterial } from './hbed.ts';
import type { ImageInputs } from './imageInputs.ts';
import { imageSurface, type Kept } from './imageSurface.ts';
import { type InkUniforms, inkMaterial } from './ink.ts';
import type { Style } from './look.ts';
import { type PageUniforms, pageMaterial } from './page.ts';
import type { PartMaterials } from './part.ts';
import { previewMaterial } from './preview.ts';
import { type SelectionUniforms, seenMaterial, silhouetteMaterial } from './selection.ts';
import { evenMaterial, gouraudMaterial, phongMaterial } from './shading.ts';
import { type Surface, triangles } from './surface.ts';
import type { Targets } from './targets.ts';
import { occluderMaterial, toonMaterial, wireMaterial } from './toon.ts';

export interface Uniforms {
  readonly lines: LineUniforms;
  readonly ink: InkUniforms;
  readonly page: PageUniforms;
  readonly selection: SelectionUniforms;
  readonly image: ImageInputs;
}

/** Where a surface comes from. */
export type From = 'plain' | 'painted' | 'image';

export class Materials implements PartMaterials {
  readonly line: NodeMaterial;
  readonly occluder: NodeMaterial;
  readonly wire: NodeMaterial;
  readonly lineWire: NodeMaterial;
  readonly preview: NodeMaterial;
  readonly silhouette: NodeMaterial;
  readonly seen: NodeMaterial;
  readonly #uniforms: Uniforms;
  readonly #targets: Targets;
  readonly #grain: Texture;
  readonly #renderer: WebGPURenderer;
  readonly #made = new Map<string, NodeMaterial>();
  readonly #surfaces = new Map<string, Surface>();

  constructor(renderer: WebGPURenderer, uniforms: Uniforms, targets: Targets, grain: Texture) {
    const { lines, page } = uniforms;
    const plain = triangles(false);
    this.#renderer = renderer;
    this.#uniforms = uniforms;
    this.#targets = targets;
    this.#grain = grain;
    this.line = this.#once('line', () => lineMaterial(plain, lines));
    this.occluder = this.#once('occluder', () => occluderMaterial(plain));
    this.wire = this.#once('wire', () => wireMaterial(page.line, true));
    this.lineWire = this.#once('line wire', () => wireMaterial(page.line, false));
    this.silhouette = this.#once('silhouette', () => silhouetteMaterial(plain));
    this.seen = this.#once('seen', () => seenMaterial(plain));
    this.preview = this.#once('preview', () => previewMaterial(targets.edges.texture, lines, page));
  }

  /** What parts are filled with. Ink and lines have no colours of their own. */
  fill(style: Style, from: From): NodeMaterial {
    const once = (make: (surface: Surface) => NodeMaterial) =>
      this.#once(`${style} ${from}`, () => make(this.#surface(from)));
    switch (style) {
      case 'toon':
        return once(toonMaterial);
      case 'gouraud':
        return from === 'image' ? once(evenMaterial) : once(() => gouraudMaterial(from === 'painted'));
      case 'phong':
        return once(phongMaterial);
      case 'hbed-ink':
        return from === 'painted'
          ? this.fill(style, 'plain')
          : once((surface) => inkMaterial(surface, this.#uniforms.ink));
      case 'hbed-lines':
        return from === 'image' ? this.ofImage('occluder') : this.occluder;
    }
  }

  /** What the image of surfaces is drawn with, beside what fills it. */
  ofImage(pass: 'line' | 'occluder' | 'silhouette' | 'others' | 'seen'): NodeMaterial {
    return this.#once(`${pass}, of the image`, () => {
      switch (pass) {
        case 'line':
          return lineMaterial(this.#surface('image'), this.#uniforms.lines);
        case 'occluder':
          return occluderMaterial(this.#surface('image'));
        case 'silhouette':
          return silhouetteMaterial(this.#surface('image', 'selected'));
        case 'others':
          return occluderMaterial(this.#surface('image', 'others'));
        case 'seen':
          return seenMaterial(this.#surface('image', 'selected'));
      }
    });
  }

  edges(kernel: Kernel): NodeMaterial {
    const { lines } = this.#targets;
    return this.#once(`edges ${kernel}`, () => edgeMaterial(lines.texture, this.#uniforms.lines, kernel));
  }

  page(lines: boolean, fills: boolean, previews: boolean, selected: boolean): NodeMaterial {
    const shown = (target: RenderTarget, on: boolean) => (on ? target.texture : null);
    const { edges, colour, preview, selection } = this.#targets;
    return this.#once(`page ${lines} ${fills} ${previews} ${selected}`, () =>
      pageMaterial(this.#uniforms, {
        grain: this.#grain,
        colour: shown(colour, fills),
        edges: shown(edges, lines),
        preview: shown(preview, previews),
        selection: shown(selection, selected),
      }),
    );
  }

  dispose(): void {
    for (const material of this.#made.values()) material.dispose();
  }

  #surface(from: From, kept: Kept = 'all'): Surface {
    const name = `${from} ${kept}`;
    const { image } = this.#uniforms;
    const make = () =>
      from === 'image' ? imageSurface(image, kept, this.#renderer) : triangles(from === 'painted');
    const made = this.#surfaces.get(name) ?? make();
    this.#surfaces.set(name, made);
    return made;
  }

  #once(name: string, make: () => NodeMaterial): NodeMaterial {
    const made = this.#made.get(name) ?? make();
    this.#made.set(name, made);
    return made;
  }
}
