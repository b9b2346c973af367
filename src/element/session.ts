/**
 * One drawing at work: document and history, the tool in hand, the scene, and what was last said. It knows no
 * controls; the element draws those from here and calls back. Pointer moves only mark what is stale: the frame
 * does the work, and wet ink is drawn before it.
 */
import { bodyMade } from '../document/bodies.ts';
import { draftIsWhole, RESOLUTION } from '../document/build.ts';
import { cellsOfBodies } from '../document/cells.ts';
import { partsWith } from '../document/chosen.ts';
import { itemsOf } from '../document/command/changeParts.ts';
import type { Command } from '../document/command/index.ts';
import { draftCrossings } from '../document/crossings.ts';
import {
  type Brush,
  type Document,
  EMPTY_DOCUMENT,
  isImplicit,
  isSurface,
  readingOf,
} from '../document/document.ts';
import { draftPart, partsWithDraft, roughly } from '../document/draftPart.ts';
import { type Drawing, FRONT_VIEW } from '../document/drawing.ts';
import { bodiesOf, type NamedNode } from '../document/fieldParts.ts';
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
import { type Background, DEFAULT_LOOK, type Look, type Mode, type Style } from '../document/look.ts';
import { GROWING, isTooLarge } from '../document/size.ts';
import { nodeOf } from '../document/solidNode.ts';
import type { FieldNode } from '../field/node.ts';
import type { RayCamera } from '../field/rayImage.ts';
import type { Vec3 } from '../math/vec.ts';
// Only the pure parts of the scene at once: three.js is fetched when there is a page to draw on.
import type { Scene } from '../scene/index.ts';
import { AIR, type Margins } from '../scene/view.ts';
import { rayAt } from '../stroke/plane.ts';
import type { View } from '../stroke/stroke.ts';
import { acrossOf } from '../tool/across.ts';
import { choosing } from '../tool/bend.ts';
import { idle } from '../tool/draw.ts';
import { redrawing } from '../tool/redraw.ts';
import { sectioning } from '../tool/section.ts';
import { selecting } from '../tool/select.ts';
import type { Bench, Pen, State, Notice as ToolNotice } from '../tool/tool.ts';
import { trial } from '../tool/trial.ts';
import type { Viewport } from '../tool/viewport.ts';
import { Bodies, type News } from './bodies.ts';
import { CameraMoves } from './cameraMoves.ts';
import { sizeOf } from './detailRows.ts';
import { draftProblem } from './draftProblem.ts';
import { awaitedBack, longName, previewWords, rememberStart, shortName } from './draftWords.ts';
import type { Cause } from './events.ts';
import { Exact } from './exact.ts';
import { isCastable, pickedAmong, pickedOn } from './exactPick.ts';
import { type Flaw, flawsIn } from './flaws.ts';
import { Frames } from './frames.ts';
import { marginsInHand } from './margins.ts';
import type { NoPicture } from './noPicture.ts';
import type { Picked } from './picked.ts';
import { Rays } from './rays.ts';
import { spoken } from './speech.ts';
import { Timing } from './timing.ts';
import { EDIT_WORDS, SECTION_WORDS, SILHOUETTE_WORDS, SOLID_WORDS, SURFACE, WORDS } from './words.ts';

export interface Notice {
  readonly text: string;
  /** goes with the next deed */
  readonly passing?: boolean;
  /** places on the ink that it is about, mm */
  readonly marks?: readonly Vec3[];
  readonly actions: readonly { readonly label: string; run(): void }[];
}

export const TOOLS = {
  draw: idle,
  section: sectioning,
  redraw: redrawing(false),
  bend: choosing,
  select: selecting,
} as const;
/** ms: what takes less is done before one asks */
const PATIENCE = 500;
/** ms: a pen or a slider that is still for so long rests, and what is shown is made finely */
const REST = 150;
/** ms: a hint that stays for so long is spoken */
const CALM = 600;
/** Commands that make another form of the unfinished strokes. */
const FORMING = ['addStroke', 'setTubesOnly', 'setForm', 'addSection', 'removeSection', 'setStroke'];

const isRemoval = (command: Command): boolean =>
  command.type === 'removeSection' || (command.type === 'setStroke' && command.stroke === null);

export type ToolName = keyof typeof TOOLS;

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
  tool: ToolName = 'draw';
  state: State = idle;
  selection: readonly string[] = [];
  /** of the drawing, for the tray and for files */
  name = '';
  look: Look = DEFAULT_LOOK;
  /** Zhu et al.'s bounding volumes are drawn over bodies */
  volumes = false;
  size = { width: 1, height: 1 };
  /** last event, the words of the status line and the live region */
  said: string = WORDS.ready;
  notice: Notice | null = null;
  /** there is no scene, and none comes */
  noPicture: NoPicture | null = null;
  readonly camera = new CameraMoves(this);
  /** a person chose the background: the theme leaves it alone */
  choseBackground = false;
  onFullScreen = (): void => {};
  /** what the controls cover of the picture */
  margins = (): Margins => AIR;
  /** until the slider is let go */
  #dragCancelled = false;
  /** where the tool in hand has come to */
  #waiting: State | null = null;
  /** what a control that is being dragged shows */
  #tuned: State | null = null;
  /** bodies whose problem was told */
  readonly #told = new WeakSet<FieldNode>();
  /** that some rows could not be cast, since exact mode was switched on */
  #toldRows = false;
  /** where one looked from when there last was a scene */
  #lastView: View = FRONT_VIEW;
  /** what is shown while a gesture is under way, by that */
  #preview: { readonly state: State; readonly document: Document; readonly shown: Document } | null = null;
  /** what moves has been still for a while */
  #rests = false;
  #resting: ReturnType<typeof setTimeout> | undefined;
  /** the hint that has come to rest, for those who do not see it; '' while it changes */
  hintAtRest = '';
  #calming: ReturnType<typeof setTimeout> | undefined;
  /** that were last asked for, and whether roughly */
  #wanted: { readonly nodes: readonly FieldNode[]; readonly isRough: boolean } = {
    nodes: [],
    isRough: false,
  };
  readonly #timing = new Timing();
  /** where the pen is over the picture */
  #hovering: Pen | null = null;
  /** the card of the Section tool was closed */
  acrossAway = false;
  /** ms, while what the pen drew is taken in */
  #lifted: number | null = null;
  readonly frames: Frames;
  readonly bodies = new Bodies((news) => this.#bodyNews(news));
  readonly rays = new Rays();
  readonly exact = new Exact(() => this.#exactNews(), this.rays);
  readonly #hooks: Hooks;

  constructor(hooks: Hooks) {
    this.#hooks = hooks;
    this.frames = new Frames(this, () => hooks.drawn());
    this.rays.onRefused = (why) => {
      this.said = WORDS.raysRefused(why);
      this.update();
    };
  }

  get document(): Document {
    return this.history.present;
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

  /** On bodies their surface itself, whatever is seen of them: strokes that start there stay, meshes do not. */
  pick(x: number, y: number, except: readonly string[] = []): Picked | null {
    const isSeen = ({ id, hidden }: NamedNode) => !hidden && !except.includes(id);
    const all = this.look.mode === 'exact' ? bodiesOf(this.document).filter(isSeen) : [];
    const bodies = all.filter(isCastable);
    const hit = this.scene?.pick(x, y, [...except, ...bodies.map(({ id }) => id)]) ?? null;
    if (bodies.length > 0) return this.scene && pickedAmong(bodies, hit, this.#camera, [x, y]);
    if (!hit) return null;
    const parts = partsWithDraft(this.document);
    const part = parts.filter(isImplicit).find(({ id }) => id === hit.id);
    const made = part && bodyMade(nodeOf(part));
    return made ? pickedOn(hit, part, rayAt(this.view, this.size, x, y), made) : { ...hit, skel: null };
  }

  /** For rays through places in CSS pixels. */
  get #camera(): RayCamera {
    return { view: this.view, ...this.size, offset: [0, 0] };
  }

  focus(ids: readonly string[]): void {
    this.camera.show(ids);
  }

  lookFrom(view: View): void {
    this.camera.lookFrom(view);
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
      this.#sayFull();
      return;
    }
    this.history = history;
    this.said = said;
    for (const command of commands)
      if (command.type === 'addStroke' && command.joins) rememberStart(command.stroke, command.joins);
    this.#sayForm(commands);
    if (commands.some(({ type }) => type === 'addStroke')) this.#sayCrossings();
    this.#replaced(before, commands, 'command');
  }

  /** A drawing that could be made but not be saved and opened again would be lost. */
  #sayFull(): void {
    this.notice = { text: WORDS.full, passing: true, actions: [] };
    this.#say(WORDS.full);
  }

  /** The document may be another one: what hangs on it follows, and whoever listens hears of it. */
  #replaced(before: Document, commands: readonly Command[], cause: Cause): void {
    this.update();
    if (this.document === before) return;
    if (commands.some(({ type }) => FORMING.includes(type))) this.#time();
    if (commands.some(({ type }) => type === 'load')) this.bodies.forget();
    this.wantBodies();
    this.select(this.selection);
    // a finger that was lifted left behind what it saw of the document before
    if (this.#hovering) this.hoverAgain();
    else this.#to(this.state.hover?.(null, this));
    this.#hooks.committed(commands, cause);
  }

  #time(): void {
    const drawn = draftPart(this.document);
    this.#timing.begin(drawn && nodeOf(drawn), this.#lifted ?? performance.now());
  }

  /** Those that are seen are made beside the page: roughly while what moves is one of them. */
  wantBodies(): void {
    const { bodies, isRough } = this.#seenBodies();
    this.#wanted = { nodes: bodies.map(({ node }) => node), isRough };
    if (bodies.length === 0) this.bodies.want([]);
    else this.bodies.want(bodies, cellsOfBodies(this.document), { isRough });
  }

  /** For what is only shown: nothing where the bodies are the same. */
  wantShown(): void {
    const { bodies, isRough } = this.#seenBodies();
    const { nodes } = this.#wanted;
    const isSame = bodies.length === nodes.length && bodies.every(({ node }, i) => node === nodes[i]);
    if (!isSame || isRough !== this.#wanted.isRough) this.wantBodies();
  }

  #seenBodies(): { readonly bodies: readonly NamedNode[]; readonly isRough: boolean } {
    const shown = this.shown();
    const bodies = bodiesOf(shown).filter(({ hidden }) => !hidden);
    return { bodies, isRough: !this.#rests && shown !== this.document && draftPart(shown) !== null };
  }

  #bodyNews(news: News): void {
    if (news === 'progress') {
      this.#hooks.changed();
      return;
    }
    this.#timing.look(cellsOfBodies(this.document));
    const lost = bodiesOf(this.document).find(({ node }) => this.#isNewProblem(node));
    if (lost) {
      this.#told.add(lost.node);
      const text = WORDS.notMade(lost.name, this.bodies.problem(lost.node) ?? '');
      this.notice = { text, passing: true, actions: [] };
      this.said = text;
    }
    if (!lost && this.bodies.making === null) this.#sayFlaws();
    this.update();
  }

  /** Once of each tree, when all is made: what is not seen of it. */
  #sayFlaws(): void {
    const nodes = new Map(bodiesOf(this.document).map(({ id, node }) => [id, node]));
    // rays see what is thin, and whether gaps are open
    const isSeen = ({ what }: Flaw) => this.look.mode === 'mesh' || what === 'none' || what === 'cut';
    const fresh = this.flaws.filter((flaw) => isSeen(flaw) && !this.#told.has(nodes.get(flaw.part)!));
    for (const { part } of fresh) this.#told.add(nodes.get(part)!);
    const [first, ...others] = fresh;
    const more = new Set(others.map(({ part }) => part).filter((part) => part !== first?.part)).size;
    if (first) this.said = WORDS.flawed(first.name, first.words, more);
  }

  /** What the picture does not show of the bodies that are shown. */
  get flaws(): readonly Flaw[] {
    return flawsIn(this.document, (node) => this.bodies.problem(node));
  }

  /** There is more to be seen of it, or to be said. */
  #exactNews(): void {
    this.#sayExact();
    this.#hooks.changed();
    this.frames.wake();
  }

  /** Whoever heard that it is on its way hears once how that ended, unless something else was said since. */
  #sayExact(): void {
    if (this.exact.isInPart && !this.#toldRows) {
      this.#toldRows = true;
      this.said = WORDS.rowsLost;
    }
    if (this.said !== WORDS.onItsWay) return;
    if (this.exact.problem !== null) this.said = WORDS.noExact(this.exact.problem);
    else if (this.exact.evaluationsAPixel !== null) this.said = WORDS.mode.exact;
  }

  #isNewProblem(node: FieldNode): boolean {
    return this.bodies.problem(node) !== null && !this.#told.has(node);
  }

  /** What is being made, when that takes long enough to be asked about; '' otherwise. */
  get making(): string {
    const { making, share, elapsed } = this.bodies;
    const part = bodiesOf(this.document).find(({ node }) => node === making);
    return part && elapsed > PATIENCE ? WORDS.making(part.name, Math.round(100 * share)) : '';
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
    this.choseBackground = true;
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

  // ── selection and tools ─────────────────────────────────────────────────────────────────────────────

  /** Of parts, and of what solids are made of; ids that nothing has are left out. */
  select(ids: readonly string[]): void {
    const wanted = new Set(ids);
    const known =
      ids.length === 0
        ? []
        : itemsOf(this.document)
            .map(({ id }) => id)
            .filter((id) => wanted.has(id));
    const same = known.length === this.selection.length && known.every((id, i) => id === this.selection[i]);
    if (same) return;
    this.selection = known;
    this.frames.version++;
    this.#contour();
    this.update();
    this.#hooks.selected(known);
  }

  /** Of a group the part is seen that it is in. */
  #contour(): void {
    this.scene?.select(partsWith(this.document, this.selection).map(({ id }) => id));
  }

  /** Words for a selection a person made. */
  saySelection(): void {
    const chosen = itemsOf(this.document).filter(({ id }) => this.selection.includes(id));
    const names = chosen.map(({ name }) => name);
    const [only] = partsWith(this.document, this.selection);
    const isPart = names.length !== 1 || only?.id === this.selection[0];
    this.said = isPart
      ? WORDS.selected(names, this.document.parts.length)
      : SOLID_WORDS.selectedIn(names[0]!, only!.name);
    this.update();
  }

  /** Drawing deselects; the unfinished form stays as it is. */
  setTool(tool: ToolName): void {
    this.cancel();
    this.state.leave?.(this);
    this.#waiting = null;
    this.tool = tool;
    this.state = TOOLS[tool];
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

  /** A command from a key or a control. A stroke under the pen is cancelled: it was begun on another document. */
  run(command: Command): void {
    this.cancel();
    this.commit([command]);
  }

  /** What the unfinished form is now; what went of it was said. */
  #sayForm(commands: readonly Command[]): void {
    const back = awaitedBack(this.document, commands);
    if (back) this.said = SECTION_WORDS.nowBack(back);
    if (back || !commands.some(({ type }) => FORMING.includes(type)) || !readingOf(this.document)) return;
    const problem = draftProblem(this.document);
    if (problem) this.said = `${longName(this.document)}: ${problem}`;
    else if (!commands.every(isRemoval)) this.said = previewWords(this.document);
  }

  /** Nothing drawn is lost: what goes round something twice is filled once. */
  #sayCrossings(): void {
    const marks = draftCrossings(this.document);
    if (marks.length === 0) return;
    const actions = [
      { label: SILHOUETTE_WORDS.redraw, run: () => this.undo() },
      { label: SILHOUETTE_WORDS.join, run: () => {} },
    ];
    this.notice = { text: SILHOUETTE_WORDS.crosses, passing: true, marks, actions };
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

  #say(words: string): void {
    this.said = words;
    this.update();
  }

  drop(): void {
    if (this.document.draft) this.run({ type: 'drop' });
  }

  setBrush(change: Partial<Brush>): void {
    this.run({ type: 'setBrush', change });
  }

  setRadius(radius: number, done: boolean): void {
    if (this.#dragCancelled) return;
    this.tune({ type: 'setBrush', change: { radius } }, done);
    this.#say(WORDS.radius(radius));
  }

  /** mm, as shown: under the slider or of the document */
  get radius(): number {
    const { brush } = this.state === this.#tuned ? this.shown() : this.document;
    return brush.radius;
  }

  /** A slider is taken hold of or let go: what was only shown is over. */
  holdSlider(): void {
    this.#dragCancelled = false;
    if (this.state === this.#tuned) this.#to(this.idle);
    this.#tuned = null;
    this.update();
  }

  undo(): void {
    // Under the pen the stroke itself is what undo takes back.
    if (this.cancel()) return;
    const words = undoable(this.history);
    this.said = words ? WORDS.undone(words) : WORDS.nothingToUndo;
    this.#clearPassing();
    const before = this.document;
    this.history = undo(this.history);
    this.#replaced(before, [], 'undo');
  }

  redo(): void {
    this.cancel();
    const words = redoable(this.history);
    this.said = words ? WORDS.redone(words) : WORDS.nothingToRedo;
    this.#clearPassing();
    const before = this.document;
    this.history = redo(this.history);
    this.#replaced(before, [], 'redo');
  }

  #clearPassing(): void {
    if (this.notice?.passing) this.notice = null;
  }

  // ── the pen ─────────────────────────────────────────────────────────────────────────────────────────

  down(pen: Pen): void {
    this.#clearPassing();
    this.#hovering = null;
    // A stroke is drawn from where one looks now: a move of the camera ends here and does not go on afterwards.
    const rig = this.scene?.rig;
    if (rig?.moving) rig.setView(rig.view(), false);
    this.#to(this.state.down?.(pen, this));
  }

  /** Without touching; null: it left. */
  hover(pen: Pen | null): void {
    this.#hovering = pen;
    this.#to(this.state.hover?.(pen, this));
  }

  /** What hovers is over another document, or another view of it. */
  hoverAgain(): void {
    if (this.#hovering && this.state.hover) this.#to(this.state.hover(this.#hovering, this));
  }

  move(pens: readonly Pen[]): void {
    this.#to(this.state.move?.(pens, this));
  }

  up(): void {
    this.#lifted = performance.now();
    this.#to(this.state.up?.(this));
    this.#lifted = null;
    this.#hooks.changed();
  }

  /** The stroke or the drag under way goes; true when there was one. */
  cancel(): boolean {
    const before = this.state;
    if (before === this.#tuned) this.#dragCancelled = true;
    this.#tuned = null;
    this.#to(before.cancel());
    this.#hooks.changed();
    return before !== this.state;
  }

  /** A gesture that starts elsewhere than on the picture, such as on a handle. */
  begin(state: State): void {
    this.cancel();
    this.#to(state);
  }

  /** What the tool in hand waits in. */
  get idle(): State {
    return this.#waiting ?? TOOLS[this.tool];
  }

  /** A slider is being dragged: what it would do is only shown until it is let go, and is one undo step then. */
  tune(command: Command, done: boolean): void {
    if (this.#dragCancelled) return;
    this.#tuned = null;
    this.#to(this.idle);
    if (done) this.run(command);
    else {
      this.#tuned = trial(command, this.idle);
      this.#to(this.#tuned);
    }
  }

  #to(next: State | undefined): void {
    if (!next) return;
    const shows = ({ wet, still }: State) => Boolean(wet ?? still);
    const closes = next.wet !== undefined && next.wet.closing !== (this.state.wet?.closing ?? false);
    const began = closes || shows(next) !== shows(this.state) || hintOf(next) !== hintOf(this.state);
    if ((next.faint ?? false) !== (this.state.faint ?? false)) this.scene?.setFaint(next.faint ?? false);
    const { hint } = this;
    this.state = next;
    if (this.hint !== hint) this.#calmHint();
    if (next.waits) this.#waiting = next;
    // what was to be turned for is there
    if (next.redrawing?.over && this.notice?.text === EDIT_WORDS.said['section-edge-on'])
      this.#clearPassing();
    this.#stir();
    // said once, not at every move
    if (closes) this.said = previewWords(this.shown());
    this.update(began);
  }

  /** Said once when the pen rests, not at every place it passes. */
  #calmHint(): void {
    clearTimeout(this.#calming);
    this.hintAtRest = '';
    if (!this.hint) return;
    this.#calming = setTimeout(() => {
      this.hintAtRest = this.hint;
      this.update();
    }, CALM);
  }

  /** It moves, and may rest in a moment. */
  #stir(): void {
    clearTimeout(this.#resting);
    this.#rests = false;
    if (!this.state.preview) return;
    this.#resting = setTimeout(() => {
      this.#rests = true;
      this.update(false);
    }, REST);
  }

  notify(notice: ToolNotice, offer: readonly Command[] = [], from: View | null = null): void {
    if (notice === 'selected') this.saySelection();
    if (notice === 'too-short') this.#offerPoint(offer);
    if (notice in EDIT_WORDS.said) this.said = EDIT_WORDS.said[notice as keyof typeof EDIT_WORDS.said];
    if (from) {
      const turn = { label: WORDS.turn, run: () => this.lookFrom(from) };
      this.notice = { text: this.said, passing: true, actions: [turn] };
    }
    if (notice === 'no-sides' || notice === 'bent' || notice === 'off-sides')
      this.said = SECTION_WORDS.notAcross[notice];
    if (notice === 'edge-on') {
      const first = this.document.draft?.strokes[0];
      const turnBack = () => first && this.scene?.rig.setView(first.view, true);
      this.said = WORDS.edgeOn;
      this.notice = {
        text: WORDS.edgeOn,
        passing: true,
        actions: first ? [{ label: WORDS.turnBack, run: () => turnBack() }] : [],
      };
    }
    this.update();
  }

  /** The point that a tap may have meant: Keep takes it. */
  #takeOffer(): void {
    if (this.notice?.text !== WORDS.orPoint) return;
    const [point] = this.notice.actions;
    this.notice = null;
    point?.run();
  }

  #offerPoint(offer: readonly Command[]): void {
    this.said = offer.length > 0 ? WORDS.orPoint : WORDS.tooShort;
    if (offer.length === 0) return;
    const actions = [{ label: WORDS.point, run: () => this.commit(offer) }];
    this.notice = { text: WORDS.orPoint, passing: true, actions };
  }

  // ── the picture ─────────────────────────────────────────────────────────────────────────────────────

  setLook(change: Partial<Look>): void {
    const { mode } = this.look;
    this.look = { ...this.look, ...change };
    this.scene?.setLook(this.look);
    this.update();
    if (this.look.mode !== mode) this.#hooks.moded(this.look.mode);
  }

  /** There is something that rays can be cast at. */
  get hasBodies(): boolean {
    return bodiesOf(this.document).some(({ hidden }) => !hidden);
  }

  setMode(mode: Mode): void {
    if (mode !== this.look.mode) this.#toldRows = false;
    const words = mode === 'exact' && mode !== this.look.mode ? WORDS.onItsWay : WORDS.mode[mode];
    this.said = this.hasBodies ? words : WORDS.noBodies;
    if (this.hasBodies) this.setLook({ mode });
    else this.update();
  }

  setVolumes(on: boolean): void {
    if (on === this.volumes) return;
    this.volumes = on;
    this.frames.version++;
    this.update();
  }

  /** For people, who are told. */
  toggleVolumes(): void {
    this.said = this.hasBodies ? WORDS.volumesSaid(!this.volumes) : WORDS.noBodies;
    if (this.hasBodies) this.setVolumes(!this.volumes);
    else this.update();
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
    // images lie on the device of the scene before
    this.exact.drop();
    this.rays.use(scene);
    this.frames.version++;
    scene.rig.setView(this.#lastView, false);
    scene.setLook(this.look);
    scene.setFaint(this.state.faint ?? false);
    this.#contour();
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
    if (controls) this.#hooks.changed();
    this.frames.mark();
  }

  /** The document as shown: with the stroke under the pen, or as a slider would make it. */
  shown(): Document {
    const { state, document } = this;
    if (this.#preview?.state === state && this.#preview.document === document) return this.#preview.shown;
    const preview = state.preview?.(this) ?? document;
    const isOld = preview.draft === document.draft && preview.brush === document.brush;
    const shown = isOld ? preview : roughly(preview);
    this.#preview = { state, document, shown };
    return shown;
  }

  /** What rays do, or did; null: triangles are wanted, or there is no picture. */
  get #rays(): string | null {
    const { share, evaluationsAPixel, problem, milliseconds } = this.exact;
    if (this.look.mode !== 'exact' || !this.hasBodies || !this.scene) return null;
    if (problem !== null) return WORDS.notExact;
    // also before it is begun, and while something moves
    if (evaluationsAPixel === null) return WORDS.casting(Math.min(99, Math.floor(100 * (share ?? 0))));
    const words = WORDS.exact(evaluationsAPixel, milliseconds);
    return this.exact.isInPart ? WORDS.inPart(words) : words;
  }

  /** What the pen would do where it is over the picture; '' where there is nothing to say. */
  get hint(): string {
    return hintOf(this.state);
  }

  /** Whether the picture is a mesh or exact, and of what; or what is being made. */
  get seen(): string {
    if (this.making) return this.making;
    const { triangles } = this.frames;
    return this.#rays ?? (triangles > 0 ? WORDS.mesh(triangles) : '');
  }

  /** Of the last form. */
  get detail(): string {
    const last = this.document.parts.at(-1);
    const kind = readingOf(this.document) ?? last?.kind;
    if (!kind) return '';
    const body = last && isImplicit(last) ? bodyMade(nodeOf(last)) : null;
    const surface = last && !this.document.draft && isSurface(last) ? last : null;
    const grid = surface ? sizeOf(surface) : `${RESOLUTION.u} × ${RESOLUTION.v}`;
    const mesh = kind !== 'body' && kind !== 'solid' ? `${grid} mesh` : body ? `${body.cells} cells` : '';
    const time = this.frames.buildTime;
    const took = time > 0 ? `${Math.max(1, Math.round(time))} ms` : '';
    const name = this.document.draft ? shortName(this.document) : SURFACE[kind].name;
    return [name, mesh, took].filter(Boolean).join(' · ');
  }
}

const hintOf = ({ guide, redrawing: held }: State): string =>
  guide
    ? SECTION_WORDS.at(Math.round(100 * guide.u), guide.side)
    : held?.over
      ? EDIT_WORDS.redrawLit[held.over]
      : '';
