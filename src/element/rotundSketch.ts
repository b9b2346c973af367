/**
 * `<rotund-sketch>`: the application as one custom element. It draws the controls, routes the pointer and the keys
 * to the session, and fetches the scene (three.js) only when it is on a page: strokes can be drawn before it is there.
 */
import { html, LitElement, nothing, type PropertyValues } from 'lit';
import { draftSolids } from '../document/build.ts';
import type { Document } from '../document/document.ts';
import type { Scene } from '../scene/index.ts';
import { isDark, lineColour, PAPER_COLOUR } from '../scene/look.ts';
import type { Pen } from '../tool/tool.ts';
import { actionsBar } from './actionsBar.ts';
import {
  type Actions,
  chip,
  meter,
  notice,
  type PanelName,
  rail,
  roundRadius,
  status,
  topBar,
} from './controls.ts';
import { fileTray } from './fileTray.ts';
import { gallery } from './gallery.ts';
import { gizmo } from './gizmo.ts';
import { hint } from './hint.ts';
import { press } from './keys.ts';
import { layout } from './layout.ts';
import { panel } from './panels.ts';
import { chipPlace, type Place, screenBox } from './place.ts';
import { PointerRouter, type PointerTarget } from './pointer.ts';
import { SceneLife, type SceneOwner } from './sceneLife.ts';
import { Session } from './session.ts';
import { stepBack } from './stepBack.ts';
import { PAPER_OF, reducedMotion, systemTheme, type Theme, watchPixelRatio, watchSystem } from './theme.ts';
import { tokens } from './tokens.ts';
import { type BallActions, viewBall } from './viewBall.ts';
import { drawInk } from './wetInk.ts';
import { WORDS } from './words.ts';

/** What the program draws on the paper is blue pencil, whatever the theme of the controls. */
const PENCIL = { onLight: '#2b59c3', onDark: '#93b4ff' } as const;

/** twice the resolution of a picture of 2400 × 1800 */
const FINE_TEXELS = 18e6;

export class RotundSketch extends LitElement implements Actions {
  static override styles = [tokens, layout];
  static override properties = {
    theme: { type: String, reflect: true },
    backend: { type: String },
    quality: { type: String },
    open: { state: true },
    fingersDraw: { state: true },
  };

  /** light, dark or contrast; without it the system's setting */
  declare theme: Theme | null;
  /** `webgl2` never asks for WebGPU */
  declare backend: 'auto' | 'webgl2';
  /** `fine` finds lines at twice the resolution on software adapters too: for pictures, where time is no matter */
  declare quality: 'auto' | 'fine';
  declare open: PanelName | null;
  declare fingersDraw: boolean;

  readonly session = new Session({
    changed: () => this.requestUpdate(),
    drawn: () => this.#drawn(),
    committed: () => {},
    selected: () => {},
  });
  readonly #life = new SceneLife(this.#sceneOwner());
  #router: PointerRouter | null = null;
  #sizes: ResizeObserver | null = null;
  #predicted: readonly Pen[] = [];
  #penSeen = false;
  #media: AbortController | null = null;
  #viewKey = '';

  constructor() {
    super();
    this.theme = null;
    this.backend = 'auto';
    this.quality = 'auto';
    this.open = null;
    this.fingersDraw = true;
  }

  /** The drawing: plain immutable data. */
  get document(): Document {
    return this.session.document;
  }

  // ── life ────────────────────────────────────────────────────────────────────────────────────────────

  override connectedCallback(): void {
    super.connectedCallback();
    this.#media = new AbortController();
    const { signal } = this.#media;
    watchSystem(() => this.#adapt(), signal);
    watchPixelRatio(() => this.#resize(), signal);
    this.addEventListener('keydown', (event) => this.#key(event), { signal });
    if (this.hasUpdated) this.#start();
  }

  protected override firstUpdated(): void {
    // After this update: what starts asks for another.
    void this.updateComplete.then(() => this.isConnected && !this.#router && this.#start());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#life.close();
    this.session.cancel();
    this.#predicted = [];
    this.#media?.abort();
    this.#router?.dispose();
    this.#router = null;
    this.#sizes?.disconnect();
    this.session.detach();
  }

  #start(): void {
    const stage = this.#find<HTMLElement>('.stage');
    this.#router = new PointerRouter(stage, this.#pointerTarget());
    this.#sizes = new ResizeObserver(() => this.#resize());
    this.#sizes.observe(stage);
    this.#adapt();
    this.#resize();
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
      get lineTexels() {
        return sketch.quality === 'fine' ? FINE_TEXELS : undefined;
      },
      show: (scene) => this.#show(scene),
      lose: () => this.#lose(),
      withoutScene: () => this.#withoutScene(),
    };
  }

  #show(scene: Scene): void {
    const { session } = this;
    session.attach(scene);
    this.dataset.backend = scene.backend;
    if (scene.backend === 'WebGL2') session.said = WORDS.webgl2;
    if (session.notice?.text === WORDS.lost) session.notice = null;
    this.#adapt();
    this.#resize();
    this.dispatchEvent(new Event('ready'));
  }

  #lose(): void {
    const { session } = this;
    session.notice = { text: WORDS.lost, actions: [] };
    session.detach();
    session.update();
  }

  #withoutScene(): void {
    this.session.notice = { text: WORDS.noPicture, actions: [] };
    this.dataset.backend = 'none';
    this.requestUpdate();
  }

  #find<T extends Element>(selector: string): T {
    const found = this.renderRoot.querySelector<T>(selector);
    if (!found) throw new Error(`rotund-sketch: its own ${selector} is missing`);
    return found;
  }

  #adapt(): void {
    const theme = this.theme ?? systemTheme();
    this.dataset.theme = theme;
    const { session } = this;
    if (session.scene) session.scene.rig.reducedMotion = reducedMotion();
    if (!session.choseBackground) session.look = { ...session.look, ...PAPER_OF[theme] };
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
    this.session.scene?.resize(width, height, devicePixelRatio);
    this.session.update();
  }

  // ── drawing ─────────────────────────────────────────────────────────────────────────────────────────

  protected override render() {
    const { session } = this;
    const empty = session.document.parts.length === 0 && !session.document.draft && !session.state.wet;
    return html`<div class="app">
      <div class="stage" role="application" tabindex="0" aria-label=${this.#label()} aria-describedby="keys">
        <canvas class="picture"></canvas>
        <canvas class="ink"></canvas>
      </div>
      <span id="keys" class="hidden">Press ? for keys and gestures.</span>
      ${gizmo(session, this)} ${empty ? html`${hint()}${gallery(session, this)}` : nothing}
      ${topBar(session, this)} ${fileTray(session, this)} ${rail(session, this)} ${meter(session)}
      ${actionsBar(session, this)} ${chip(session, this)} ${status(session)}
      ${viewBall(session.view, this.#ballActions())} ${notice(session)} ${panel(session, this)}
    </div>`;
  }

  #label(): string {
    const { parts, draft } = this.document;
    const count = `${parts.length} ${parts.length === 1 ? 'part' : 'parts'}`;
    const unfinished = draft ? `, unfinished form of ${draft.strokes.length} strokes` : '';
    return `Drawing. ${count}${unfinished}`;
  }

  protected override updated(changed: PropertyValues): void {
    if (changed.has('theme')) this.#adapt();
  }

  /** After each frame: the ink over it, and what hangs on the camera. */
  #drawn(): void {
    this.#drawInk();
    const { view } = this.session;
    const key = JSON.stringify(view);
    if (key === this.#viewKey) return;
    this.#viewKey = key;
    this.requestUpdate();
  }

  #drawInk(): void {
    const { background } = this.session.look;
    drawInk(
      this.#find<HTMLCanvasElement>('.ink'),
      this.session,
      {
        ink: lineColour(background),
        pencil: isDark(background) ? PENCIL.onDark : PENCIL.onLight,
        paper: PAPER_COLOUR[background],
        font: getComputedStyle(this).fontFamily,
      },
      this.#predicted,
    );
  }

  get chipAt(): Place | null {
    const { document, view, size } = this.session;
    if (!document.draft) return null;
    const meshes = draftSolids(document).map(({ mesh }) => mesh);
    const middle = { left: size.width / 2, right: size.width / 2, top: 80, bottom: 80 };
    return chipPlace(screenBox(meshes, view, size) ?? middle, size);
  }

  // ── hands ───────────────────────────────────────────────────────────────────────────────────────────

  #pointerTarget(): PointerTarget {
    const { session } = this;
    const ended = () => {
      this.#predicted = [];
      stepBack(this.renderRoot, null);
    };
    return {
      down: (pen) => {
        if (this.open && this.open !== 'settings') this.open = null;
        session.down(pen);
        this.#drawInk();
      },
      move: (pens, predicted) => {
        this.#predicted = predicted;
        session.move(pens);
        // At once, not with the frame: ink waits for nothing.
        this.#drawInk();
        stepBack(this.renderRoot, pens.at(-1) ?? null);
      },
      up: () => {
        ended();
        session.up();
      },
      cancel: () => {
        ended();
        session.cancel();
      },
      orbit: (dx, dy) => session.camera.orbit(dx, dy),
      pan: (dx, dy) => session.camera.pan(dx, dy),
      roll: (angle) => session.camera.roll(angle),
      zoom: (factor, x, y) => session.camera.zoom(factor, x, y),
      focus: () => session.camera.showAll(),
      undo: () => session.undo(),
      redo: () => session.redo(),
      penSeen: () => this.#seePen(),
      fingersDraw: () => this.fingersDraw,
    };
  }

  #seePen(): void {
    if (this.#penSeen) return;
    this.#penSeen = true;
    const touch = navigator.maxTouchPoints > 0;
    this.fingersDraw = false;
    if (!touch) return;
    this.session.notice = {
      text: WORDS.penFound,
      actions: [{ label: WORDS.letFingersDraw, run: () => this.setFingersDraw(true) }],
    };
  }

  #ballActions(): BallActions {
    const { session } = this;
    return {
      orbit: (dx, dy) => session.camera.orbit(dx, dy),
      face: (axis) => session.camera.face(axis),
      reset: () => session.camera.reset(),
    };
  }

  #key(event: KeyboardEvent): void {
    const origin = event.composedPath()[0] as HTMLElement;
    if (origin.matches?.('input') && event.key !== 'Escape') return;
    // Enter and Space press the button that has the focus; letters are still hot keys there.
    if (origin.matches?.('button') && (event.key === 'Enter' || event.key === ' ')) return;
    // A panel that has the focus is what Escape is meant for.
    if (event.key === 'Escape' && origin.closest?.('.panel')) {
      this.dismiss();
      return;
    }
    const handled = press(event, this.session, {
      stepRadius: (direction) => this.#stepRadius(direction),
      toggleHelp: () => this.toggle('help'),
      close: () => this.dismiss(),
    });
    if (handled) event.preventDefault();
  }

  #stepRadius(direction: 1 | -1): void {
    const { radius } = this.document.brush;
    const step = radius + direction * (radius < 10 || (radius === 10 && direction < 0) ? 0.5 : 1);
    this.setRadius(roundRadius(step), true);
  }

  // ── what the controls ask for ───────────────────────────────────────────────────────────────────────

  toggle(name: PanelName): void {
    this.open = this.open === name ? null : name;
  }

  dismiss(): void {
    this.open = null;
    this.#find<HTMLElement>('.stage').focus({ preventScroll: true });
  }

  setFingersDraw(on: boolean): void {
    this.fingersDraw = on;
    this.session.said = on ? 'Fingers draw' : 'Fingers turn the view';
  }

  /** A drag of the slider is shown at once and becomes one undo step when it ends. */
  setRadius(mm: number, done: boolean): void {
    this.session.setRadius(mm, done);
  }
}
