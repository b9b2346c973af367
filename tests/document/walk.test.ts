/** Random walks through commands, undo and redo: what a script makes of them is the document there is. */
import { describe, expect, it } from 'vitest';
import { apply, type Command } from '../../src/document/command/index.ts';
import type { Brush } from '../../src/document/document.ts';
import {
  commit,
  type History,
  newHistory,
  redo,
  redoable,
  scriptOf,
  undo,
  undoable,
} from '../../src/document/history.ts';
import { parse, serialize, serializeScript } from '../../src/document/serialize.ts';
import type { Stroke } from '../../src/stroke/stroke.ts';
import { random } from '../fixtures/random.ts';
import { bytesOf, drawingOf, meshesOf, NAMES } from './files.ts';
import { PLANE, strokeAlong } from './strokes.ts';

const SEEDS = process.env.ROTUND_FULL ? 20 : 3;
const STEPS = 500;

class Walker {
  readonly #next: () => number;

  constructor(seed: number) {
    this.#next = random(seed);
  }

  between(from: number, to: number): number {
    return from + (to - from) * this.#next();
  }

  chance(share: number): boolean {
    return this.#next() < share;
  }

  of<T>(options: readonly T[]): T {
    return options[Math.floor(this.#next() * options.length)]!;
  }

  stroke(): Stroke {
    const [x, y, bend] = [this.between(-50, 50), this.between(-50, 50), this.between(-20, 20)];
    const closed = this.chance(0.2);
    const path = (t: number): [number, number] =>
      closed ? [x + 20 * Math.cos(6.2 * t), y + 15 * Math.sin(6.2 * t)] : [x + bend * t * t, y + 40 * t];
    const plane = this.chance(0.3) ? { ...PLANE, origin: [0, 0, this.between(-9, 9)] as const } : PLANE;
    const pointer = this.of(['pen', 'touch', 'mouse'] as const);
    const stroke = strokeAlong(path, { closed, plane, pointer }, 10);
    const samples = stroke.samples.map((sample) => ({ ...sample, pressure: this.between(0, 1) }));
    return { ...stroke, samples };
  }

  change(): Partial<Brush> {
    return this.of<() => Partial<Brush>>([
      () => ({ radius: this.between(0.5, 60) }),
      () => ({ colour: this.of(['#112233', '#AABBCC']), caps: this.chance(0.5) }),
      () => ({ pressure: this.chance(0.5), levels: this.of([0, 1, 2, 3, 4, 5, 6]) }),
      () => ({ filter: this.of(['least-squares', 'chaikin', 'cubic'] as const) }),
    ])();
  }

  /** A command on parts that are there, if there are any. */
  command({ parts }: History['present']): Command {
    const ids = parts.map(({ id }) => id).filter(() => this.chance(0.3));
    const vector = () => [this.between(-30, 30), this.between(-30, 30), this.between(-30, 30)] as const;
    const onParts: readonly (() => Command)[] = [
      () => ({ type: 'removeLast' }),
      () => ({ type: 'removeParts', ids: ids.slice(0, 2) }),
      () => ({ type: 'renamePart', id: this.of(parts).id, name: this.of([...NAMES, ' ', '🍐'.repeat(60)]) }),
      () => ({ type: 'setPartBrush', ids, change: this.change() }),
      () => ({ type: 'showParts', ids, visible: this.chance(0.6) }),
      () => ({ type: 'moveParts', ids, by: { rotation: [0.48, 0.6, 0, 0.64], translation: vector() } }),
      () => ({ type: 'duplicateParts', ids: ids.slice(0, 1), offset: vector() }),
    ];
    const always: readonly (() => Command)[] = [
      () => ({ type: 'addStroke', stroke: this.stroke() }),
      () => ({ type: 'addStroke', stroke: this.stroke() }),
      () => ({ type: 'keep' }),
      () => ({ type: this.of(['drop', 'keep'] as const) }),
      () => ({ type: 'setBrush', change: this.change() }),
      () => ({ type: 'setTubesOnly', on: this.chance(0.5) }),
    ];
    return this.of(parts.length && this.chance(0.5) ? onParts : always)();
  }
}

const toStart = (history: History): History =>
  undoable(history) === null ? history : toStart(undo(history));
const toEnd = (history: History): History => (redoable(history) === null ? history : toEnd(redo(history)));

/** Steps back and forth, until the document has so many commands behind it; a stroke last, so that there is something. */
function walk(seed: number): History {
  const walker = new Walker(seed);
  let history = newHistory();
  while (history.past.length < STEPS - 1) {
    history = commit(history, walker.command(history.present));
    if (walker.chance(0.1)) for (let back = walker.between(0, 6); back > 0; back--) history = undo(history);
    if (walker.chance(0.1)) for (let on = walker.between(0, 6); on > 0; on--) history = redo(history);
    if (walker.chance(0.01)) history = toEnd(toStart(history));
    if (walker.chance(0.002)) history = commit(history, { type: 'removeAll' });
  }
  while (history.past.length > STEPS - 1) history = undo(history);
  return commit(history, { type: 'addStroke', stroke: walker.stroke() });
}

describe('a walk of 500 commands', { timeout: 60_000 }, () => {
  const seeds = Array.from({ length: SEEDS }, (_, i) => i + 1);

  it.each(seeds)('is what its script makes, also through a file (seed %i)', (seed) => {
    const history = walk(seed);
    const drawing = drawingOf(history.present);
    const replayed = parse(serializeScript(scriptOf(history), drawing), 'walk.rotund');
    expect(replayed).toEqual(drawing);
    expect(parse(serialize(drawing), 'walk.rotund')).toEqual(drawing);
    expect(scriptOf(history)).toHaveLength(STEPS);
    const bytes = bytesOf(meshesOf(history.present));
    expect(bytes.length).toBeGreaterThan(0);
    expect(bytesOf(meshesOf(replayed.document))).toEqual(bytes);
    expect(toEnd(toStart(history)).present).toBe(toEnd(history).present);
    expect(toStart(toEnd(history)).present).toBe(newHistory().present);
  });

  it.each(seeds)('goes on from a document that was loaded (seed %i)', (seed) => {
    const first = walk(seed).present;
    const walker = new Walker(seed + 1000);
    let history = commit(newHistory(first), { type: 'setTubesOnly', on: !first.tubesOnly });
    for (let step = 0; step < 50; step++) history = commit(history, walker.command(history.present));
    const drawing = drawingOf(history.present);
    expect(parse(serializeScript(scriptOf(history), drawing), 'walk.rotund')).toEqual(drawing);
    expect(scriptOf(history).reduce(apply, newHistory().present)).toEqual(history.present);
  });
});
