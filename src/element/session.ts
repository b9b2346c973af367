/**
 * One drawing at work: document and history, the tool in hand, the scene, and what was last said. It knows no
 * controls; the element draws those from here and calls back. Pointer moves only mark what is stale: the frame
 * does the work, and wet ink is drawn before it.
 */
import { draftSolids, type Solid, solids } from '../document/build.ts';
import { apply, type Command, describe } from '../document/command/index.ts';
import { type Brush, type Document, readingOf } from '../document/document.ts';
import { commit, type History, newHistory, redo, redoable, undo, undoable } from '../document/history.ts';
// Only the pure parts of the scene at once: three.js is fetched when there is a page to draw on.
import type { Scene } from '../scene/index.ts';
import { type Background, DEFAULT_LOOK, type Look, type Style } from '../scene/look.ts';
import { FRONT_VIEW } from '../scene/view.ts';
import type { View } from '../stroke/stroke.ts';
import { idle } from '../tool/draw.ts';
import type { Bench, Pen, State, Notice as ToolNotice } from '../tool/tool.ts';
import type { Viewport } from '../tool/viewport.ts';
import { CameraMoves } from './cameraMoves.ts';
import { SURFACE, WORDS } from './words.ts';

/** ms: a preview that takes longer is not made in every frame */
const SLOW_PREVIEW = 30;

export interface Notice {
  readonly text: string;
  /** goes with the next deed */
  readonly passing?: boolean;
  readonly actions: readonly { readonly label: string; run(): void }[];
}

export class Session implements Bench, Viewport {
  history: History = newHistory();
  scene: Scene | null = null;
  state: State = idle;
  look: Look = DEFAULT_LOOK;
  size = { width: 1, height: 1 };
  /** last event, the words of the status line and the live region */
  said: string = WORDS.ready;
  notice: Notice | null = null;
  readonly camera = new CameraMoves(this);
  /** a person chose the background: the theme leaves it alone */
  choseBackground = false;
  onFullScreen = (): void => {};
  /** ms the last surface took, from strokes to mesh */
  buildTime = 0;
  /** the radius under a slider that is being dragged, mm */
  #radius: number | null = null;
  /** until the slider is let go */
  #dragCancelled = false;
  #synced = 0;
  /** where one looked from when there last was a scene */
  #lastView: View = FRONT_VIEW;
  #stale = true;
  #frame = 0;
  #last = 0;
  readonly #changed: () => void;
  readonly #draw: () => void;

  /** `changed` redraws the controls, `draw` what lies on the canvas. */
  constructor(changed: () => void, draw: () => void) {
    this.#changed = changed;
    this.#draw = draw;
  }

  get document(): Document {
    return this.history.present;
  }

  get viewport(): Viewport {
    return this;
  }

  get view(): View {
    return this.scene?.rig.view() ?? this.#lastView;
  }

  pick(x: number, y: number) {
    return this.scene?.pick(x, y) ?? null;
  }

  // ── commands ────────────────────────────────────────────────────────────────────────────────────────

  /** For the tool in hand; people's own commands come through `run`. */
  commit(commands: readonly Command[]): void {
    this.#clearPassing();
    this.#radius = null;
    for (const command of commands) {
      this.#say(command);
      this.history = commit(this.history, command);
    }
    if (commands.some(({ type }) => type === 'addStroke' || type === 'setTubesOnly')) this.#sayPreview();
    this.update();
  }

  /** A command from a key or a control. A stroke under the pen is cancelled: it was begun on another document. */
  run(command: Command): void {
    this.cancel();
    this.commit([command]);
  }

  #say(command: Command): void {
    const { document } = this;
    const kind = readingOf(document);
    const made = document.tubesOnly ? (document.draft?.strokes.length ?? 0) : 1;
    if (command.type === 'keep' && kind) this.said = WORDS.kept(kind, document.parts.length + made);
    if (command.type === 'drop') this.said = WORDS.dropped;
    if (command.type === 'setBrush') this.said = WORDS.changed(describe(document, command));
    if (command.type === 'removeLast')
      this.said = document.parts.length ? WORDS.deleted(1) : WORDS.nothingToDelete;
    if (command.type === 'removeAll') {
      const count = document.parts.length + (document.draft ? 1 : 0);
      this.said = count ? WORDS.deleted(count) : WORDS.nothingToDelete;
    }
  }

  #sayPreview(): void {
    const kind = readingOf(this.document);
    if (!kind) return;
    this.said = WORDS.preview(kind);
    const built = this.#solids(this.document).some(({ preview }) => preview);
    if (!built && this.said !== WORDS.failed) this.said = WORDS.noSurface;
  }

  keep(): void {
    if (this.document.draft) this.run({ type: 'keep' });
  }

  drop(): void {
    if (this.document.draft) this.run({ type: 'drop' });
  }

  setBrush(change: Partial<Brush>): void {
    this.run({ type: 'setBrush', change });
  }

  /** A drag of the slider is a preview until it is done: one undo step. */
  setRadius(radius: number, done: boolean): void {
    if (this.#dragCancelled) return;
    this.#radius = done ? null : radius;
    if (done) this.setBrush({ radius });
    this.said = WORDS.radius(radius);
    this.update();
  }

  /** mm, as shown: under the slider or of the document */
  get radius(): number {
    return this.#radius ?? this.document.brush.radius;
  }

  /** The slider is taken hold of or let go: what was only shown is over. */
  holdRadius(): void {
    this.#dragCancelled = false;
    this.#radius = null;
    this.update();
  }

  undo(): void {
    // Under the pen the stroke itself is what undo takes back.
    if (this.cancel()) return;
    const words = undoable(this.history);
    this.said = words ? WORDS.undone(words) : WORDS.nothingToUndo;
    this.#clearPassing();
    this.history = undo(this.history);
    this.update();
  }

  redo(): void {
    this.cancel();
    const words = redoable(this.history);
    this.said = words ? WORDS.redone(words) : WORDS.nothingToRedo;
    this.#clearPassing();
    this.history = redo(this.history);
    this.update();
  }

  #clearPassing(): void {
    if (this.notice?.passing) this.notice = null;
  }

  // ── the pen ─────────────────────────────────────────────────────────────────────────────────────────

  down(pen: Pen): void {
    this.#clearPassing();
    // A stroke is drawn from where one looks now: a move of the camera ends here and does not go on afterwards.
    const rig = this.scene?.rig;
    if (rig?.moving) rig.setView(rig.view(), false);
    this.#to(this.state.down?.(pen, this));
  }

  move(pens: readonly Pen[]): void {
    this.#to(this.state.move?.(pens, this));
  }

  up(): void {
    this.#to(this.state.up?.(this));
    this.#changed();
  }

  /** The stroke or the drag under way goes; true when there was one. */
  cancel(): boolean {
    if (this.#radius !== null) {
      this.#radius = null;
      this.#dragCancelled = true;
      this.update();
      return true;
    }
    const before = this.state;
    this.#to(this.state.cancel());
    this.#changed();
    return before !== this.state;
  }

  #to(next: State | undefined): void {
    if (!next) return;
    const began = Boolean(next.wet) !== Boolean(this.state.wet);
    this.state = next;
    this.update(began);
  }

  notify(notice: ToolNotice): void {
    if (notice === 'too-short') this.said = WORDS.tooShort;
    if (notice === 'edge-on') {
      const first = this.document.draft?.strokes[0];
      const turnBack = () => first && this.scene?.rig.setView(first.view, true);
      this.said = WORDS.edgeOn;
      this.notice = {
        text: WORDS.edgeOn,
        passing: true,
        actions: [{ label: WORDS.turnBack, run: () => turnBack() }],
      };
    }
    this.update();
  }

  // ── the picture ─────────────────────────────────────────────────────────────────────────────────────

  setLook(change: Partial<Look>): void {
    this.look = { ...this.look, ...change };
    this.scene?.setLook(this.look);
    this.update();
  }

  setStyle(style: Style, name: string): void {
    this.said = WORDS.style(name);
    this.setLook({ style });
  }

  setBackground(background: Background): void {
    this.choseBackground = true;
    this.setLook({ background });
  }

  fullScreen(): void {
    this.onFullScreen();
  }

  attach(scene: Scene): void {
    if (this.scene !== scene) this.scene?.dispose();
    this.scene = scene;
    scene.rig.setView(this.#lastView, false);
    scene.setLook(this.look);
    this.update();
  }

  detach(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#lastView = this.view;
    this.scene?.dispose();
    this.scene = null;
  }

  /** Something the picture shows has changed; `controls`: the controls too. */
  update(controls = true): void {
    this.#stale = true;
    if (controls) this.#changed();
    this.wake();
  }

  /** One more frame, for a moving camera. */
  wake(): void {
    this.#frame ||= requestAnimationFrame((now) => this.#tick(now));
  }

  #tick(now: number): void {
    this.#frame = 0;
    // A long rest is no time for the camera's motion.
    const seconds = Math.min(0.1, (now - this.#last) / 1000);
    this.#last = now;
    const moving = this.scene?.rig.update(seconds) ?? false;
    if (this.#stale && this.#due) this.#sync();
    this.scene?.render();
    this.#draw();
    if (moving || this.#stale) this.wake();
  }

  /** The document as shown: with the stroke under the pen. */
  shown(): Document {
    const { document } = this;
    if (this.#radius === null) return this.state.preview?.(this) ?? document;
    return apply(document, { type: 'setBrush', change: { radius: this.#radius } });
  }

  #sync(): void {
    this.#stale = false;
    this.#synced = performance.now();
    this.scene?.sync(this.#solids(this.shown()).map(({ solid, preview }) => ({ ...solid, preview })));
  }

  /** A preview that took long waits its turn: the pen has the time before it. */
  get #due(): boolean {
    if (!this.state.wet || this.buildTime < SLOW_PREVIEW) return true;
    return performance.now() - this.#synced > 4 * this.buildTime;
  }

  #solids(shown: Document): { solid: Solid; preview: boolean }[] {
    const start = performance.now();
    const found = this.#build(shown);
    const took = performance.now() - start;
    // Less is a look into the cache.
    if (took > 0.5) this.buildTime = took;
    return found;
  }

  #build(shown: Document): { solid: Solid; preview: boolean }[] {
    try {
      const kept = solids(shown).map((solid) => ({ solid, preview: false }));
      return [...kept, ...draftSolids(shown).map((solid) => ({ solid, preview: true }))];
    } catch (error) {
      // A surface that cannot be built must not take the drawing with it.
      console.error(error);
      this.said = WORDS.failed;
      return solids(this.document).map((solid) => ({ solid, preview: false }));
    }
  }

  /** What the second line of the status shows. */
  get detail(): string {
    const kind = readingOf(this.document) ?? this.document.parts.at(-1)?.kind;
    return kind ? `${SURFACE[kind].name} · 64 × 64 mesh` : '';
  }
}
