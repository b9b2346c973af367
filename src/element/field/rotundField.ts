/**
 * `<rotund-field>`: a page for developers of fields. Every number and choice of the field core has a control; the body is made
 * beside the page and drawn by the application's own scene. The state is in the address.
 */
import { html, LitElement, type PropertyDeclarations, type PropertyValues, type TemplateResult } from 'lit';
import { DEFAULT_LOOK, type Look, type Mode, type Style } from '../../document/look.ts';
import type { FieldNode } from '../../field/node.ts';
import { volumeLines } from '../../field/volumeLines.ts';
import { UNMOVED } from '../../math/placement.ts';
import type { Scene } from '../../scene/index.ts';
import { isDark } from '../../scene/look.ts';
import type { ShownBody } from '../caster.ts';
import { messageOf } from '../events.ts';
import { layout } from '../layout.ts';
import { PointerRouter } from '../pointer.ts';
import { type BackendChoice, SceneLife, type SceneOwner } from '../sceneLife.ts';
import { PAPER_OF, reducedMotion, themeOf, watchPixelRatio, watchSystem } from '../theme.ts';
import { tokens } from '../tokens.ts';
import { viewBall } from '../viewBall.ts';
import { NO_PICTURE, WORDS } from '../words.ts';
import { dock, statusLine, topBar } from './chrome.ts';
import { FieldBody } from './fieldBody.ts';
import { FieldHands } from './fieldHands.ts';
import { fieldLayout } from './fieldLayout.ts';
import { FieldStage, type Fit, type RayScheme } from './fieldStage.ts';
import { CHOICES, DEFAULT_STATE, type FieldState } from './fieldState.ts';
import { FIELD_WORDS } from './fieldWords.ts';
import { fromHash, toHash } from './hash.ts';
import { treeOf } from './tree.ts';

/** ms without a change until the address is written: browsers refuse more than a hundred in half a minute */
const SETTLED = 250;

export class RotundField extends LitElement {
  static override styles = [tokens, layout, fieldLayout];
  static override properties: PropertyDeclarations = {
    theme: {},
    state: { attribute: false },
    folded: { state: true },
  };

  /** light, dark or contrast; the system's when it is none of them */
  declare theme: string | null;
  declare state: FieldState;
  /** the sheet of narrow pages shows its title only */
  declare folded: boolean;
  backend: BackendChoice = 'auto';
  readonly body = new FieldBody(() => this.#heard());
  readonly stage = new FieldStage(
    DEFAULT_LOOK,
    () => this.#drawn(),
    () => this.requestUpdate(),
  );
  readonly #hands = new FieldHands(this.#host());
  readonly #life = new SceneLife(this.#owner());
  #stop = new AbortController();
  #viewKey = '';
  #writing: ReturnType<typeof setTimeout> | undefined;
  /** the next body's */
  #fit: Fit = 'always';
  /** of the body in the picture: what comes under the same number is a finer one */
  #shown = 0;
  /** the last that made sense */
  #tree: FieldNode | null = null;
  /** what bounding volumes are drawn of */
  #guided: { readonly tree: FieldNode; readonly lines: Float32Array } | null = null;
  /** a passing word of the status line */
  said = '';
  /** what is wrong with the address */
  #badAddress: string | null = null;
  #noPicture: string | null = null;
  /** problems that were read and closed, while they last */
  #closed: readonly string[] = [];

  constructor() {
    super();
    this.theme = null;
    this.state = DEFAULT_STATE;
    this.folded = false;
    this.stage.rays.onRefused = (why) => this.#say(WORDS.raysRefused(why));
  }

  // ── life ────────────────────────────────────────────────────────────────────────────────────────────

  override connectedCallback(): void {
    super.connectedCallback();
    this.#stop = new AbortController();
    const { signal } = this.#stop;
    this.#readAddress();
    watchSystem(() => this.#adapt(), signal);
    watchPixelRatio(() => this.#resize(), signal);
    window.addEventListener('hashchange', () => this.#addressChanged(), { signal });
    void this.updateComplete.then(() => this.isConnected && this.#start(signal));
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#stop.abort();
    clearTimeout(this.#writing);
    this.#life.close();
    this.stage.detach();
    this.body.stop();
  }

  #start(signal: AbortSignal): void {
    const stage = this.#find<HTMLElement>('.stage');
    const router = new PointerRouter(stage, this.#hands.target());
    const sizes = new ResizeObserver(() => this.#resize());
    sizes.observe(stage);
    signal.addEventListener('abort', () => {
      router.dispose();
      sizes.disconnect();
    });
    stage.addEventListener('keydown', (event) => this.#hands.key(event), { signal });
    this.stage.margins = () => this.#margins();
    this.#adapt();
    this.#resize();
    this.#make();
    void this.#life.open();
  }

  #owner(): SceneOwner {
    const field = this;
    return {
      canvas: () => this.#find<HTMLCanvasElement>('.picture'),
      freshCanvas: () => {
        const old = this.#find<HTMLCanvasElement>('.picture');
        old.replaceWith(old.cloneNode());
      },
      get backend() {
        return field.backend;
      },
      fine: false,
      show: (scene) => this.#show(scene),
      lose: () => {
        this.stage.detach();
        this.body.device = null;
        this.#say(FIELD_WORDS.lost);
      },
      withoutScene: (error) => {
        this.dataset.backend = 'none';
        this.#noPicture = messageOf(error);
        this.requestUpdate();
      },
    };
  }

  #show(scene: Scene): void {
    this.dataset.backend = scene.backend;
    this.#noPicture = null;
    if (this.said === FIELD_WORDS.lost) this.said = '';
    this.stage.attach(scene, reducedMotion());
    this.body.device = scene.device;
    if (this.state.where === 'gpu') this.#make();
    this.requestUpdate();
  }

  #adapt(): void {
    const theme = themeOf(this.theme);
    this.dataset.theme = theme;
    if (this.stage.scene) this.stage.scene.rig.reducedMotion = reducedMotion();
    this.stage.setLook({ ...PAPER_OF[theme], ...this.#look });
    this.requestUpdate();
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this;
    if (width > 0 && height > 0) this.stage.resize(width, height, devicePixelRatio);
  }

  /** The picture that is left between the controls. */
  #margins() {
    const { clientWidth: width, clientHeight: height } = this;
    const dock = this.#find<HTMLElement>('.dock');
    const narrow = dock.clientWidth > width / 2;
    const right = narrow ? 0.06 : (dock.clientWidth + 48) / width;
    // px: the status line, and air
    const below = 84;
    const bottom = narrow
      ? Math.min((dock.clientHeight + below) / height, 0.62)
      : Math.max(below / height, 0.14);
    return {
      left: narrow ? 0.06 : 0.05,
      top: Math.min(92 / height, 0.24),
      right: Math.min(right, 0.5),
      bottom,
    };
  }

  #host() {
    const field = this;
    return {
      get rig() {
        return field.stage.scene?.rig ?? null;
      },
      wake: () => this.stage.wake(),
      showAll: (animate: boolean) => this.stage.showAll(animate),
      reset: () => this.stage.reset(),
      toggleRays: () => this.set({ surface: this.state.surface === 'exact' ? 'mesh' : 'exact' }),
      toggleVolumes: () => this.set({ volumes: this.state.volumes === 'shown' ? 'hidden' : 'shown' }),
      toggleWires: () => this.stage.setLook({ wireframe: !this.stage.look.wireframe }),
      setStyle: (number: number) => {
        const style = CHOICES.style.options[number - 1];
        if (style) this.set({ style: style[0] });
        return style !== undefined;
      },
    };
  }

  // ── state ───────────────────────────────────────────────────────────────────────────────────────────

  set(change: Partial<FieldState>): void {
    const before = this.state;
    this.state = { ...before, ...change } as FieldState;
    this.#badAddress = null;
    this.said = '';
    clearTimeout(this.#writing);
    this.#writing = setTimeout(() => this.#writeAddress(), SETTLED);
    this.#changed(before);
  }

  #changed(before: FieldState): void {
    const { style, surface, rays, volumes, ...body } = this.state;
    this.stage.setRays(rays as RayScheme);
    if (before.volumes !== volumes) this.#guide();
    if (before.style !== style || before.surface !== surface) this.stage.setLook(this.#look);
    const changed = (Object.keys(body) as (keyof typeof body)[]).filter((key) => before[key] !== body[key]);
    if (changed.length === 0) return;
    if (changed.includes('skeleton')) this.#fit = 'always';
    // under a slider the picture stays as it is, and for whoever makes the body
    else if (this.#fit === 'never' && changed.some((key) => key in CHOICES && key !== 'where'))
      this.#fit = 'covered';
    this.#make();
  }

  get #look(): Pick<Look, 'style' | 'mode'> {
    return { style: this.state.style as Style, mode: this.state.surface as Mode };
  }

  #make(): void {
    const { state } = this;
    const tree = () => {
      this.#tree = treeOf(state);
      return this.#tree;
    };
    this.body.make(tree, state.resolution, state.where === 'gpu');
  }

  #writeAddress(): void {
    const address = toHash(this.state) || location.pathname + location.search;
    history.replaceState(history.state, '', address);
  }

  #readAddress(): void {
    const { state, problem } = fromHash(location.hash);
    this.state = state;
    this.stage.setRays(state.rays as RayScheme);
    this.#badAddress = problem;
  }

  #addressChanged(): void {
    const before = this.state;
    this.#readAddress();
    this.#changed(before);
  }

  #heard(): void {
    const { made } = this.body;
    // a draft may lack what is thin: what comes after it is fitted once more
    if (made && this.stage.show(made.mesh, this.#fit, made.id === this.#shown) && !made.draft)
      this.#fit = 'never';
    this.#shown = made?.id ?? 0;
    this.stage.cast = this.#cast;
    this.#guide();
    this.requestUpdate();
  }

  #guide(): void {
    const tree = this.state.volumes === 'shown' ? this.#tree : null;
    if (this.#guided?.tree !== tree) this.#guided = tree && { tree, lines: volumeLines(tree, UNMOVED) };
    this.stage.guide(this.#guided?.lines ?? null);
  }

  /** The body that is in the picture, when it is the wanted one. */
  get #cast(): ShownBody | null {
    const { made, progress, problem } = this.body;
    if (!made || !this.#tree || progress !== null || problem !== null) return null;
    return { id: 'body', node: this.#tree, placement: UNMOVED, cells: this.state.resolution };
  }

  /** What rays do, in words. */
  get rays(): string {
    const { exact, comparison } = this.stage;
    const { share, evaluationsAPixel, problem } = exact;
    if (this.state.surface !== 'exact') return '';
    if (problem !== null) return this.state.rays === 'zhu' ? problem : WORDS.notExact;
    if (comparison) return FIELD_WORDS.compared(comparison);
    if (share !== null) return WORDS.casting(Math.round(100 * share));
    return evaluationsAPixel === null ? '' : WORDS.exact(evaluationsAPixel, exact.milliseconds);
  }

  #drawn(): void {
    const key = JSON.stringify(this.stage.view.rotation);
    if (key === this.#viewKey) return;
    this.#viewKey = key;
    this.requestUpdate();
  }

  #say(words: string): void {
    this.said = words;
    this.requestUpdate();
  }

  async copy(): Promise<void> {
    try {
      const text = JSON.stringify(treeOf(this.state), null, 2);
      await navigator.clipboard.writeText(text).then(
        () => this.#say(FIELD_WORDS.copied),
        () => this.#say(FIELD_WORDS.notCopied),
      );
    } catch {
      this.#say(FIELD_WORDS.nothingToCopy);
    }
  }

  reset(): void {
    const { style, where, surface, rays, volumes } = this.state;
    this.set({ ...DEFAULT_STATE, style, where, surface, rays, volumes });
    if (this.body.progress !== null) this.#fit = 'always';
    this.stage.reset();
    this.#say(FIELD_WORDS.reset);
  }

  fold(): void {
    this.folded = !this.folded;
    void this.updateComplete.then(() => this.showAll());
  }

  showAll(): void {
    this.stage.showAll(true);
  }

  get problem(): string | null {
    return this.#problems.find((problem) => !this.#closed.includes(problem)) ?? null;
  }

  close(): void {
    this.#closed = this.problem ? [...this.#closed, this.problem] : [];
    // the button goes, and the focus must not go with it
    this.#find<HTMLElement>('.stage').focus();
    this.requestUpdate();
  }

  /** In words: there is no picture, no body, or no sense in the address. */
  get #problems(): readonly string[] {
    const picture =
      this.#noPicture === null ? [] : `${NO_PICTURE.missing} ${NO_PICTURE.why(this.#noPicture)}`;
    const address = this.#badAddress === null ? [] : FIELD_WORDS.badAddress(this.#badAddress);
    return [picture, this.body.problem ?? [], address].flat();
  }

  // ── drawing ─────────────────────────────────────────────────────────────────────────────────────────

  protected override willUpdate(): void {
    const problems = this.#problems;
    this.#closed = this.#closed.filter((problem) => problems.includes(problem));
  }

  protected override render(): TemplateResult {
    const { made } = this.body;
    return html`<div class="app ${isDark(this.stage.look.background) ? 'on-dark' : ''}">
      <div class="stage" role="application" tabindex="0" aria-label=${FIELD_WORDS.label(made)} aria-describedby="keys">
        <canvas class="picture"></canvas>
      </div>
      <span id="keys" class="hidden">Arrow keys turn, plus and minus zoom, Home shows everything, 0 goes back to the first view, 1 to 4 are styles, W shows the triangles, X shows the exact surface, M shows bounding volumes.</span>
      ${topBar(this)} ${dock(this)} ${statusLine(this)} ${viewBall(this.stage.view, this.#hands.ball())}
    </div>`;
  }

  protected override updated(changed: PropertyValues): void {
    if (changed.has('theme') && changed.get('theme') !== undefined) this.#adapt();
  }

  #find<T extends Element>(selector: string): T {
    const found = this.renderRoot.querySelector<T>(selector);
    if (!found) throw new Error(`rotund-field: its own ${selector} is missing`);
    return found;
  }
}
