/** The bodies of what is shown: which are wanted and how finely, and what there is to say of how they came out. */
import { cellsOfBodies } from '../document/cells.ts';
import { draftPart } from '../document/draftPart.ts';
import { bodiesOf, type NamedNode } from '../document/fieldParts.ts';
import { nodeOf } from '../document/solidNode.ts';
import type { FieldNode } from '../field/node.ts';
import { Bodies, type News } from './bodies.ts';
import { type Flaw, flawsIn } from './flaws.ts';
import { passing } from './notice.ts';
import type { Session } from './session.ts';
import { Timing } from './timing.ts';
import { WORDS } from './words.ts';

/** ms: what takes less is done before one asks */
const PATIENCE = 500;

export class BodyWork {
  readonly bodies = new Bodies((news) => this.#news(news));
  /** those whose problem was told */
  readonly #told = new WeakSet<FieldNode>();
  /** that were last asked for, and whether roughly */
  #wanted: { readonly nodes: readonly FieldNode[]; readonly isRough: boolean } = {
    nodes: [],
    isRough: false,
  };
  readonly #timing = new Timing();
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
  }

  /** The unfinished form is another one: `lifted` is when the pen left it, ms. */
  time(lifted = performance.now()): void {
    const drawn = draftPart(this.#session.document);
    this.#timing.begin(drawn && nodeOf(drawn), lifted);
  }

  /** Those that are seen are made beside the page: roughly while what moves is one of them. */
  want(): void {
    const { bodies, isRough } = this.#seen();
    this.#wanted = { nodes: bodies.map(({ node }) => node), isRough };
    if (bodies.length === 0) this.bodies.want([]);
    else this.bodies.want(bodies, cellsOfBodies(this.#session.document), { isRough });
  }

  /** For what is only shown: nothing where the bodies are the same. */
  wantShown(): void {
    const { bodies, isRough } = this.#seen();
    const { nodes } = this.#wanted;
    const isSame = bodies.length === nodes.length && bodies.every(({ node }, i) => node === nodes[i]);
    if (!isSame || isRough !== this.#wanted.isRough) this.want();
  }

  #seen(): { readonly bodies: readonly NamedNode[]; readonly isRough: boolean } {
    const { document, hand } = this.#session;
    const shown = hand.shown();
    const bodies = bodiesOf(shown).filter(({ hidden }) => !hidden);
    return { bodies, isRough: !hand.rests && shown !== document && draftPart(shown) !== null };
  }

  #news(news: News): void {
    const session = this.#session;
    if (news === 'progress') {
      session.changed();
      return;
    }
    this.#timing.look(cellsOfBodies(session.document));
    const lost = bodiesOf(session.document).find(({ node }) => this.#isNewProblem(node));
    if (lost) this.#sayLost(lost);
    else if (this.bodies.making === null) this.#sayFlaws();
    session.update();
  }

  #isNewProblem(node: FieldNode): boolean {
    return this.bodies.problem(node) !== null && !this.#told.has(node);
  }

  #sayLost({ name, node }: NamedNode): void {
    this.#told.add(node);
    const text = WORDS.notMade(name, this.bodies.problem(node) ?? '');
    this.#session.notice = passing(text);
    this.#session.said = text;
  }

  /** Once of each tree, when all is made: what is not seen of it. */
  #sayFlaws(): void {
    const { document, look } = this.#session;
    const nodes = new Map(bodiesOf(document).map(({ id, node }) => [id, node]));
    // rays see what is thin, and whether gaps are open
    const isSeen = ({ what }: Flaw) => look.mode === 'mesh' || what === 'none' || what === 'cut';
    const fresh = this.flaws.filter((flaw) => isSeen(flaw) && !this.#told.has(nodes.get(flaw.part)!));
    for (const { part } of fresh) this.#told.add(nodes.get(part)!);
    const [first, ...others] = fresh;
    const more = new Set(others.map(({ part }) => part).filter((part) => part !== first?.part)).size;
    if (first) this.#session.said = WORDS.flawed(first.name, first.words, more);
  }

  /** What the picture does not show of the bodies that are shown. */
  get flaws(): readonly Flaw[] {
    return flawsIn(this.#session.document, (node) => this.bodies.problem(node));
  }

  /** What is being made, when that takes long enough to be asked about; '' otherwise. */
  get words(): string {
    const { making, share, elapsed } = this.bodies;
    const part = bodiesOf(this.#session.document).find(({ node }) => node === making);
    return part && elapsed > PATIENCE ? WORDS.making(part.name, Math.round(100 * share)) : '';
  }
}
