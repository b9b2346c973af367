/** The page's side of making bodies, with a worker and a device that do what they are told. */
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { FieldBody } from '../../../src/element/field/fieldBody.ts';
import { FieldOnGpu } from '../../../src/element/field/fieldOnGpu.ts';
import type { FromWorker, Made, ToWorker } from '../../../src/field/fieldWork.ts';
import { latticeOver, nodeCount } from '../../../src/field/lattice.ts';
import type { FieldNode } from '../../../src/field/node.ts';
import { gpuField } from '../../../src/gpu/field.ts';
import { FieldError } from '../../../src/skeleton/skeleton.ts';

vi.mock('../../../src/gpu/field.ts', () => ({ gpuField: vi.fn() }));

class StubWorker {
  static all: StubWorker[] = [];
  readonly told: ToWorker[] = [];
  ended = false;
  onmessage: ((event: { data: FromWorker }) => void) | null = null;

  constructor() {
    StubWorker.all.push(this);
  }

  postMessage(message: ToWorker): void {
    if (!this.ended) this.told.push(message);
  }

  terminate(): void {
    this.ended = true;
  }

  says(data: FromWorker): void {
    if (!this.ended) this.onmessage?.({ data });
  }
}

const lattice = latticeOver(10, 4);
const tree = (radius = 10): FieldNode => ({ type: 'shape', shape: { type: 'sphere', radius } });
const device = {} as GPUDevice;
const settled = () => new Promise((done) => setTimeout(done));
const made = (id: number, draft = false, difference: number | null = null) =>
  ({ type: 'made', id, draft, difference }) as Made;

interface Evaluation {
  resolve(values: Float32Array): void;
  reject(error: Error): void;
}

/** Trees on the device, each evaluation of which waits to be answered. */
const onDevice = {
  update: vi.fn(),
  destroy: vi.fn(),
  evaluations: [] as Evaluation[],
  evaluate(): Promise<Float32Array> {
    return new Promise((resolve, reject) => this.evaluations.push({ resolve, reject }));
  },
  colours: vi.fn(),
};
/** value and gradient, 1 at the first node, 2 at the next … */
const found = () => Float32Array.from({ length: 4 * nodeCount(lattice) }, (_, i) => (i % 4 ? -1 : 1 + i / 4));

let body: FieldBody;
const changed = vi.fn();
const worker = () => StubWorker.all.at(-1)!;
const answers = () => worker().told.filter(({ type }) => type === 'values');

beforeEach(() => {
  StubWorker.all = [];
  vi.stubGlobal('Worker', StubWorker);
  vi.mocked(gpuField).mockReset().mockReturnValue(onDevice);
  for (const spy of [onDevice.update, onDevice.destroy, changed]) spy.mockReset();
  onDevice.evaluations = [];
  body = new FieldBody(changed);
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

describe('values from the device', () => {
  beforeEach(() => {
    body.device = device;
    body.make(tree, 24, true);
  });

  test('are asked for, taken and sent', async () => {
    expect(worker().told).toMatchObject([{ type: 'make', id: 1, values: 'page' }]);
    worker().says({ type: 'wanted', id: 1, lattice });
    onDevice.evaluations[0]!.resolve(found());
    await settled();
    const values = Float32Array.from({ length: nodeCount(lattice) }, (_, i) => 1 + i);
    expect(answers()).toEqual([{ type: 'values', id: 1, values }]);
  });

  test.each([true, false])('the element goes meanwhile: nobody is answered (values: %s)', async (comes) => {
    worker().says({ type: 'wanted', id: 1, lattice });
    body.stop();
    expect(onDevice.destroy).toHaveBeenCalledOnce();
    const warn = vi.spyOn(console, 'warn').mockReturnValue();
    if (comes) onDevice.evaluations[0]!.resolve(found());
    else onDevice.evaluations[0]!.reject(new Error('the device was destroyed'));
    await settled();
    expect(StubWorker.all.map(({ ended }) => ended)).toEqual([true]);
    expect(answers()).toEqual([]);
    expect(warn).not.toHaveBeenCalled();
  });

  test('the element goes and comes back meanwhile: the new worker hears nothing of it', async () => {
    worker().says({ type: 'wanted', id: 1, lattice });
    body.stop();
    body.make(tree, 24, false);
    onDevice.evaluations[0]!.resolve(found());
    await settled();
    expect(StubWorker.all.length).toBe(2);
    expect(answers()).toEqual([]);
  });

  test('another body is wanted meanwhile', async () => {
    worker().says({ type: 'wanted', id: 1, lattice });
    body.make(() => tree(12), 24, true);
    onDevice.evaluations[0]!.resolve(found());
    await settled();
    expect(answers()).toEqual([]);
    worker().says({ type: 'wanted', id: 2, lattice });
    onDevice.evaluations[1]!.resolve(found());
    await settled();
    expect(answers()).toMatchObject([{ id: 2 }]);
    expect(onDevice.update).toHaveBeenCalledOnce();
  });

  test('the device is lost before it is asked: the worker is told, and no one warned', async () => {
    const warn = vi.spyOn(console, 'warn').mockReturnValue();
    body.device = null;
    worker().says({ type: 'wanted', id: 1, lattice });
    await settled();
    expect(answers()).toEqual([{ type: 'values', id: 1, values: null }]);
    expect(warn).not.toHaveBeenCalled();
  });

  test('the device is lost under way: the worker takes its own', async () => {
    const warn = vi.spyOn(console, 'warn').mockReturnValue();
    worker().says({ type: 'wanted', id: 1, lattice });
    body.device = null;
    onDevice.evaluations[0]!.reject(new Error('the device was lost'));
    await settled();
    expect(answers()).toEqual([{ type: 'values', id: 1, values: null }]);
    expect(warn).toHaveBeenCalledOnce();
  });

  test('how far they are off comes with the body they are of', () => {
    worker().says(made(1, false, 1e-5));
    body.make(tree, 24, true);
    expect(body.made?.difference).toBe(1e-5);
    worker().says(made(1, false, 1e-3));
    expect(body.made?.difference).toBe(1e-5);
    worker().says(made(2, false, 2e-5));
    expect(body.made?.difference).toBe(2e-5);
  });
});

describe('what is shown', () => {
  const refuse = () => {
    throw new FieldError('no field');
  };

  test('a tree that is refused: the worker is told to stop, the last body stays', () => {
    body.make(tree, 24, false);
    worker().says(made(1));
    body.make(tree, 24, false);
    body.make(refuse, 24, false);
    expect(worker().told.at(-1)).toEqual({ type: 'stop', id: 3 });
    worker().says(made(2, true));
    worker().says(made(2));
    expect(body).toMatchObject({ made: { id: 1 }, problem: 'no field', progress: null });
    body.make(tree, 24, false);
    worker().says(made(4));
    expect(body).toMatchObject({ made: { id: 4 }, problem: null });
  });

  test('a tree that is refused first of all starts no worker', () => {
    body.make(refuse, 24, false);
    expect(StubWorker.all).toEqual([]);
    expect(body).toMatchObject({ made: null, problem: 'no field' });
  });

  test('drafts follow a slider, whole bodies only of the latest tree', () => {
    body.make(tree, 64, false);
    body.make(tree, 64, false);
    worker().says(made(1, true));
    expect(body).toMatchObject({ made: { id: 1 }, progress: 0 });
    worker().says(made(1));
    expect(body.made?.draft).toBe(true);
    worker().says({ type: 'progress', id: 1, share: 0.5 });
    expect(body.progress).toBe(0);
    worker().says(made(2));
    expect(body).toMatchObject({ made: { id: 2, draft: false }, progress: null });
  });
});

describe('trees on the device', () => {
  test('one is bound once, and taken again as long as it is the same', async () => {
    const gpu = new FieldOnGpu(device);
    const [first, second] = [tree(), tree(12)];
    for (const node of [first, first, second, second, first]) void gpu.values(node, lattice);
    expect(gpuField).toHaveBeenCalledOnce();
    expect(onDevice.update.mock.calls).toEqual([[second], [first]]);
  });

  test('one that is refused is tried again', async () => {
    const gpu = new FieldOnGpu(device);
    void gpu.values(tree(), lattice);
    onDevice.update.mockImplementation(refuseAll);
    const bad = tree(-1);
    for (let i = 0; i < 2; i++) await expect(gpu.values(bad, lattice)).rejects.toThrow('no field');
  });
});

function refuseAll(): never {
  throw new FieldError('no field');
}
