/**
 * A frame, as the list of its passes:
 *
 *   1 lines    parts → normals and depth, one sample a texel                   when the style draws lines
 *   2 edges    a kernel over them → how much of a texel is line                alike
 *   3 colour   parts in the style's material, wires, grid, guides → 4 samples a pixel  unless there is nothing to fill
 *   4 preview  forms not yet kept, lightly → 4 samples a pixel                 when there are any
 *   5 mask     what is selected, and what hides it → 4 samples a pixel         when anything is
 *   6 page     paper, colour, lines, preview, blue contour → the canvas, or a target of its own for a picture
 *   7 fade     the picture before, lightly → over it                            while one body goes over into the next
 *
 * Where rays were cast for surfaces, 1 to 5 draw their image in place of the triangles, as often as there are images, each with the camera as
 * the rays had it, and 6 is the mean of all these pictures (refinement.ts).
 *
 * Lines and colour are two passes because attachments of one pass share a sample count, and normals must not be
 * averaged before they are compared. The line passes run at up to twice the screen's resolution and the page pass
 * averages their coverage over a small tent, so no staircase remains.
 */

import type { Scene as ThreeScene, WebGPURenderer } from 'three/webgpu';
import {
  type Camera,
  Color,
  type NodeMaterial,
  QuadMesh,
  type RenderTarget,
  Vector2,
  Vector3,
} from 'three/webgpu';
import type { Vec3 } from '../math/vec.ts';
import type { View } from '../stroke/stroke.ts';
import { ALL, Fade, type Known } from './fade.ts';
import { Grid } from './grid.ts';
import { Guides } from './guides.ts';
import { type Kernel, LineUniforms } from './hbed.ts';
import { ImageInputs } from './imageInputs.ts';
import { ImageProxy } from './imageProxy.ts';
import { InkUniforms } from './ink.ts';
import { jittered, type ViewCamera } from './jitter.ts';
import {
  DEFAULT_LOOK,
  displayRgb,
  isDark,
  type Look,
  lineColour,
  PAPER_COLOUR,
  pencilColour,
} from './look.ts';
import { Materials } from './materials.ts';
import { PageUniforms, PREVIEW } from './page.ts';
import { GRAIN, makeGrain } from './paper.ts';
import { type Fill, Parts } from './part.ts';
import { Refinement } from './refinement.ts';
import { Seam } from './seam.ts';
import { SelectionUniforms } from './selection.ts';
import type { SurfaceImage } from './surfaceImage.ts';
import { makeTargets } from './targets.ts';

/** Lines are found at up to this many texels a CSS pixel, at most twice the screen's resolution, … */
const LINE_DENSITY = 4;
/** … and in at most this many texels (12 bytes each), unless the scene's options say otherwise. */
export const LINE_TEXELS = 9e6;
/** For pictures, where time is no matter: twice the resolution of 2400 × 1800 pixels. */
export const FINE_LINE_TEXELS = 18e6;
/** A software adapter takes .2 µs for a texel. */
export const LINE_TEXELS_IN_SOFTWARE = 1e6;
/** No normal, encoded: what HBED compares an outline with. */
const NO_NORMAL = new Color().setRGB(0.5, 0.5, 0.5);
const CLEAR = new Color(0);
/** Depth 1 in the line pass, nothing at all in the others. */
const FAR = 1;
const NOTHING = 0;

export interface PipelineOptions {
  /** the most texels lines are found in */
  readonly lineTexels: number;
  /** the longest side of a texture of this device, texels */
  readonly maxSide: number;
  /** in place of the canvas, whose size then stays as it is */
  readonly output?: RenderTarget;
}

export interface Refining {
  /** images after which nothing is seen any more of the frame with triangles */
  readonly enough?: number;
  /** the rows of the image that are there: the others show that frame */
  readonly known?: Known;
  /** it is a frame of its own, like one that `render` draws: the view may be another one */
  readonly alone?: boolean;
}

export class Pipeline {
  readonly parts: Parts;
  /** of the last frame, over all passes */
  drawCalls = 0;
  triangles = 0;
  readonly #renderer: WebGPURenderer;
  readonly #options: PipelineOptions;
  readonly #grid = new Grid();
  readonly #guides = new Guides();
  readonly #lines = new LineUniforms();
  readonly #ink = new InkUniforms();
  readonly #page = new PageUniforms();
  readonly #selection = new SelectionUniforms();
  readonly #targets = makeTargets();
  readonly #fade = new Fade();
  readonly #image = new ImageInputs();
  readonly #refinement = new Refinement();
  readonly #seam: Seam;
  /** made when the first image comes */
  #proxy: ImageProxy | null = null;
  readonly #grain: RenderTarget;
  readonly #materials: Materials;
  readonly #quad: QuadMesh;
  readonly #size = new Vector2(1, 1);
  #look: Look = DEFAULT_LOOK;
  #pixelRatio = 1;
  /** what the last frame's page was made with; null: its passes are gone */
  #sheet: NodeMaterial | null = null;

  constructor(renderer: WebGPURenderer, options: PipelineOptions) {
    this.#renderer = renderer;
    this.#options = options;
    this.#grain = makeGrain(renderer);
    this.#seam = new Seam(renderer);
    const [lines, ink, page] = [this.#lines, this.#ink, this.#page];
    const uniforms = { lines, ink, page, selection: this.#selection, image: this.#image };
    this.#materials = new Materials(renderer, uniforms, this.#targets, this.#grain.texture);
    this.parts = new Parts(this.#materials, this.#fill('toon'), this.#seam);
    this.#quad = new QuadMesh(this.#materials.occluder);
    this.parts.colour.add(this.#grid.mesh, this.#guides.lines);
    this.setLook(DEFAULT_LOOK);
  }

  /** device pixels */
  get pixels(): { readonly width: number; readonly height: number } {
    return { width: this.#size.x, height: this.#size.y };
  }

  /** Images in the mean that is seen, 0: triangles only; null: the frame is gone. */
  get refined(): number | null {
    return this.#sheet === null ? null : this.#refinement.count;
  }

  setLook(look: Look): void {
    this.#look = look;
    this.#forget();
    const ink = displayRgb(lineColour(look.background));
    this.#page.paper.value.set(...displayRgb(PAPER_COLOUR[look.background]));
    this.#page.line.value.set(...ink);
    const pencil = displayRgb(pencilColour(look.background));
    this.#selection.pencil.value.set(...pencil);
    this.#guides.setColour(pencil);
    this.#page.grain.value = look.grain && look.background === 'paper' ? GRAIN : 0;
    this.#ink.colour.value.set(...ink);
    this.#ink.chalk.value = isDark(look.background) ? 1 : 0;
    this.#lines.creases.value = look.creases;
    this.#lines.overlaps.value = look.overlaps;
    this.#grid.setColour(ink);
    this.#grid.mesh.visible = look.grid;
    this.parts.setFill(this.#fill(look.style));
    this.parts.setWireframe(look.wireframe);
    this.#scaleLines();
  }

  setFaint(on: boolean): void {
    this.#page.preview.value = on ? PREVIEW.faint : PREVIEW.opacity;
    this.#forget();
  }

  /** Lines over the picture, six numbers each, mm; null: none. */
  guide(ends: Float32Array | null): void {
    if (this.#guides.put(ends)) this.#forget();
  }

  /** CSS pixels, and device pixels a CSS pixel. */
  resize(width: number, height: number, pixelRatio: number): void {
    this.#pixelRatio = pixelRatio;
    this.#forget();
    this.#resizeOutput(width, height);
    const scale = this.#lineScale();
    const { lines, edges, colour, preview, selection } = this.#targets;
    const [width2, height2] = [Math.floor(this.#size.x * scale), Math.floor(this.#size.y * scale)];
    for (const target of [lines, edges]) target.setSize(width2, height2);
    for (const target of [colour, preview, selection]) target.setSize(this.#size.x, this.#size.y);
    this.#selection.pixel.value.set(pixelRatio / this.#size.x, pixelRatio / this.#size.y);
    this.#page.pixelRatio.value = pixelRatio;
    this.#scaleLines();
  }

  render(camera: ViewCamera, view: View): void {
    // what images were seen through is of another frame
    if (this.#refinement.isBegun) this.#fade.end();
    this.#refinement.end();
    this.#sheet = this.#passes(camera, view);
    this.#cover(this.#sheet, this.#output);
    if (this.#fade.share > 0) this.#blend(this.#fade.over, this.#output);
    this.#finish();
  }

  /**
   * The picture with surfaces from this image, and the mean of it and those before since the last `render`. What `render` drew is seen
   * through it until there are `enough` of them; above and below the rows that are `known` it is all that is seen. False where there is
   * nothing to see through. `alone` it is what is drawn, as by `render`.
   */
  refine(
    camera: ViewCamera,
    view: View,
    image: SurfaceImage,
    { enough = 1, known = ALL, alone = false }: Refining = {},
  ): boolean {
    const isPart = alone || known[0] > 0 || known[1] < 1;
    const refinement = this.#refinement;
    if (alone) refinement.end();
    else if (!refinement.isBegun && !this.keep()) return false;
    refinement.isBegun = !alone;
    this.#image.put(image, this.#seam);
    this.#image.tell(this.parts.leaveOut(image.items));
    this.#image.pivot.value = viewZ(camera, view.pivot);
    this.#proxy ??= new ImageProxy(this.parts, this.#materials);
    const proxy = this.#proxy;
    proxy.fill = this.#materials.fill(this.#look.style, 'image');
    proxy.visible = true;
    const sheet = jittered(camera, this.#renderer, image.camera, () => this.#passes(camera, view));
    proxy.visible = false;
    this.parts.takeIn(image.items);
    if (alone) this.#sheet = sheet;
    if (isPart) this.#cover(sheet, this.#output);
    else {
      refinement.resize(this.#size.x, this.#size.y);
      this.#cover(sheet, refinement.sample);
      this.#blend(refinement.add(), refinement.mean);
      this.#cover(refinement.shown, this.#output);
    }
    this.#fade.known = known;
    // of a frame of its own there is none before
    this.#fade.lost = alone ? null : (image.lost ?? null);
    this.#fade.share = 1 - (isPart ? 1 : refinement.count) / enough;
    if (this.#fade.isSeen) this.#blend(this.#fade.over, this.#output);
    this.#finish();
    return true;
  }

  /** Keeps the picture of the last frame, which then lies over the frames to come; false where there is none. */
  keep(): boolean {
    if (!this.#sheet) return false;
    const { count, shown } = this.#refinement;
    this.#fade.kept.setSize(this.#size.x, this.#size.y);
    this.#cover(count > 0 ? shown : this.#sheet, this.#fade.kept);
    this.#renderer.setRenderTarget(null);
    // it is of the frame before from now on, which the next one is to be seen through
    this.#refinement.end();
    this.#fade.share = 1;
    this.#fade.lost = null;
    this.#fade.known = ALL;
    return true;
  }

  #passes(camera: ViewCamera, view: View): NodeMaterial {
    const { style, grid, wireframe } = this.#look;
    const kernel = this.parts.hasKept ? this.#kernel() : null;
    const fills = style !== 'hbed-lines' || grid || wireframe || this.#guides.lines.visible;
    const { hasPreview, hasSelected } = this.parts;
    const { lines, edges, colour, preview, selection } = this.#targets;
    this.#renderer.info.reset();
    this.parts.update();
    this.#measure(camera, view);
    this.#page.lined.value = kernel ? 1 : 0;
    if (kernel) this.#draw(this.parts.lines, camera, lines, NO_NORMAL, FAR);
    if (kernel) this.#cover(this.#materials.edges(kernel), edges);
    if (fills) this.#draw(this.parts.colour, camera, colour, CLEAR, NOTHING);
    if (hasPreview) this.#draw(this.parts.preview, camera, preview, CLEAR, NOTHING);
    if (hasSelected) this.#draw(this.parts.selection, camera, selection, CLEAR, NOTHING);
    return this.#materials.page(kernel !== null, fills, hasPreview, hasSelected);
  }

  #finish(): void {
    this.#renderer.setRenderTarget(null);
    ({ drawCalls: this.drawCalls, triangles: this.triangles } = this.#renderer.info.render);
  }

  /** How much is seen of the picture that is kept, 0–1; at 0 it goes. */
  set fade(share: number) {
    if (this.#fade.share > 0) this.#fade.share = share;
  }

  dispose(): void {
    this.#fade.dispose();
    this.#refinement.dispose();
    this.#proxy?.dispose();
    this.#image.dispose();
    this.parts.dispose();
    this.#grid.dispose();
    this.#guides.dispose();
    this.#grain.dispose();
    for (const target of Object.values(this.#targets)) target.dispose();
    this.#materials.dispose();
  }

  #fill(style: Look['style']): Fill {
    return (painted) => this.#materials.fill(style, painted ? 'painted' : 'plain');
  }

  get #output(): RenderTarget | null {
    return this.#options.output ?? null;
  }

  #resizeOutput(width: number, height: number): void {
    if (this.#output) {
      this.#size.set(Math.floor(width * this.#pixelRatio), Math.floor(height * this.#pixelRatio));
      this.#output.setSize(this.#size.x, this.#size.y);
    } else {
      this.#renderer.setPixelRatio(this.#pixelRatio);
      this.#renderer.setSize(width, height, false);
      this.#renderer.getDrawingBufferSize(this.#size);
    }
  }

  #draw(scene: ThreeScene, camera: Camera, target: RenderTarget, clear: Color, alpha: number): void {
    this.#renderer.setClearColor(clear, alpha);
    this.#renderer.setRenderTarget(target);
    this.#renderer.render(scene, camera);
  }

  #cover(material: NodeMaterial, target: RenderTarget | null): void {
    this.#renderer.setRenderTarget(target);
    this.#quad.material = material;
    this.#quad.render(this.#renderer);
  }

  #blend(material: NodeMaterial, target: RenderTarget | null): void {
    this.#renderer.autoClear = false;
    this.#cover(material, target);
    this.#renderer.autoClear = true;
  }

  /** The last frame cannot be had again, and what was kept is of another look or size. */
  #forget(): void {
    this.#refinement.end();
    this.#image.rest();
    this.#sheet = null;
    this.#fade.end();
  }

  /** Depth is measured over the scene's sphere, so that a threshold means the same at every zoom. */
  #measure(camera: Camera, view: View): void {
    const { center, radius } = this.parts.sphere;
    const reach = Math.max(radius, 1e-3);
    const distance = -viewZ(camera, center.toArray());
    this.#lines.depthRange.value.set(distance - reach, 2 * reach);
    this.#ink.radius.value = reach;
    if (this.#look.grid) {
      this.#grid.update(view, camera, this.#size.x / this.#size.y, this.#size.y / this.#pixelRatio);
    }
  }

  /** The kernel the look asks for, or null for no lines. */
  #kernel(): Kernel | null {
    const { style, kernel, outline } = this.#look;
    if (style !== 'hbed-lines' && style !== 'hbed-ink' && !outline) return null;
    if (kernel !== 'auto') return kernel;
    return style === 'hbed-lines' ? 'C' : style === 'hbed-ink' ? 'D' : 'contour';
  }

  /** Texels of the line passes along a device pixel: 1, 1.5 or 2. */
  #lineScale(): number {
    const { lineTexels, maxSide } = this.#options;
    const affordable = Math.sqrt(lineTexels / (this.#size.x * this.#size.y));
    const possible = maxSide / Math.max(this.#size.x, this.#size.y);
    const scale = Math.min(2, LINE_DENSITY / this.#pixelRatio, affordable, possible);
    return Math.max(1, Math.floor(2 * scale) / 2);
  }

  #scaleLines(): void {
    const { width, height } = this.#targets.lines;
    this.#lines.texel.value.set(1 / width, 1 / height);
    const scale = this.#lineScale();
    const kernel = this.#kernel();
    if (kernel) this.#lines.setScale(this.#pixelRatio * scale, kernel);
    // At the screen's resolution a pixel is the middle of a texel: ½ a texel gives (1, 2, 1)/4; at twice that it is
    // the corner of four: ¾ gives (1, 3, 3, 1)/8.
    const reach = 0.25 + 0.25 * scale;
    this.#page.tent.value.set(reach / width, reach / height);
  }
}

/** mm along the camera's own z of a point of the model */
const viewZ = ({ matrixWorldInverse }: Camera, point: Vec3): number =>
  new Vector3(...point).applyMatrix4(matrixWorldInverse).z;
