/** Bodies beside the page: drafts before fine ones, what is wanted and nothing else, problems told, no worker left behind. */
import { beforeEach, describe, expect, it } from 'vitest';
import { type Body, bodyMade, CELLS, makeBody } from '../../src/document/bodies.ts';
import { Bodies, type BodyWorker, type News } from '../../src/element/bodies.ts';
import { bindField } from '../../src/field/bind.ts';
import type { FromWorker, Make, ToWorker } from '../../src/field/fieldWork.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { polygonize } from '../../src/field/polygonize.ts';

const ball = (radius: number): FieldNode => ({ type: 'shape', shape: { type: 'sphere', radius } });

const FACTS = { milliseconds: 1, isEdit: false };

/** Each under a name of its own. */
const seen = (...nodes: FieldNode[]) => nodes.map((node, i) => ({ id: `part-${i}`, node }));

/** Does nothing until it is told to. */
class FakeWorker implements BodyWorker {
  onmessage: BodyWorker['onmessage'] = null;
  onerror: BodyWorker['onerror'] = null;
  ended = false;
  readonly asked: Make[] = [];
  readonly stopped: number[] = [];

  postMessage(message: ToWorker): void {
    if (message.type === 'make') this.asked.push(message);
    else this.stopped.push(message.id);
  }
  terminate(): void {
    this.ended = true;
  }
  get last(): Make {
    return this.asked.at(-1)!;
  }
  say(message: FromWorker): void {
    this.onmessage?.call({} as Worker, { data: message } as MessageEvent<FromWorker>);
  }
  /** Answers what was asked last, in fewer cells than that, which nobody here sees. */
  answer({ id, node }: Make = this.last, draft = false, more = {}): void {
    const { mesh, lattice, evaluations } = polygonize(bindField(node), draft ? 16 : 12);
    this.say({ type: 'made', id, draft, mesh, lattice, evaluations, ...FACTS, ...more });
  }
}

let workers: FakeWorker[];
let news: News[];
let bodies: Bodies;
const worker = () => workers.at(-1)!;

beforeEach(() => {
  workers = [];
  news = [];
  bodies = new Bodies(
    (what) => void news.push(what),
    () => {
      workers.push(new FakeWorker());
      return worker();
    },
  );
});

/** As files have to be. */
const isExact = (body: Body | null) => body !== null && body.cells === CELLS && !body.isEdit;

describe('Bodies', () => {
  it('makes drafts of all before the fine ones, then lets the worker go', async () => {
    const [a, b] = [ball(5), ball(6)];
    bodies.expectsEdits = false;
    bodies.want(seen(a, b, a));
    const settled = bodies.settled();
    expect(bodies.drafted).toBe(false);
    worker().answer();
    expect(bodies.drafted).toBe(false);
    worker().answer();
    expect(bodies.drafted).toBe(true);
    expect(worker().ended).toBe(false);
    worker().answer();
    worker().answer();
    await settled;
    expect(worker().asked.map(({ node }) => node)).toEqual([a, b, a, b]);
    const cells = worker().asked.map(({ resolution }) => resolution);
    expect(cells[0]).toBeLessThan(CELLS);
    expect(cells).toEqual([cells[0], cells[0], CELLS, CELLS]);
    expect(worker().ended).toBe(true);
    expect(bodies.making).toBeNull();
    expect(bodyMade(a)!.cells).toBe(CELLS);
  });

  it('finishes a draft of what moves, which stands in for what it has become, and makes nothing finer until it rests', () => {
    const nodes = [5, 6, 7, 8].map(ball);
    const rough = { isRough: true };
    const at = (i: number) => [{ id: 'part-1', node: nodes[i]! }];
    bodies.want(at(0), undefined, rough);
    bodies.want(at(1), undefined, rough);
    bodies.want(at(2), undefined, rough);
    expect(worker().asked).toHaveLength(1);
    worker().answer();
    expect(bodyMade(nodes[2]!)).toMatchObject({ cells: 0, mesh: bodyMade(nodes[0]!)!.mesh });
    expect(worker().asked.map(({ node }) => node)).toEqual([nodes[0], nodes[2]]);
    bodies.want(at(3), undefined, rough);
    worker().answer();
    worker().answer();
    const cells = worker().asked.map(({ resolution }) => resolution);
    expect(cells).toEqual([cells[0], cells[0], cells[0]]);
    expect(bodies.making).toBeNull();
    bodies.want(at(3));
    expect(worker().last).toMatchObject({ node: nodes[3], resolution: CELLS });
  });

  it('makes what is thin once more, in finer cells, and anew when others are wanted', async () => {
    const node: FieldNode = { type: 'shape', shape: { type: 'box', half: [40, 0.4, 40] } };
    bodies.want(seen(node));
    for (let i = 0; i < 3; i++) {
      const { id, resolution } = worker().last;
      const { mesh, lattice, evaluations } = polygonize(bindField(node), resolution);
      worker().say({ type: 'made', id, draft: false, mesh, lattice, evaluations, ...FACTS });
    }
    await bodies.settled();
    const [, usual, finer] = worker().asked.map(({ resolution }) => resolution);
    expect(usual).toBe(CELLS);
    expect(bodyMade(node)!.cells).toBe(finer);
    expect(bodyMade(node)!.mesh.thin).toBeNull();
    bodies.want(seen(node));
    expect(bodies.making).toBeNull();
    bodies.want(seen(node), () => 48);
    expect(worker().last.resolution).toBe(48);
  });

  it('asks for nothing that is there', async () => {
    const node = ball(5);
    makeBody(node);
    bodies.want(seen(node));
    await bodies.settled();
    bodies.want(seen());
    expect(workers).toEqual([]);
  });

  it('gives up what nobody wants any more, and shows nothing of it', async () => {
    const [old, young] = [ball(5), ball(6)];
    bodies.want(seen(old));
    const { last } = worker();
    bodies.want(seen(young));
    worker().answer(last);
    expect(bodyMade(old)).toBeNull();
    expect(worker().last.node).toBe(young);
    expect(worker().last.id).toBeGreaterThan(last.id);
    bodies.want(seen());
    expect(worker().ended).toBe(true);
    await bodies.settled();
  });

  it('does not begin anew when the same is wanted again', () => {
    const [a, b] = [ball(5), ball(6)];
    bodies.want(seen(a));
    worker().answer();
    bodies.want(seen(a));
    expect(worker().asked).toHaveLength(2);
    // what nobody has seen yet goes first
    bodies.want(seen(a, b));
    expect(worker().last).toMatchObject({ node: b });
  });

  it('keeps the last mesh until a finer one is there', () => {
    const node = ball(5);
    bodies.want(seen(node));
    worker().answer();
    const draft = bodyMade(node)!;
    worker().answer(worker().last, true);
    const finer = bodyMade(node)!;
    expect(finer.mesh.indices.length).toBeGreaterThan(draft.mesh.indices.length);
    expect(finer.cells).toBe(draft.cells);
    expect(bodies.making).toBe(node);
  });

  it('tells of what cannot be made and goes on with the next', async () => {
    const [bad, good] = [ball(5), ball(6)];
    bodies.want(seen(bad, good));
    worker().say({ type: 'refused', id: worker().last.id, message: 'no room' });
    expect(bodies.problem(bad)).toBe('no room');
    worker().answer();
    expect(bodies.drafted).toBe(true);
    worker().answer();
    await bodies.settled();
    expect(worker().asked.map(({ node }) => node)).toEqual([bad, good, good]);
    expect(news).toContain('made');
  });

  it('says that a body has no surface', async () => {
    const node: FieldNode = { type: 'subtraction', form: 'hard', parts: [ball(3), ball(5)] };
    bodies.want(seen(node));
    worker().answer();
    worker().answer();
    await bodies.settled();
    expect(bodies.problem(node)).toMatch(/nowhere above 0/);
  });

  it('hears how far the worker is', () => {
    bodies.want(seen(ball(5)));
    worker().say({ type: 'progress', id: worker().last.id, share: 0.4 });
    expect(bodies.share).toBe(0.4);
    expect(news).toEqual(['progress']);
  });

  it('makes them itself where no worker starts', { timeout: 30_000 }, async () => {
    const node = ball(5);
    const alone = new Bodies(
      () => {},
      () => {
        throw new Error('not allowed');
      },
    );
    alone.want(seen(node));
    expect(bodyMade(node)).toBeNull();
    await alone.settled();
    expect(bodyMade(node)!.cells).toBe(CELLS);
  });

  it('makes them itself where the worker does not load', { timeout: 30_000 }, async () => {
    const node = ball(5);
    bodies.want(seen(node));
    worker().onerror?.call({} as Worker, {} as ErrorEvent);
    await bodies.settled();
    expect(bodyMade(node)!.cells).toBe(CELLS);
    expect(worker().ended).toBe(true);
  });

  it('keeps the worker and the names of bodies for edits', async () => {
    const [a, b] = [ball(5), ball(6)];
    bodies.want(seen(a, b));
    for (let i = 0; i < 4; i++) worker().answer();
    await bodies.settled();
    expect(worker().ended).toBe(false);
    expect(worker().asked.map(({ name }) => name)).toEqual([null, null, 'part-0', 'part-1']);
    bodies.want([]);
    expect(worker().ended).toBe(true);
  });

  describe('after an edit', () => {
    const row = (last: number): FieldNode => ({
      type: 'union',
      form: 'hard',
      parts: [...Array.from({ length: 7 }, (_, i) => ball(i + 1)), ball(last)],
    });
    const edited = (last: number) => {
      const node = row(last);
      bodies.want(seen(node));
      return node;
    };

    it('shows what was there until the edit is made, and asks for no draft of it', async () => {
      const before = edited(9);
      worker().answer();
      worker().answer();
      await bodies.settled();
      const { mesh } = bodyMade(before)!;
      const after = edited(10);
      expect(bodyMade(after)).toMatchObject({ cells: 0, mesh });
      expect(worker().last).toMatchObject({ node: after, resolution: CELLS, name: 'part-0' });
      worker().answer();
      expect(bodyMade(after)!.cells).toBe(CELLS);
      expect(bodyMade(after)!.mesh).not.toBe(mesh);
      // undo: the very tree that there was
      bodies.want(seen(before));
      expect(bodies.making).toBeNull();
    });

    it('shows an edit that comes late in place of what is older still', () => {
      edited(9);
      worker().answer();
      worker().answer();
      const first = edited(10);
      const { last } = worker();
      const second = edited(11);
      const old = bodyMade(second)!.mesh;
      worker().answer(last, false, { isEdit: true });
      expect(bodyMade(first)).toMatchObject({ cells: CELLS, isEdit: true });
      expect(bodyMade(second)).toMatchObject({ cells: 0, mesh: bodyMade(first)!.mesh });
      expect(bodyMade(second)!.mesh).not.toBe(old);
      expect(bodies.making).toBe(second);
    });

    it('shows it also where two more followed', () => {
      edited(9);
      worker().answer();
      worker().answer();
      const first = edited(10);
      const { last } = worker();
      edited(11);
      const third = edited(12);
      worker().answer(last, false, { isEdit: true });
      expect(bodyMade(third)).toMatchObject({ cells: 0, mesh: bodyMade(first)!.mesh });
    });

    it('tells the worker to stop what nobody wants any more', () => {
      const before = edited(9);
      worker().answer();
      worker().answer();
      edited(10);
      const { last } = worker();
      bodies.want([{ id: 'part-0', node: before }]);
      expect(bodies.making).toBeNull();
      expect(worker().stopped.at(-1)).toBeGreaterThan(last.id);
    });

    it('shows nothing of another body in its place, nor of one that cannot be made', () => {
      edited(9);
      worker().answer();
      worker().answer();
      const other: FieldNode = {
        type: 'affine',
        matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0],
        node: ball(3),
      };
      bodies.want(seen(other));
      expect(bodyMade(other)).toBeNull();
      bodies.want(seen(row(9)));
      bodies.forget();
      const loaded = edited(12);
      expect(bodyMade(loaded)).toBeNull();
      worker().answer();
      worker().answer();
      const bad = edited(9.5);
      worker().say({ type: 'refused', id: worker().last.id, message: 'no room' });
      expect(bodyMade(bad)).toBeNull();
    });
  });

  describe('for a file', () => {
    it('waits until each is made at once, whatever is seen', async () => {
      const [a, b] = [ball(5), ball(6)];
      bodies.want(seen(a));
      worker().answer();
      worker().answer(worker().last, false, { isEdit: true });
      expect(isExact(bodyMade(a))).toBe(false);
      const shares: number[] = [];
      const exact = bodies.exactly([a, b], { progress: (share) => void shares.push(share) });
      expect(worker().last).toMatchObject({ node: a, resolution: CELLS, name: null });
      worker().say({ type: 'progress', id: worker().last.id, share: 0.5 });
      // gone from the page
      bodies.stop();
      worker().answer();
      worker().answer(worker().last, true);
      worker().answer();
      await exact;
      expect([a, b].map((node) => isExact(bodyMade(node)))).toEqual([true, true]);
      expect(shares).toEqual(shares.toSorted());
      expect(shares).toContain(0.25);
      expect(shares.at(-1)).toBe(1);
      expect(worker().ended).toBe(true);
    });

    it('takes what is under way, and what is there', async () => {
      const node = ball(5);
      bodies.want(seen(node));
      worker().answer();
      const exact = bodies.exactly([node]);
      expect(worker().asked).toHaveLength(2);
      worker().answer();
      await exact;
      await bodies.exactly([node]);
      expect(worker().asked).toHaveLength(2);
    });

    it('is given up when told so', async () => {
      const abort = new AbortController();
      const exact = bodies.exactly([ball(5)], { signal: abort.signal });
      expect(bodies.making).not.toBeNull();
      abort.abort();
      await expect(exact).rejects.toThrow('aborted');
      expect(bodies.making).toBeNull();
      expect(worker().ended).toBe(true);
      await expect(bodies.exactly([ball(5)], { signal: abort.signal })).rejects.toThrow('aborted');
    });

    it('does not wait for what cannot be made', async () => {
      const exact = bodies.exactly([ball(5)]);
      worker().say({ type: 'refused', id: worker().last.id, message: 'no room' });
      await exact;
    });
  });

  it('stops when the element leaves', async () => {
    bodies.want(seen(ball(5)));
    const settled = bodies.settled();
    bodies.stop();
    await settled;
    expect(worker().ended).toBe(true);
  });
});
