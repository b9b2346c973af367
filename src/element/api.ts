/**
 * What a page can say to the element and hear from it: attributes, properties, methods, events. It knows the session
 * and the scene, but neither controls nor pointers; those are of `rotundSketch.ts`, which goes on from here.
 */
import { LitElement, type PropertyDeclarations, type PropertyValues } from 'lit';
import type { Command } from '../document/command/index.ts';
import { type Document, type Draft, isImplicit } from '../document/document.ts';
import type { Drawing } from '../document/drawing.ts';
import { redoable, undoable } from '../document/history.ts';
import type { Mode, Style } from '../document/look.ts';
import { checkDrawing, FileError, parse, serialize, serializeScript } from '../document/serialize.ts';
import { nodeOf } from '../document/solidNode.ts';
import type { Format, OutFile } from '../export/index.ts';
import type { Comparison } from '../field/zhuImage.ts';
import type { PictureOptions, Scene } from '../scene/index.ts';
import type { Stroke } from '../stroke/stroke.ts';
import { Arrival } from './arrival.ts';
import { checkedCommands, checkedIds } from './check.ts';
import { Declared, type DeclaredHost } from './declared.ts';
import { changed, failed, modeChanged, type RotundSketchEventMap, selected } from './events.ts';
import { Exact, shownBodies } from './exact.ts';
import type { Flaw } from './flaws.ts';
import type { Waiting } from './needs.ts';
import type { Picked } from './picked.ts';
import type { Hooks, Session } from './session.ts';
import { pictureOptions, pngOf, type Shot } from './shot.ts';
import { named } from './source.ts';
import { type StrokeInput, strokeOf } from './strokeInput.ts';
import type { Theme } from './theme.ts';
import { WORDS } from './words.ts';
import { ZhuCaster } from './zhuCaster.ts';

/** The rays of Zhu et al. 2011 beside ours. */
export interface RayComparison extends Comparison {
  /** what theirs show, a PNG */
  readonly picture: Blob;
}

/** What a stroke that begins a form is to become. */
export type StrokeIntent = Pick<Draft, 'form' | 'joins' | 'carves'>;

export interface LoadOptions {
  /** what messages call it, and the drawing’s name where it has none of its own */
  readonly name?: string;
  /** all of it is shown; false: as it was looked at when it was saved */
  readonly fit?: boolean;
}

/**
 * The manifest and the tables of docs/element.md are made from these words.
 *
 * @fires {Event} ready - The first picture is there, with what the page declared. Once a scene: again after the element was put elsewhere, and after a lost device.
 * @fires {CustomEvent<ChangeDetail>} change - The document is another one. `detail`: `commands`, `cause` (`command`, `undo` or `redo`; the last two carry no commands) and `document`.
 * @fires {CustomEvent<RenameDetail>} rename - The drawing is called otherwise. `detail.name`: how; empty while it has no name.
 * @fires {CustomEvent<SelectDetail>} select - Other parts are selected. `detail.ids`: which.
 * @fires {CustomEvent<ModeDetail>} mode - Bodies are shown otherwise. `detail.mode`: `mesh` or `exact`.
 * @fires {CustomEvent<ErrorDetail>} error - What the page declared cannot be done, or there is no picture. `detail`: `error` and `message`. `preventDefault()` says that the page tells the person itself.
 *
 * @slot poster - Seen until the first picture is there.
 * @slot fallback - Seen where neither WebGPU nor WebGL2 works.
 * @slot toolbar - Buttons of the page, before undo and redo.
 *
 * @csspart stage - The picture with the ink over it; it has the focus ring.
 * @csspart picture - The canvas of the picture.
 * @csspart toolbar - The row at the top.
 * @csspart tray - A group of buttons in that row.
 * @csspart tools - The tools at the left, at the bottom of a narrow element.
 * @csspart meter - What the number of strokes decides.
 * @csspart chip - Keep or drop, at the unfinished form.
 * @csspart status - What was done last, and which back end draws.
 * @csspart view-ball - The ball that turns the view.
 * @csspart actions - What can be done with the selected parts.
 * @csspart notice - A message over the picture.
 * @csspart panel - A panel that opens: settings, colours, menu.
 *
 * @cssprop --surface - Background of the controls.
 * @cssprop --sunken - Background of quiet buttons, and under the pointer.
 * @cssprop --hairline - Lines between and around controls.
 * @cssprop --edge - Outline of what is chosen.
 * @cssprop --ink - Text and icons.
 * @cssprop --ink-2 - Text beside it.
 * @cssprop --pencil - The accent: focus, selection, the main button.
 * @cssprop --pencil-soft - Background of what is open or current.
 * @cssprop --on-pencil - Text on the accent.
 * @cssprop --active - Background of the tool in hand.
 * @cssprop --on-active - Its icon.
 * @cssprop --paper - Background until there is a picture; the paper of the picture is part of the drawing.
 * @cssprop --font - The typeface.
 */
export abstract class SketchApi extends LitElement {
  /** @internal */
  static override properties: PropertyDeclarations = {
    src: { reflect: true },
    alt: { reflect: true },
    renderStyle: { attribute: 'render-style', reflect: true },
    mode: { reflect: true },
    volumes: { type: Boolean, reflect: true },
    readOnly: { type: Boolean, attribute: 'readonly', reflect: true },
    controls: { reflect: true, useDefault: true },
    theme: { reflect: true },
    backend: { reflect: true, useDefault: true },
    quality: { reflect: true, useDefault: true },
    // What was set before the class was there is taken over at the first update.
    drawing: { attribute: false, noAccessor: true },
    pictured: { state: true },
  };

  /**
   * Address of a drawing or script. A drawing that is open stays when the new one cannot be read. The first one is what
   * a blank page begins with, unless `autosave` has kept a drawing; a later one is a step that undo takes back.
   */
  declare src: string | null;
  /** what the picture shows, for those who hear the page */
  declare alt: string | null;
  /**
   * `toon`, `gouraud`, `phong`, `hbed-lines` or `hbed-ink`; wins over the style stored in a drawing, and follows what a
   * person chooses.
   */
  declare renderStyle: Style | null;
  /**
   * `mesh` shows bodies by triangles, `exact` their surface itself where all rests; wins over the mode stored in a drawing, and follows what
   * a person chooses.
   */
  declare mode: Mode | null;
  /** Around the skels of bodies, where Zhu et al. 2011 look for their surface, as lines over the picture; follows what a person chooses, and is not saved. */
  declare volumes: boolean;
  /** Looking only: one finger, the left button or the pen turns the view, a tap selects; methods still change the drawing. */
  declare readOnly: boolean;
  /** `none` shows the picture alone */
  declare controls: 'all' | 'none';
  /** `light`, `dark` or `contrast`; without it the system’s setting */
  declare theme: Theme | null;
  /** `webgl2` never asks for WebGPU */
  declare backend: 'auto' | 'webgl2';
  /** `fine` finds lines at twice the resolution on software adapters too: for pictures, where time is no matter */
  declare quality: 'auto' | 'fine';

  /**
   * a picture was there: no poster is needed any more
   * @internal
   */
  declare protected pictured: boolean;

  /** @internal */
  abstract readonly session: Session;
  /**
   * the scene there is; asked for while there is none, the one that comes
   * @internal
   */
  protected readonly scene = new Arrival<Scene>();
  /** @internal */
  protected readonly declared = new Declared(this.#declaredHost());
  /** ends with the loads before: the last one that is asked for is the one that stays */
  #turn: Promise<unknown> = Promise.resolve();

  constructor() {
    super();
    this.src = null;
    this.alt = null;
    this.renderStyle = null;
    this.mode = null;
    this.volumes = false;
    this.readOnly = false;
    this.controls = 'all';
    this.theme = null;
    this.backend = 'auto';
    this.quality = 'auto';
    this.pictured = false;
  }

  // ── what is drawn ───────────────────────────────────────────────────────────────────────────────────

  /** The document: plain immutable data. */
  get document(): Document {
    return this.session.document;
  }

  /** The document with its name, view and look, as a file holds it. Setting it opens another one. */
  get drawing(): Drawing {
    return this.session.drawing;
  }

  set drawing(value: Drawing) {
    try {
      const drawing = checkDrawing(value);
      this.declared.forget();
      this.declared.begin(drawing);
    } catch (error) {
      this.fail(error);
    }
  }

  /** Ids of the selected parts, and of components and groups that are selected within solids. */
  get selection(): readonly string[] {
    return this.session.selection;
  }

  /** There is a step to take back. */
  get canUndo(): boolean {
    return undoable(this.session.history) !== null;
  }

  /** There is a step to do again. */
  get canRedo(): boolean {
    return redoable(this.session.history) !== null;
  }

  /**
   * Opens the text of a `.rotund` file or of a script, a file that holds it, or a drawing, as one undo step. Rejects with
   * a FileError that names the place; the open drawing stays then.
   */
  async load(source: string | Blob | Drawing, { name, fit = true }: LoadOptions = {}): Promise<void> {
    const reading = read(source, name);
    const turn = Promise.allSettled([this.#turn, reading]).then(async () => {
      const drawing = await reading;
      this.declared.forget();
      this.session.open(this.declared.styled(drawing), { fit });
    });
    this.#turn = turn.catch(() => {});
    await turn;
  }

  /** The text of a `.rotund` file. */
  save(): string {
    return serialize(this.session.drawing);
  }

  /** The text of a script: the commands that lead from an empty page to this drawing. */
  script(): string {
    return serializeScript(this.session.script, this.session.drawing);
  }

  /**
   * The kept, visible parts as files for other programs: `obj`, `glb`, `stl` or `ply`. The first file is the one asked
   * for, others lie beside it; waits for bodies that are being made, which `waiting` may give up, and hears of.
   */
  async export(format: Format, waiting: Waiting = {}): Promise<readonly OutFile[]> {
    const { exporters, modelOf } = await import('../export/index.ts');
    if (!Object.hasOwn(exporters, format)) {
      const known = Object.keys(exporters).join(', ');
      throw new FileError('export', '', `expected one of ${known}, found ${JSON.stringify(format)}`);
    }
    const { document, session } = this;
    const seen = document.parts.filter(({ hidden }) => !hidden);
    await session.bodies.exactly(seen.filter(isImplicit).map(nodeOf), waiting);
    return exporters[format].write(modelOf(document, session.name));
  }

  // ── what is done ────────────────────────────────────────────────────────────────────────────────────

  /** Takes the last step back; a stroke under the pen first. */
  undo(): void {
    this.session.undo();
  }

  /** Does again what undo took back. */
  redo(): void {
    this.session.redo();
  }

  /** Carries out commands, each as one undo step; throws a FileError, and does nothing, when one of them is none. */
  run(commands: Command | readonly Command[]): void {
    const checked = checkedCommands(commands, this.document);
    this.session.cancel();
    this.session.commit(checked);
  }

  /**
   * One more stroke of the unfinished form: whole, or as points in mm on the plane that faces the front. `intent` says what a form that it
   * begins becomes: `form`, the solid and component it `joins`, whether it `carves`.
   */
  addStroke(stroke: Stroke | StrokeInput, intent: StrokeIntent = {}): void {
    this.run({ ...intent, type: 'addStroke', stroke: strokeOf(stroke, this.document) as Stroke });
  }

  /** Selects these parts, or components and groups of solids, and no others; ids that nothing has are left out. */
  select(ids: readonly string[]): void {
    this.session.select(checkedIds(ids));
  }

  /** What meshes of the bodies that are shown lack, as far as they are made: `part`, `name`, `what` (`none`, `thin`, `gaps`, `cut`) and `words` that say what helps. */
  get flaws(): readonly Flaw[] {
    return this.session.bodyWork.flaws;
  }

  /** A PNG of exactly this size, of the kept parts, nothing selected; waits for `src`, for bodies and for the scene. */
  picture(shot: Shot = {}): Promise<Blob> {
    return this.#pictured(shot, this.session.exact);
  }

  /**
   * The exact picture by the rays of Zhu et al. 2011 in place of ours; `zhu` and `bricks`, ours: `evaluationsPerPixel`, and how many hits of
   * `hits` each `missed`. Rejects where there is no body, and where one is no sum of skels without cross sections.
   */
  async compareRays(shot: Omit<Shot, 'mode'> = {}): Promise<RayComparison> {
    const caster = new ZhuCaster();
    const picture = await this.#pictured({ ...shot, mode: 'exact' }, new Exact(() => {}, caster));
    if (!caster.comparison) throw new Error(WORDS.noBodies);
    return { picture, ...caster.comparison };
  }

  async #pictured(shot: Shot, exact: Exact): Promise<Blob> {
    // An element that never was on a page never completes an update either.
    if (this.isConnected) await this.updateComplete;
    await this.declared.settled();
    await this.session.bodies.settled();
    if (!this.isConnected)
      throw new Error('rotund-sketch: there is a picture only of an element that is on a page.');
    const scene = await this.scene.get();
    const { document, view, look, frames } = this.session;
    const width = Math.round(this.clientWidth * devicePixelRatio);
    const height = Math.round(this.clientHeight * devicePixelRatio);
    const options = pictureOptions(shot, { document, view, look, width, height, fit: frames.fit });
    const isExact = options.look.mode === 'exact';
    const bodies = isExact ? shownBodies(document) : [];
    const draw = (images: NonNullable<PictureOptions['images']>) => scene.picture({ ...options, images });
    return pngOf(await exact.picture(bodies, options.view, options, draw));
  }

  /**
   * What is nearest under a place of the element, in CSS pixels from its upper left corner: `id` of the part, `point` in mm and outward
   * `normal` of its surface, of a body `skel` as well: its `path` in the tree and its `share` of the field there. Null where nothing is.
   */
  pick(x: number, y: number): Picked | null {
    return this.session.pick(x, y);
  }

  // ── events ──────────────────────────────────────────────────────────────────────────────────────────

  override addEventListener<K extends keyof RotundSketchEventMap>(
    type: K,
    listener: (this: this, event: RotundSketchEventMap[K]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void {
    super.addEventListener(type, listener, options);
  }

  override removeEventListener<K extends keyof RotundSketchEventMap>(
    type: K,
    listener: (this: this, event: RotundSketchEventMap[K]) => unknown,
    options?: boolean | EventListenerOptions,
  ): void;
  override removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
  override removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void {
    super.removeEventListener(type, listener, options);
  }

  // ── for the element itself ──────────────────────────────────────────────────────────────────────────

  /** @internal */
  protected readonly hooks: Pick<Hooks, 'committed' | 'selected' | 'moded'> = {
    committed: (commands, cause) =>
      void this.dispatchEvent(changed({ commands, cause, document: this.document })),
    selected: (ids) => void this.dispatchEvent(selected(ids)),
    moded: (mode) => void this.dispatchEvent(modeChanged(mode)),
  };

  /**
   * Resolves with true when a drawing that the browser kept is open.
   * @internal
   */
  protected restored(): Promise<boolean> {
    return Promise.resolve(false);
  }

  /**
   * What the page gave is open.
   * @internal
   */
  protected began(): void {}

  /**
   * Says what went wrong; true when the page leaves telling the person to the element.
   * @internal
   */
  protected fail(error: unknown): boolean {
    return this.dispatchEvent(failed(error));
  }

  #declaredHost(): DeclaredHost {
    const sketch = this;
    return {
      get session() {
        return sketch.session;
      },
      get isConnected() {
        return sketch.isConnected;
      },
      get src() {
        return sketch.src;
      },
      get renderStyle() {
        return sketch.renderStyle;
      },
      set renderStyle(style) {
        sketch.renderStyle = style;
      },
      get mode() {
        return sketch.mode;
      },
      set mode(mode) {
        sketch.mode = mode;
      },
      restored: () => this.restored(),
      began: () => this.began(),
      fail: (error) => this.fail(error),
      ready: () => {
        this.pictured = true;
        this.dispatchEvent(new Event('ready'));
      },
    };
  }

  /** @internal */
  override connectedCallback(): void {
    super.connectedCallback();
    this.declared.resume();
  }

  /** @internal */
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.declared.pause();
    this.scene.fail(new Error('rotund-sketch: it left the page.'));
  }

  /** @internal */
  protected override willUpdate(changes: PropertyValues): void {
    if (changes.has('renderStyle')) this.declared.takeStyle();
    if (changes.has('mode')) this.declared.takeMode();
    if (changes.has('volumes')) this.session.looks.setVolumes(this.volumes);
    this.volumes = this.session.volumes;
    if (changes.has('readOnly') && this.readOnly) this.session.cancel();
    this.session.bodies.expectsEdits = !this.readOnly;
    this.declared.followLook();
  }

  /** @internal */
  protected override updated(changes: PropertyValues): void {
    if (changes.has('src')) this.declared.fetch();
  }
}

async function read(source: unknown, name?: string): Promise<Drawing> {
  if (typeof source !== 'string' && !(source instanceof Blob)) return checkDrawing(source);
  const file = source instanceof File ? source.name : name;
  const drawing = parse(typeof source === 'string' ? source : await source.text(), file ?? 'drawing');
  return file ? named(drawing, file) : drawing;
}
