/**
 * `<rotund-sketch>`: the application as one custom element. It draws the controls, routes the pointer and the keys
 * to the session, and fetches the scene (three.js) only when it is on a page: strokes can be drawn before it is there.
 */
import { html, nothing, type PropertyDeclarations, type PropertyValues, type TemplateResult } from 'lit';
import { draftIsWhole, draftSolids } from '../document/build.ts';
import type { Scene } from '../scene/index.ts';
import { isDark, lineColour, PAPER_COLOUR, pencilColour } from '../scene/look.ts';
import { acrossCard, acrossLayout, CARD_WIDTH, hasAcrossCard } from './acrossCard.ts';
import { actionsBar } from './actionsBar.ts';
import { SketchApi } from './api.ts';
import { bendCard } from './bendCard.ts';
import { chip, chipSize, showsBacks } from './chip.ts';
import { chipLayout } from './chipLayout.ts';
import { clipboard } from './clipboard.ts';
import { notice, type PanelName, rail, topBar } from './controls.ts';
import { dropVeil } from './dropVeil.ts';
import { editLayout } from './editLayout.ts';
import { messageOf, renamed } from './events.ts';
import { fileLayout } from './fileLayout.ts';
import { Files } from './files.ts';
import { fileTray } from './fileTray.ts';
import { gallery } from './gallery.ts';
import { gizmo } from './gizmo.ts';
import { Hands } from './hands.ts';
import { hint } from './hint.ts';
import { layout } from './layout.ts';
import { marginsOf } from './margins.ts';
import { meter } from './meter.ts';
import { noPicture, noPictureStyle } from './noPicture.ts';
import { PanelFocus } from './panelFocus.ts';
import { panel } from './panels.ts';
import { partsLayout } from './partsLayout.ts';
import { chipPlace, type Place, screenBox, strokesBox } from './place.ts';
import { PointerRouter } from './pointer.ts';
import { profileLayout } from './profileEditor.ts';
import { redrawCard } from './redrawCard.ts';
import { SceneLife, type SceneOwner } from './sceneLife.ts';
import { Session } from './session.ts';
import { hasSkeleton } from './skeletonEdit.ts';
import { skeletonLayout, skeletonOverlay } from './skeletonOverlay.ts';
import { startLayout } from './startLayout.ts';
import { status } from './statusLine.ts';
import { PAPER_OF, reducedMotion, themeOf, watchPixelRatio, watchSystem } from './theme.ts';
import { tokens } from './tokens.ts';
import { viewBall } from './viewBall.ts';
import { drawInk } from './wetInk.ts';
import { PART_WORDS, WORDS } from './words.ts';

/** As in tokens.ts: darker than on tinted paper. */
const CONTRAST_PENCIL = '#0033a8';

/** Nothing in these changes the drawing where people may only look. */
const LOOKING_PANELS: readonly PanelName[] = ['settings', 'menu', 'help'];

/** px of width below which panels are sheets over the drawing */
const NARROW = 700;

// What is marked internal is for the controls and is left out of the package’s types.
export class RotundSketch extends SketchApi {
  /** @internal */
  static override styles = [
    tokens,
    layout,
    chipLayout,
    startLayout,
    fileLayout,
    noPictureStyle,
    partsLayout,
    editLayout,
    skeletonLayout,
    profileLayout,
    acrossLayout,
  ];
  /** @internal */
  static override properties: PropertyDeclarations = {
    autosave: { reflect: true },
    gallery: { reflect: true },
    open: { state: true },
    fingersDraw: { state: true },
  };

  /** key under which the browser keeps the drawing */
  declare autosave: string | null;
  /** address of a list of samples for the empty page */
  declare gallery: string | null;
  /** @internal */
  declare open: PanelName | null;
  /** @internal */
  declare fingersDraw: boolean;

  /** @internal */
  readonly session = new Session({
    ...this.hooks,
    changed: () => this.requestUpdate(),
    drawn: () => this.#drawn(),
  });
  /** @internal */
  readonly files = new Files(this);
  readonly #hands = new Hands(this);
  readonly #panelFocus = new PanelFocus();
  readonly #life = new SceneLife(this.#sceneOwner());
  #router: PointerRouter | null = null;
  #sizes: ResizeObserver | null = null;
  #seen: IntersectionObserver | null = null;
  #media: AbortController | null = null;
  /** what of the controls has the focus */
  #focused: HTMLElement | null = null;
  /** the name the page last heard */
  #told = '';
  #viewKey = '';

  constructor() {
    super();
    this.autosave = null;
    this.gallery = null;
    this.open = null;
    this.fingersDraw = true;
    // There is nothing to draw on yet.
    this.session.frames.asleep = true;
  }

  // ── life ────────────────────────────────────────────────────────────────────────────────────────────

  /** @internal */
  override connectedCallback(): void {
    super.connectedCallback();
    this.#media = new AbortController();
    const { signal } = this.#media;
    watchSystem(() => this.#adapt(), signal);
    watchPixelRatio(() => this.#resize(), signal);
    this.addEventListener('keydown', (event) => this.#hands.key(event), { signal });
    for (const type of ['copy', 'cut', 'paste'] as const)
      this.addEventListener(type, (event) => this.readOnly || clipboard(event, this.session), { signal });
    for (const type of ['focusin', 'focusout'] as const)
      this.renderRoot.addEventListener(type, () => this.#noteFocus(), { signal });
    if (this.hasUpdated) this.#start();
  }

  /** @internal */
  protected override firstUpdated(): void {
    // After this update: what starts asks for another.
    void this.updateComplete.then(() => this.isConnected && !this.#router && this.#start());
  }

  /** @internal */
  protected override began(): void {
    const { document: opened, name } = this.session;
    this.files.origins.mark(opened, name, 'page');
  }

  /** @internal */
  protected override restored(): Promise<boolean> {
    return this.files.keeping?.restored ?? super.restored();
  }

  /** @internal */
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#life.close();
    this.session.cancel();
    this.#hands.rest();
    this.#media?.abort();
    this.#router?.dispose();
    this.#router = null;
    this.#sizes?.disconnect();
    this.#seen?.disconnect();
    this.session.frames.asleep = true;
    this.session.bodies.stop();
    this.session.detach();
  }

  /**
   * Moved within the page by `moveBefore`: nothing has to end.
   * @internal
   */
  connectedMoveCallback(): void {}

  #start(): void {
    const stage = this.#find<HTMLElement>('.stage');
    this.#router = new PointerRouter(stage, this.#hands.target());
    this.#sizes = new ResizeObserver(() => this.#resize());
    this.#sizes.observe(stage);
    this.#seen = new IntersectionObserver((seen) => this.#see(seen.at(-1)?.isIntersecting ?? true));
    this.#seen.observe(this);
    this.#adapt();
    this.#resize();
    this.session.frames.asleep = false;
    this.session.bodyWork.want();
    this.scene.go();
    void this.#life.open();
  }

  #sceneOwner(): SceneOwner {
    const sketch = this;
    return {
      canvas: () => this.#find<HTMLCanvasElement>('.picture'),
      freshCanvas: () => {
        const old = this.#find<HTMLCanvasElement>('.picture');
        old.replaceWith(old.cloneNode());
      },
      get backend() {
        return sketch.backend;
      },
      get fine() {
        return sketch.quality === 'fine';
      },
      show: (scene) => this.#show(scene),
      lose: () => this.#lose(),
      withoutScene: (error) => this.#withoutScene(error),
    };
  }

  #show(scene: Scene): void {
    const { session } = this;
    session.attach(scene);
    this.dataset.backend = scene.backend;
    if (scene.backend === 'WebGL2') session.said = WORDS.webgl2;
    session.noPicture = null;
    if (session.notice?.text === WORDS.lost) session.notice = null;
    this.#adapt();
    this.#resize();
    this.scene.come(scene);
    this.declared.sceneCame();
  }

  /** Off the screen, or not displayed: no frames. */
  #see(seen: boolean): void {
    this.session.frames.asleep = !seen;
    if (!seen) this.declared.sayReady();
  }

  #lose(): void {
    const { session } = this;
    this.scene.go();
    session.notice = { text: WORDS.lost, actions: [] };
    session.detach();
    session.update();
  }

  #withoutScene(error: unknown): void {
    this.dataset.backend = 'none';
    this.scene.fail(error);
    const told = !this.fail(error);
    this.session.said = WORDS.noPicture;
    this.session.noPicture = { reason: messageOf(error), told, retry: () => this.#lookAgain() };
    if (this.session.notice?.text === WORDS.lost) this.session.notice = null;
    this.requestUpdate();
  }

  #lookAgain(): void {
    this.session.noPicture = null;
    this.scene.go();
    this.requestUpdate();
    void this.#life.open();
  }

  #find<T extends Element>(selector: string): T {
    const found = this.renderRoot.querySelector<T>(selector);
    if (!found) throw new Error(`rotund-sketch: its own ${selector} is missing`);
    return found;
  }

  #adapt(): void {
    const theme = themeOf(this.theme);
    this.dataset.theme = theme;
    const { session } = this;
    if (session.scene) session.scene.rig.reducedMotion = reducedMotion();
    if (!session.looks.choseBackground) session.looks.look = { ...session.look, ...PAPER_OF[theme] };
    session.scene?.setLook(session.look);
    session.update();
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this;
    if (width === 0 || height === 0 || !this.hasUpdated) return;
    const ink = this.#find<HTMLCanvasElement>('.ink');
    ink.width = Math.round(width * devicePixelRatio);
    ink.height = Math.round(height * devicePixelRatio);
    this.session.size = { width, height };
    this.session.margins = () => marginsOf(this.session.size, this.#bare, this.readOnly);
    this.session.scene?.resize(width, height, devicePixelRatio);
    this.session.update();
  }

  // ── drawing ─────────────────────────────────────────────────────────────────────────────────────────

  /** @internal */
  protected override render() {
    const { session } = this;
    const empty =
      !this.files.restoring &&
      session.document.parts.length === 0 &&
      !session.document.draft &&
      !session.state.wet;
    const around = {
      before: html`${hasSkeleton(session) ? skeletonOverlay(session) : gizmo(session, this)} ${empty && (session.noPicture?.told ?? true) ? html`<div class="start ${this.files.samples.list.length > 0 ? 'filled' : ''}">${hint()}${gallery(this)}</div>` : nothing} ${fileTray(session, this)}`,
      after: html`${rail(session, this)} ${meter(session)}
        ${actionsBar(session, this)} ${bendCard(session)} ${redrawCard(session)} ${acrossCard(session, this)} ${chip(session, this)}`,
    };
    return html`<div class="app ${isDark(session.look.background) ? 'on-dark' : ''}">
      <div class="stage ${this.#cursor}" part="stage" role=${this.readOnly ? 'img' : 'application'}
        tabindex="0" aria-label=${this.#label()} aria-describedby=${this.#bare ? nothing : 'keys'}>
        <canvas class="picture" part="picture"></canvas>
        <canvas class="ink"></canvas>
      </div>
      ${this.#insteadOfPicture()}
      ${this.#bare ? nothing : this.#controls(around)}
    </div>`;
  }

  /** What the cursor says. */
  get #cursor(): string {
    if (this.readOnly) return 'looking';
    return this.session.tool === 'select' ? 'selecting' : '';
  }

  /** The picture alone. */
  get #bare(): boolean {
    return this.controls === 'none';
  }

  #controls({ before, after }: Readonly<Record<'before' | 'after', TemplateResult>>): TemplateResult {
    const { session, readOnly } = this;
    const shown = !readOnly || (this.open !== null && LOOKING_PANELS.includes(this.open));
    return html`<span id="keys" class="hidden">Press ? for keys and gestures.</span>
      ${readOnly ? nothing : before} ${topBar(session, this)} ${readOnly ? nothing : after} ${status(session)}
      ${viewBall(session.view, this.#hands.ball())} ${notice(session)}
      ${this.#hasFallback ? nothing : noPicture(session, this, readOnly)} ${shown ? panel(session, this) : nothing} ${this.files.over ? dropVeil() : nothing}`;
  }

  /** What the page gave to be seen until there is a picture, or when there is none. */
  #insteadOfPicture(): TemplateResult | typeof nothing {
    if (this.session.noPicture) return html`<div class="instead"><slot name="fallback"></slot></div>`;
    return this.pictured ? nothing : html`<div class="instead"><slot name="poster"></slot></div>`;
  }

  /** The page has its own words for having no picture. */
  get #hasFallback(): boolean {
    return [...this.children].some(({ slot }) => slot === 'fallback');
  }

  #label(): string {
    const { parts, draft } = this.document;
    const count = `${parts.length} ${parts.length === 1 ? 'part' : 'parts'}`;
    const unfinished = draft ? `, unfinished form of ${PART_WORDS.strokes(draft.strokes.length)}` : '';
    return this.alt ?? `Drawing. ${count}${unfinished}`;
  }

  /** @internal */
  protected override updated(changed: PropertyValues): void {
    super.updated(changed);
    this.#tellName();
    if (changed.has('theme')) this.#adapt();
    if (changed.has('open')) this.#panelFocus.moved(this.renderRoot as ShadowRoot, this.#find('.stage'));
    this.#keepFocus();
  }

  /** What had the focus is gone: the keys still answer. */
  #keepFocus(): void {
    if (!this.#focused || (this.#focused.isConnected && this.#focused.checkVisibility())) return;
    this.#focused = null;
    if (document.activeElement === document.body)
      this.#find<HTMLElement>('.stage').focus({ preventScroll: true });
  }

  #noteFocus(): void {
    const { activeElement } = this.renderRoot as ShadowRoot;
    const before = this.#focused;
    if (activeElement instanceof HTMLElement) this.#focused = activeElement;
    // What loses the focus because it goes is remembered until the update is over.
    else
      queueMicrotask(() => {
        if (this.#focused === before && before?.isConnected) this.#focused = null;
      });
  }

  #tellName(): void {
    const { name } = this.session;
    if (name === this.#told) return;
    this.#told = name;
    this.dispatchEvent(renamed(name));
  }

  /** After each frame: the ink over it, and what hangs on the camera. */
  #drawn(): void {
    this.drawInk();
    const { view, state, frames } = this.session;
    this.declared.sayReady();
    const key = JSON.stringify([view, state.carried, state.skeleton?.nodes, frames.triangles]);
    if (key === this.#viewKey) return;
    this.#viewKey = key;
    this.session.hand.hoverAgain();
    this.requestUpdate();
  }

  /** @internal */
  drawInk(): void {
    const { background } = this.session.look;
    drawInk(
      this.#find<HTMLCanvasElement>('.ink'),
      this.session,
      {
        ink: lineColour(background),
        pencil:
          this.dataset.theme === 'contrast' && !isDark(background)
            ? CONTRAST_PENCIL
            : pencilColour(background),
        paper: PAPER_COLOUR[background],
        font: getComputedStyle(this).fontFamily,
      },
      this.#hands.predicted,
    );
  }

  /** @internal */
  get chipAt(): Place | null {
    const { document, view, size } = this.session;
    if (!document.draft) return null;
    const meshes = draftIsWhole(document) ? draftSolids(document).map(({ mesh }) => mesh) : [];
    // a solid is not there at once
    const box = screenBox(meshes, view, size) ?? strokesBox(document.draft.strokes, view, size);
    const middle = { left: size.width / 2, right: size.width / 2, top: 80, bottom: 80 };
    const { width, height } = size;
    // a panel lies beside the drawing; on narrow pages it is a sheet over all of it
    const isBeside = hasAcrossCard(this.session, this.open) || (this.open !== null && width >= NARROW);
    const free = isBeside ? { width: width - CARD_WIDTH, height } : size;
    return chipPlace(box ?? middle, free, chipSize(document, size, showsBacks(this.session, this.open)));
  }

  // ── what the controls ask for ───────────────────────────────────────────────────────────────────────

  /** @internal */
  toggle(name: PanelName): void {
    this.open = this.open === name ? null : name;
  }

  /** @internal */
  dismiss(): void {
    // A panel gives the focus back to what opened it.
    if (!this.open) this.#find<HTMLElement>('.stage').focus({ preventScroll: true });
    this.open = null;
  }

  /** @internal */
  setFingersDraw(on: boolean): void {
    this.fingersDraw = on;
    this.session.said = on ? 'Fingers draw' : 'Fingers turn the view';
  }

  /**
   * A drag of the slider is shown at once and becomes one undo step when it ends.
   * @internal
   */
  setRadius(mm: number, done: boolean): void {
    this.session.setRadius(mm, done);
  }
}
