/** The tool in hand and where it has come to: it hears of the pen, and says when the picture or the controls are stale. */
import type { Document } from '../document/document.ts';
import type { Pen, State } from '../tool/tool.ts';
import { previewWords } from './draftWords.ts';
import { HoverHint, hintOf } from './hoverHint.ts';
import { Lull } from './lull.ts';
import { Preview } from './preview.ts';
import type { Session } from './session.ts';
import { SliderTrial } from './sliderTrial.ts';
import { TOOLS, type ToolName } from './tools.ts';

/** ms: a pen or a slider that is still for so long rests, and what is shown is made finely */
const REST = 150;

export class ToolInHand {
  tool: ToolName = 'draw';
  state: State = TOOLS.draw;
  /** what moves has been still for a while */
  rests = false;
  /** ms, while what the pen drew is taken in */
  lifted: number | null = null;
  /** where it waits */
  #waiting: State | null = null;
  /** where the pen is over the picture */
  #hovering: Pen | null = null;
  readonly slider = new SliderTrial(this);
  readonly hint: HoverHint;
  readonly #preview = new Preview();
  readonly #resting: Lull;
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
    this.hint = new HoverHint(() => session.update());
    this.#resting = new Lull(REST, () => {
      this.rests = true;
      session.update(false);
    });
  }

  /** What the tool in hand waits in. */
  get idle(): State {
    return this.#waiting ?? TOOLS[this.tool];
  }

  /** Nothing is under way when it is called. */
  take(tool: ToolName): void {
    this.state.leave?.(this.#session);
    this.#waiting = null;
    this.tool = tool;
    // what the tool before showed goes with it
    this.put(TOOLS[tool]);
  }

  down(pen: Pen): void {
    this.#hovering = null;
    this.put(this.state.down?.(pen, this.#session));
  }

  /** Without touching; null: it left. */
  hover(pen: Pen | null): void {
    this.#hovering = pen;
    this.put(this.state.hover?.(pen, this.#session));
  }

  /** What hovers is over another view. */
  hoverAgain(): void {
    if (this.#hovering) this.put(this.state.hover?.(this.#hovering, this.#session));
  }

  /** What hovers is over another document; a finger that was lifted left behind what it saw of the one before. */
  replaced(): void {
    this.put(this.state.hover?.(this.#hovering, this.#session));
  }

  move(pens: readonly Pen[]): void {
    this.put(this.state.move?.(pens, this.#session));
  }

  up(): void {
    this.lifted = performance.now();
    this.put(this.state.up?.(this.#session));
    this.lifted = null;
  }

  /** The stroke or the drag under way goes; true when there was one. */
  cancel(): boolean {
    const before = this.state;
    this.slider.cancel();
    this.put(before.cancel());
    return before !== this.state;
  }

  put(next: State | undefined): void {
    if (!next) return;
    const before = this.state;
    const session = this.#session;
    const closes = next.wet !== undefined && next.wet.closing !== (before.wet?.closing ?? false);
    if ((next.faint ?? false) !== (before.faint ?? false)) session.scene?.setFaint(next.faint ?? false);
    this.state = next;
    this.hint.follow(next);
    if (next.waits) this.#waiting = next;
    if (next.redrawing?.over === 'section') session.seenAgain();
    this.#stir();
    // said once, not at every move
    if (closes) session.said = previewWords(this.shown());
    session.update(closes || shows(next) !== shows(before) || hintOf(next) !== hintOf(before));
  }

  /** It moves, and may rest in a moment. */
  #stir(): void {
    this.rests = false;
    if (this.state.preview) this.#resting.stir();
    else this.#resting.stop();
  }

  /** The document with what it would do. */
  shown(): Document {
    return this.#preview.of(this.state, this.#session);
  }
}

const shows = ({ wet, still }: State): boolean => Boolean(wet ?? still);
