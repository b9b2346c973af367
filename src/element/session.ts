/**
 * One drawing at work: document and history, the tool in hand, the scene, and what was last said. It knows no
 * controls; the element draws those from here and calls back. Pointer moves only mark what is stale: the frame
 * does the work, and wet ink is drawn before it.
 */
import { draftSolids, type Solid, solids } from '../document/build.ts';
import { apply, type Command } from '../document/command/index.ts';
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

export interface Notice {
  readonly text: string;
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
  /** the document under a slider that is being dragged */
  #dragged: Document | null = null;
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

  commit(commands: readonly Command[]): void {
    // A notice speaks of what was: the next deed makes it untrue.
    this.notice = null;
    for (const command of commands) {
      this.#say(command);
      this.history = commit(this.history, command);
    }
    if (commands.some(({ type }) => type === 'addStroke')) this.#sayPreview();
    this.update();
  }

  #say(command: Command): void {
    const { document } = this;
    const kind = readingOf(document);
    const made = document.tubesOnly ? (document.draft?.strokes.length ?? 0) : 1;
    if (command.type === 'keep' && kind) this.said = WORDS.kept(kind, document.parts.length + made);
    if (command.type === 'drop') this.said = WORDS.dropped;
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
    const built = this.#solids().some(({ preview }) => preview);
    if (!built && this.said !== WORDS.failed) this.said = WORDS.noSurface;
  }

  keep(): void {
    if (this.document.draft) this.commit([{ type: 'keep' }]);
  }

  drop(): void {
    if (this.document.draft) this.commit([{ type: 'drop' }]);
  }

  setBrush(change: Partial<Brush>): void {
    this.commit([{ type: 'setBrush', change }]);
  }

  /** A drag of the slider is a preview until it is done: one undo step. */
  setRadius(radius: number, done: boolean): void {
    const change = { radius };
    this.said = WORDS.radius(radius);
    if (done) {
      this.#dragged = null;
      this.setBrush(change);
      return;
    }
    this.#dragged = apply(this.document, { type: 'setBrush', change });
    this.update();
  }

  undo(): void {
    const words = undoable(this.history);
    this.said = words ? WORDS.undone(words) : WORDS.nothingToUndo;
    this.notice = null;
    this.history = undo(this.history);
    this.update();
  }

  redo(): void {
    const words = redoable(this.history);
    this.said = words ? WORDS.redone(words) : WORDS.nothingToRedo;
    this.notice = null;
    this.history = redo(this.history);
    this.update();
  }

  // ── the pen ─────────────────────────────────────────────────────────────────────────────────────────

  down(pen: Pen): void {
    this.notice = null;
    this.#to(this.state.down?.(pen, this));
  }

  move(pens: readonly Pen[]): void {
    this.#to(this.state.move?.(pens, this));
  }

  up(): void {
    this.#to(this.state.up?.(this));
    this.#changed();
  }

  /** The stroke goes; true when there was one. */
  cancel(): boolean {
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
      this.notice = { text: WORDS.edgeOn, actions: [{ label: WORDS.turnBack, run: () => turnBack() }] };
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
    if (this.#stale) this.#sync();
    this.scene?.render();
    this.#draw();
    if (moving) this.wake();
  }

  /** The document as shown: with the stroke under the pen. */
  shown(): Document {
    return this.state.preview?.(this) ?? this.#dragged ?? this.document;
  }

  #sync(): void {
    this.#stale = false;
    this.scene?.sync(this.#solids().map(({ solid, preview }) => ({ ...solid, preview })));
  }

  #solids(): { solid: Solid; preview: boolean }[] {
    const start = performance.now();
    const found = this.#build();
    const took = performance.now() - start;
    // Less is a look into the cache.
    if (took > 0.5) this.buildTime = took;
    return found;
  }

  #build(): { solid: Solid; preview: boolean }[] {
    try {
      const shown = this.shown();
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
