/** Bodies beside the page: drafts before fine ones, what is wanted and nothing else, problems told, no worker left behind. */
import { beforeEach, describe, expect, it } from 'vitest';
import { bodyMade, CELLS, makeBody } from '../../src/document/bodies.ts';
import { Bodies, type BodyWorker, type News } from '../../src/element/bodies.ts';
import { bindField } from '../../src/field/bind.ts';
import type { FromWorker, Make, ToWorker } from '../../src/field/fieldWork.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { polygonize } from '../../src/field/polygonize.ts';

const ball = (radius: number): FieldNode => ({ type: 'shape', shape: { type: 'sphere', radius } });

/** Does nothing until it is told to. */
class FakeWorker implements BodyWorker {
  onmessage: BodyWorker['onmessage'] = null;
  onerror: BodyWorker['onerror'] = null;
  ended = false;
  readonly asked: Make[] = [];

  postMessage(message: ToWorker): void {
    if (message.type === 'make') this.asked.push(message);
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
  answer({ id, node }: Make = this.last, draft = false): void {
    const { mesh, lattice, evaluations } = polygonize(bindField(node), draft ? 16 : 12);
    this.say({ type: 'made', id, draft, mesh, lattice, evaluations, milliseconds: 1 });
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

describe('Bodies', () => {
  it('makes drafts of all before the fine ones, then lets the worker go', async () => {
    const [a, b] = [ball(5), ball(6)];
    bodies.want([a, b, a]);
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

  it('makes what is thin once more, in finer cells, and anew when others are wanted', async () => {
    const node: FieldNode = { type: 'shape', shape: { type: 'box', half: [40, 0.4, 40] } };
    bodies.want([node]);
    for (let i = 0; i < 3; i++) {
      const { id, resolution } = worker().last;
      const { mesh, lattice, evaluations } = polygonize(bindField(node), resolution);
      const rest = { draft: false, hasCreases: true, milliseconds: 1 };
      worker().say({ type: 'made', id, mesh, lattice, evaluations, ...rest });
    }
    await bodies.settled();
    const [, usual, finer] = worker().asked.map(({ resolution }) => resolution);
    expect(usual).toBe(CELLS);
    expect(bodyMade(node)!.cells).toBe(finer);
    expect(bodyMade(node)!.mesh.thin).toBeNull();
    bodies.want([node]);
    expect(bodies.making).toBeNull();
    bodies.want([node], () => 48);
    expect(worker().last.resolution).toBe(48);
  });

  it('asks for nothing that is there', async () => {
    const node = ball(5);
    makeBody(node);
    bodies.want([node]);
    await bodies.settled();
    bodies.want([]);
    expect(workers).toEqual([]);
  });

  it('gives up what nobody wants any more, and shows nothing of it', async () => {
    const [old, young] = [ball(5), ball(6)];
    bodies.want([old]);
    const { last } = worker();
    bodies.want([young]);
    worker().answer(last);
    expect(bodyMade(old)).toBeNull();
    expect(worker().last.node).toBe(young);
    expect(worker().last.id).toBeGreaterThan(last.id);
    bodies.want([]);
    expect(worker().ended).toBe(true);
    await bodies.settled();
  });

  it('does not begin anew when the same is wanted again', () => {
    const [a, b] = [ball(5), ball(6)];
    bodies.want([a]);
    worker().answer();
    bodies.want([a]);
    expect(worker().asked).toHaveLength(2);
    // what nobody has seen yet goes first
    bodies.want([a, b]);
    expect(worker().last).toMatchObject({ node: b });
  });

  it('keeps the last mesh until a finer one is there', () => {
    const node = ball(5);
    bodies.want([node]);
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
    bodies.want([bad, good]);
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
    bodies.want([node]);
    worker().answer();
    worker().answer();
    await bodies.settled();
    expect(bodies.problem(node)).toMatch(/nowhere above 0/);
  });

  it('hears how far the worker is', () => {
    bodies.want([ball(5)]);
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
    alone.want([node]);
    expect(bodyMade(node)).toBeNull();
    await alone.settled();
    expect(bodyMade(node)!.cells).toBe(CELLS);
  });

  it('makes them itself where the worker does not load', { timeout: 30_000 }, async () => {
    const node = ball(5);
    bodies.want([node]);
    worker().onerror?.call({} as Worker, {} as ErrorEvent);
    await bodies.settled();
    expect(bodyMade(node)!.cells).toBe(CELLS);
    expect(worker().ended).toBe(true);
  });

  it('stops when the element leaves', async () => {
    bodies.want([ball(5)]);
    const settled = bodies.settled();
    bodies.stop();
    await settled;
    expect(worker().ended).toBe(true);
  });
});
