/**
 * One drawing at work: document and history, and what hangs on them: the tool in hand, the selection, the bodies, the look, the
 * scene, and what was last said. It knows no controls; the element draws those from here and calls back. Pointer moves only mark
 * what is stale: the frame does the work, and wet ink is drawn before it.
 */
import { draftIsWhole } from '../document/build.ts';
import type { Command } from '../document/command/index.ts';
import { draftCrossings } from '../document/crossings.ts';
import { type Brush, type Document, EMPTY_DOCUMENT } from '../document/document.ts';
import { type Drawing, FRONT_VIEW } from '../document/drawing.ts';
import {
  commit,
  type History,
  newHistory,
  redo,
  redoable,
  scriptOf,
  undo,
  undoable,
} from '../document/history.ts';
import type { Background, Look, Mode, Style } from '../document/look.ts';
import { GROWING, isTooLarge } from '../document/size.ts';
// Only the pure parts of the scene at once: three.js is fetched when there is a page to draw on.
import type { Scene } from '../scene/index.ts';
import { AIR, type Margins } from '../scene/view.ts';
import type { View } from '../stroke/stroke.ts';
import { acrossOf } from '../tool/across.ts';
import type { Bench, Pen, State, Notice as ToolNotice } from '../tool/tool.ts';
import type { Viewport } from '../tool/viewport.ts';
import { BodyWork } from './bodyWork.ts';
import { CameraMoves } from './cameraMoves.ts';
import { rememberStart } from './draftWords.ts';
import type { Cause } from './events.ts';
import { Exact } from './exact.ts';
import { areForming, formedWords } from './formedWords.ts';
import { Frames } from './frames.ts';
import { Looks } from './looks.ts';
import { marginsInHand } from './margins.ts';
import type { NoPicture } from './noPicture.ts';
import {
  crossingNotice,
  edgeOnNotice,
  isOffer,
  isTurn,
  type Notice,
  passing,
  pointNotice,
} from './notice.ts';
import type { Picked } from './picked.ts';
import { pickAt } from './picking.ts';
import { Rays } from './rays.ts';
import { Selection } from './selection.ts';
import { spoken } from './speech.ts';
import { seenWords } from './statusWords.ts';
import { ToolInHand } from './toolInHand.ts';
import type { ToolName } from './tools.ts';
import { laidDownWords, toolWords } from './toolWords.ts';
import { SECTION_WORDS, WORDS } from './words.ts';

export interface Hooks {
  /** the controls are stale */
  changed(): void;
  /** a frame was drawn: now what lies on it */
  drawn(): void;
  /** the document is another one; undo and redo carry no commands */
  committed(commands: readonly Command[], cause: Cause): void;
  selected(ids: readonly string[]): void;
  /** bodies are shown otherwise */
  moded(mode: Mode): void;
}

export class Session implements Bench, Viewport {
  history: History = newHistory();
  scene: Scene | null = null;
  /** of the drawing, for the tray and for files */
  name = '';
  size = { width: 1, height: 1 };
  /** last event, the words of the status line and the live region */
  said: string = WORDS.ready;
  notice: Notice | null = null;
  /** there is no scene, and none comes */
  noPicture: NoPicture | null = null;
  onFullScreen = (): void => {};
  /** what the controls cover of the picture */
  margins = (): Margins => AIR;
  /** the card of the Section tool was closed */
  acrossAway = false;
  /** where one looked from when there last was a scene */
  #lastView: View = FRONT_VIEW;
  readonly camera = new CameraMoves(this);
  readonly hand = new ToolInHand(this);
  readonly chosen = new Selection(this);
  readonly looks: Looks;
  readonly frames: Frames;
  readonly bodyWork = new BodyWork(this);
  readonly bodies = this.bodyWork.bodies;
  readonly rays = new Rays();
  readonly exact = new Exact(() => this.#exactNews(), this.rays);
  readonly #hooks: Hooks;

  constructor(hooks: Hooks) {
    this.#hooks = hooks;
    this.looks = new Looks(this, (mode) => hooks.moded(mode));
    this.frames = new Frames(this, () => hooks.drawn());
    this.rays.onRefused = (why) => this.#say(WORDS.raysRefused(why));
  }

  get document(): Document {
    return this.history.present;
  }

  /** The document as shown: with the stroke under the pen, or as a slider would make it. */
  shown(): Document {
    return this.hand.shown();
  }

  // ── commands ────────────────────────────────────────────────────────────────────────────────────────

  /** For the tool in hand; people's own commands come through `run`. */
  commit(commands: readonly Command[]): void {
    this.#clearPassing();
    const before = this.document;
    let { history, said } = this;
    for (const command of commands) {
      said = spoken(history.present, command) ?? said;
      history = commit(history, command);
    }
    const grows = commands.some(({ type }) => GROWING.includes(type));
    if (grows && isTooLarge(history.present)) {
      // A drawing that could be made but not be saved and opened again would be lost.
      this.notice = passing(WORDS.full);
      this.#say(WORDS.full);
      return;
    }
    this.history = history;
    const strokes = commands.filter((command) => command.type === 'addStroke');
    for (const { stroke, joins } of strokes) if (joins) rememberStart(stroke, joins);
    this.said = formedWords(this.document, commands) ?? said;
    const crossings = strokes.length > 0 ? draftCrossings(this.document) : [];
    if (crossings.length > 0) this.notice = crossingNotice(crossings, () => this.undo());
    this.#replaced(before, commands, 'command');
  }

  /** The document may be another one: what hangs on it follows, and whoever listens hears of it. */
  #replaced(before: Document, commands: readonly Command[], cause: Cause): void {
    this.update();
    if (this.document === before) return;
    if (areForming(commands)) this.bodyWork.time(this.hand.lifted ?? undefined);
    if (commands.some(({ type }) => type === 'load')) this.bodies.forget();
    this.bodyWork.want();
    this.select(this.selection);
    this.hand.replaced();
    this.#hooks.committed(commands, cause);
  }

  /** A command from a key or a control. A stroke under the pen is cancelled: it was begun on another document. */
  run(command: Command): void {
    this.cancel();
    this.commit([command]);
  }

  keep(): void {
    if (!this.document.draft) {
      this.#takeOffer();
      return;
    }
    // A part that nobody could see would stay in the drawing unnoticed.
    if (draftIsWhole(this.document)) this.run({ type: 'keep' });
    else this.#say(WORDS.cannotKeep);
  }

  /** The point that a tap may have meant. */
  #takeOffer(): void {
    if (!isOffer(this.notice)) return;
    const [point] = this.notice.actions;
    this.notice = null;
    point?.run();
  }

  drop(): void {
    if (this.document.draft) this.run({ type: 'drop' });
  }

  setBrush(change: Partial<Brush>): void {
    this.run({ type: 'setBrush', change });
  }

  undo(): void {
    // Under the pen the stroke itself is what undo takes back.
    if (this.cancel()) return;
    const words = undoable(this.history);
    this.#travel(undo, words ? WORDS.undone(words) : WORDS.nothingToUndo, 'undo');
  }

  redo(): void {
    this.cancel();
    const words = redoable(this.history);
    this.#travel(redo, words ? WORDS.redone(words) : WORDS.nothingToRedo, 'redo');
  }

  #travel(to: (history: History) => History, words: string, cause: Cause): void {
    this.said = words;
    this.#clearPassing();
    const before = this.document;
    this.history = to(this.history);
    this.#replaced(before, [], cause);
  }

  // ── what is said ────────────────────────────────────────────────────────────────────────────────────

  #say(words: string): void {
    this.said = words;
    this.update();
  }

  /** What the view was to be turned for is seen. */
  seenAgain(): void {
    if (isTurn(this.notice)) this.notice = null;
  }

  #clearPassing(): void {
    if (this.notice?.passing) this.notice = null;
  }

  notify(notice: ToolNotice, offer: readonly Command[] = [], from: View | null = null): void {
    this.said = toolWords(notice, this.chosen.words);
    if (notice === 'too-short' && offer.length > 0) {
      this.notice = pointNotice(() => this.commit(offer));
      this.said = this.notice.text;
    }
    if (from) this.notice = passing(this.said, { label: WORDS.turn, run: () => this.lookFrom(from) });
    if (notice === 'edge-on')
      this.notice = edgeOnNotice(this.document, (view) => this.scene?.rig.setView(view, true));
    this.update();
  }

  /** There is more to be seen of it, or to be said. */
  #exactNews(): void {
    this.looks.exact.say();
    this.changed();
    this.frames.wake();
  }

  /** Whether the picture is a mesh or exact, and of what; or what is being made. */
  get seen(): string {
    return seenWords(this);
  }

  /** What the pen would do where it is over the picture; '' where there is nothing to say. */
  get hint(): string {
    return this.hand.hint.shown;
  }

  /** The hint that has come to rest, for those who do not see it; '' while it changes. */
  get hintAtRest(): string {
    return this.hand.hint.atRest;
  }

  // ── files ───────────────────────────────────────────────────────────────────────────────────────────

  /** As it would be saved: with how one looks at it now. */
  get drawing(): Drawing {
    return { name: this.name, document: this.document, view: this.view, look: this.look };
  }

  /** The commands that lead from an empty document to this one. */
  get script(): readonly Command[] {
    return scriptOf(this.history);
  }

  /**
   * Another drawing in place of this one, as one undo step. `fit` shows all of it from where it was last looked at;
   * otherwise the view is the stored one to the bit. `fresh` forgets the history: for what was there from the start.
   */
  open(drawing: Drawing, { fit = true, fresh = false } = {}): void {
    this.cancel();
    const { document, name } = drawing;
    const before = this.document;
    this.name = name;
    this.setLook(drawing.look);
    this.looks.choseBackground = true;
    this.#setView(drawing.view, fit);
    if (fresh) {
      this.history = newHistory(document);
      this.#replaced(before, [{ type: 'load', document, name }], 'command');
    } else this.commit([{ type: 'load', document, name }]);
  }

  /** An empty page, as one undo step. */
  clear(): void {
    this.cancel();
    this.name = '';
    if (this.document !== EMPTY_DOCUMENT) this.commit([{ type: 'load', document: EMPTY_DOCUMENT, name: '' }]);
    this.camera.reset();
  }

  #setView(view: View, fit: boolean): void {
    this.#lastView = view;
    this.frames.fit = fit;
    this.scene?.rig.setView(view, false);
  }

  // ── selection ───────────────────────────────────────────────────────────────────────────────────────

  get selection(): readonly string[] {
    return this.chosen.ids;
  }

  /** Of parts, and of what solids are made of; ids that nothing has are left out. */
  select(ids: readonly string[]): void {
    if (!this.chosen.set(ids)) return;
    this.frames.version++;
    this.update();
    this.#hooks.selected(this.selection);
  }

  /** Words for a selection a person made. */
  saySelection(): void {
    this.#say(this.chosen.words);
  }

  // ── the tool in hand ────────────────────────────────────────────────────────────────────────────────

  get tool(): ToolName {
    return this.hand.tool;
  }

  get state(): State {
    return this.hand.state;
  }

  /** What the tool in hand waits in. */
  get idle(): State {
    return this.hand.idle;
  }

  /** Drawing deselects; the unfinished form stays as it is. */
  setTool(tool: ToolName): void {
    this.cancel();
    if (tool !== this.tool) this.said = laidDownWords(this.tool, this.said);
    this.hand.take(tool);
    if (tool === 'draw') this.select([]);
    if (tool === 'section') this.#takeSection();
    this.update();
  }

  /** What there is to be drawn across, or what is missing. */
  #takeSection(): void {
    this.acrossAway = false;
    const across = acrossOf(this);
    this.said = typeof across === 'string' ? SECTION_WORDS.notAcross[across] : SECTION_WORDS.across;
    if (across === 'edge-on') this.notify(across);
  }

  down(pen: Pen): void {
    this.#clearPassing();
    // A stroke is drawn from where one looks now: a move of the camera ends here and does not go on afterwards.
    const rig = this.scene?.rig;
    if (rig?.moving) rig.setView(rig.view(), false);
    this.hand.down(pen);
  }

  /** Without touching; null: it left. */
  hover(pen: Pen | null): void {
    this.hand.hover(pen);
  }

  move(pens: readonly Pen[]): void {
    this.hand.move(pens);
  }

  up(): void {
    this.hand.up();
    this.changed();
  }

  /** The stroke or the drag under way goes; true when there was one. */
  cancel(): boolean {
    const wasBusy = this.hand.cancel();
    this.changed();
    return wasBusy;
  }

  /** A gesture that starts elsewhere than on the picture, such as on a handle. */
  begin(state: State): void {
    this.cancel();
    this.hand.put(state);
  }

  /** A slider is being dragged: what it would do is only shown until it is let go, and is one undo step then. */
  tune(command: Command, done: boolean): void {
    this.hand.slider.tune(command, done, (tuned) => this.run(tuned));
  }

  /** A slider is taken hold of or let go: what was only shown is over. */
  holdSlider(): void {
    this.hand.slider.hold();
    this.update();
  }

  setRadius(radius: number, done: boolean): void {
    if (this.hand.slider.isCancelled) return;
    this.tune({ type: 'setBrush', change: { radius } }, done);
    this.#say(WORDS.radius(radius));
  }

  /** mm, as shown: under the slider or of the document */
  get radius(): number {
    const { brush } = this.hand.slider.isShown ? this.shown() : this.document;
    return brush.radius;
  }

  // ── the picture ─────────────────────────────────────────────────────────────────────────────────────

  get look(): Look {
    return this.looks.look;
  }

  /** Zhu et al.'s bounding volumes are drawn over bodies. */
  get volumes(): boolean {
    return this.looks.volumes;
  }

  setLook(change: Partial<Look>): void {
    this.looks.set(change);
  }

  setMode(mode: Mode): void {
    this.looks.setMode(mode);
  }

  setStyle(style: Style, name: string): void {
    this.looks.setStyle(style, name);
  }

  setBackground(background: Background): void {
    this.looks.setBackground(background);
  }

  get viewport(): Viewport {
    return this;
  }

  room(): Margins {
    return marginsInHand(this.margins(), this.size);
  }

  get view(): View {
    return this.scene?.rig.view() ?? this.#lastView;
  }

  get goal(): View {
    return this.scene?.rig.goal() ?? this.#lastView;
  }

  pick(x: number, y: number, except: readonly string[] = []): Picked | null {
    return pickAt(this, x, y, except);
  }

  focus(ids: readonly string[]): void {
    this.camera.show(ids);
  }

  lookFrom(view: View): void {
    this.camera.lookFrom(view);
  }

  attach(scene: Scene): void {
    if (this.scene !== scene) this.scene?.dispose();
    this.scene = scene;
    // images lie on the device of the scene before
    this.exact.drop();
    this.rays.use(scene);
    this.frames.version++;
    scene.rig.setView(this.#lastView, false);
    scene.setLook(this.look);
    scene.setFaint(this.state.faint ?? false);
    this.chosen.contour();
    this.update();
  }

  detach(): void {
    this.frames.stop();
    this.exact.stop();
    this.#lastView = this.view;
    this.scene?.dispose();
    this.scene = null;
  }

  /** Something the picture shows has changed; `controls`: the controls too. */
  update(controls = true): void {
    if (controls) this.changed();
    this.frames.mark();
  }

  /** The controls are stale, the picture is not. */
  changed(): void {
    this.#hooks.changed();
  }
}
