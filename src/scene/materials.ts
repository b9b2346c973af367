/** The materials of all passes: made when first used, kept for the life of the scene. */
import type { NodeMaterial, RenderTarget, Texture } from 'three/webgpu';
import { edgeMaterial, type Kernel, type LineUniforms, lineMaterial } from './hbed.ts';
import { type InkUniforms, inkMaterial } from './ink.ts';
import type { Style } from './look.ts';
import { type PageUniforms, pageMaterial } from './page.ts';
import type { PartMaterials } from './part.ts';
import { previewMaterial } from './preview.ts';
import { type SelectionUniforms, seenMaterial, silhouetteMaterial } from './selection.ts';
import { gouraudMaterial, phongMaterial } from './shading.ts';
import type { Targets } from './targets.ts';
import { occluderMaterial, toonMaterial, wireMaterial } from './toon.ts';

export interface Uniforms {
  readonly lines: LineUniforms;
  readonly ink: InkUniforms;
  readonly page: PageUniforms;
  readonly selection: SelectionUniforms;
}

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
  readonly #made = new Map<string, NodeMaterial>();

  constructor(uniforms: Uniforms, targets: Targets, grain: Texture) {
    const { lines, page } = uniforms;
    this.#uniforms = uniforms;
    this.#targets = targets;
    this.#grain = grain;
    this.line = this.#once('line', () => lineMaterial(lines));
    this.occluder = this.#once('occluder', occluderMaterial);
    this.wire = this.#once('wire', () => wireMaterial(page.line, true));
    this.lineWire = this.#once('line wire', () => wireMaterial(page.line, false));
    this.silhouette = this.#once('silhouette', silhouetteMaterial);
    this.seen = this.#once('seen', seenMaterial);
    this.preview = this.#once('preview', () => previewMaterial(targets.edges.texture, lines, page));
  }

  /** What parts are filled with; `painted`: each vertex has a colour of its own. Ink and lines have none. */
  fill(style: Style, painted: boolean): NodeMaterial {
    const once = (make: (painted: boolean) => NodeMaterial) =>
      this.#once(painted ? `${style} painted` : style, () => make(painted));
    switch (style) {
      case 'toon':
        return once(toonMaterial);
      case 'gouraud':
        return once(gouraudMaterial);
      case 'phong':
        return once(phongMaterial);
      case 'hbed-ink':
        return this.#once(style, () => inkMaterial(this.#uniforms.ink));
      case 'hbed-lines':
        return this.occluder;
    }
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

  #once(name: string, make: () => NodeMaterial): NodeMaterial {
    const made = this.#made.get(name) ?? make();
    this.#made.set(name, made);
    return made;
  }
}
