/** The page's side of making bodies, with a worker and a device that do what they are told. */
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { FieldBody } from '../../../src/element/field/fieldBody.ts';
import type { FieldMesh } from '../../../src/field/brickMesh.ts';
import type { FromWorker, ToWorker } from '../../../src/field/fieldWork.ts';
import { latticeOver } from '../../../src/field/lattice.ts';
import type { FieldNode } from '../../../src/field/node.ts';
import type { GpuMesh } from '../../../src/gpu/polygonize/gpuMesh.ts';
import { type GpuPolygonizer, gpuPolygonizer } from '../../../src/gpu/polygonize/polygonizer.ts';
import { FieldError } from '../../../src/skeleton/skeleton.ts';

vi.mock('../../../src/gpu/polygonize/polygonizer.ts', () => ({ gpuPolygonizer: vi.fn() }));

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

/** Three vertices, so many triangles. */
function arrays(triangles = 1): FieldMesh {
  const three = new Float32Array(9);
  const indices = new Uint32Array(3 * triangles);
  return { positions: three, normals: three, colours: three, uvs: new Float32Array(6), indices };
}
const step = { evaluations: 100, milliseconds: 7, isEdit: false };
const made = (id: number, draft = false): FromWorker =>
  ({ type: 'made', id, draft, mesh: arrays(), lattice, ...step }) as const;
const bricks = (id: number, draft = false): FromWorker => ({
  type: 'bricks',
  id,
  draft,
  node: tree(id),
  bricks: { lattice, count: 1, hasCreases: false, grid: new Int32Array(1), lists: new Uint32Array(4) },
  isKept: false,
  lattice,
  box: { min: [-id, 0, 0], max: [id, 1, 1] },
  workAVertex: 10,
  ...step,
});

interface Asked {
  readonly node: FieldNode;
  readonly mesh: GpuMesh & { readonly destroy: ReturnType<typeof vi.fn> };
  resolve(): void;
  reject(error: Error): void;
}

/** What the device was asked for, each of which waits to be answered. */
let asked: Asked[] = [];
const destroyed = vi.fn();

function polygonizer(): GpuPolygonizer {
  const whole = (node: FieldNode) =>
    new Promise<GpuMesh>((resolve, reject) => {
      const needed = async () => ({ vertices: 30, triangles: 50, bricks: [], work: 20 });
      const mesh = { draw: {}, needed, destroy: vi.fn() } as unknown as Asked['mesh'];
      asked.push({ node, mesh, resolve: () => resolve(mesh), reject });
    });
  const meshOf = () => Promise.reject(new Error('not edited here'));
  return { whole, polygonize: whole, meshOf, destroy: destroyed };
}

let body: FieldBody;
const changed = vi.fn();
const worker = () => StubWorker.all.at(-1)!;

beforeEach(() => {
  StubWorker.all = [];
  asked = [];
  vi.stubGlobal('Worker', StubWorker);
  vi.mocked(gpuPolygonizer).mockReset().mockImplementation(polygonizer);
  for (const spy of [changed, destroyed]) spy.mockReset();
  body = new FieldBody(changed);
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

describe('meshes on the device', () => {
  /** The `at`-th that was asked for is there. */
  async function answered(at: number): Promise<void> {
    asked[at]!.resolve();
    await settled();
  }

  beforeEach(() => {
    body.device = device;
    body.make(tree, 24, true);
  });

  test('are made of the bricks of the worker, and shown with what both took', async () => {
    expect(worker().told).toMatchObject([{ type: 'make', id: 1, mesh: 'page' }]);
    worker().says(bricks(1));
    expect(asked[0]!.node).toEqual(tree(1));
    expect(body).toMatchObject({ made: null, progress: 0 });
    await answered(0);
    expect(body).toMatchObject({ made: { id: 1, vertices: 30, triangles: 50 }, progress: null });
    expect(body.made).toMatchObject({ mesh: { box: { min: [-1, 0, 0] } }, evaluations: 100 + 20 + 10 * 30 });
    expect(body.made!.maker).toContain('GPU');
  });

  test('the one before goes when the scene has the next, and not earlier', async () => {
    worker().says(bricks(1, true));
    await answered(0);
    worker().says(bricks(1));
    expect(asked[0]!.mesh.destroy).not.toHaveBeenCalled();
    const seen: number[] = [];
    changed.mockImplementation(() => seen.push(asked[0]!.mesh.destroy.mock.calls.length));
    await answered(1);
    expect(seen).toEqual([0]);
    expect(asked.map(({ mesh }) => mesh.destroy.mock.calls.length)).toEqual([1, 0]);
    // the next is the worker's
    worker().says(made(1));
    expect(asked[1]!.mesh.destroy).toHaveBeenCalledOnce();
  });

  test('one after the other, and of those that wait only the latest', async () => {
    worker().says(bricks(1, true));
    body.make(() => tree(2), 24, true);
    worker().says(bricks(2, true));
    worker().says(bricks(2));
    expect(asked.length).toBe(1);
    await answered(0);
    expect(body.made).toMatchObject({ id: 1, draft: true });
    expect(asked.map(({ node }) => node)).toEqual([tree(1), tree(2)]);
    await answered(1);
    expect(body.made).toMatchObject({ id: 2, draft: false });
  });

  test('what is no longer wanted is given back unseen', async () => {
    worker().says(bricks(1));
    body.make(() => tree(2), 24, true);
    await answered(0);
    expect(body.made).toBeNull();
    expect(asked[0]!.mesh.destroy).toHaveBeenCalledOnce();
  });

  test('a draft that comes after the whole body is not shown', async () => {
    worker().says(bricks(1, true));
    worker().says(made(1));
    await answered(0);
    expect(body.made).toMatchObject({ id: 1, draft: false });
    expect(body.made!.maker).toMatch(/worker/);
    expect(asked[0]!.mesh.destroy).toHaveBeenCalledOnce();
  });

  test('the element goes meanwhile: nobody hears of it', async () => {
    worker().says(bricks(1));
    changed.mockReset();
    body.stop();
    expect(destroyed).toHaveBeenCalledOnce();
    await answered(0);
    expect(body.made).toBeNull();
    expect(changed).not.toHaveBeenCalled();
    expect(asked[0]!.mesh.destroy).toHaveBeenCalledOnce();
    expect(StubWorker.all.map(({ ended }) => ended)).toEqual([true]);
  });

  test('the element goes and comes back: what was on the device is made again', async () => {
    worker().says(bricks(1));
    await answered(0);
    body.stop();
    expect(body.made).toBeNull();
    expect(asked[0]!.mesh.destroy).toHaveBeenCalledOnce();
    body.make(tree, 24, false);
    expect(StubWorker.all.length).toBe(2);
  });

  test('the device cannot: the worker makes it, and that is told', async () => {
    const warn = vi.spyOn(console, 'warn').mockReturnValue();
    worker().says(bricks(1));
    asked[0]!.reject(new Error('no memory'));
    await settled();
    expect(warn).toHaveBeenCalledOnce();
    expect(worker().told.at(-1)).toMatchObject({ type: 'make', id: 2, node: tree(), mesh: 'worker' });
    worker().says(made(2));
    expect(body.made!.maker).toMatch(/worker.*could not/);
    // the next is the device's again
    body.make(tree, 24, true);
    expect(worker().told.at(-1)).toMatchObject({ id: 3, mesh: 'page' });
  });

  test.each(['under way', 'shown'])(
    'the device is lost while a body is %s: the worker makes it',
    async (when) => {
      worker().says(bricks(1));
      if (when === 'shown') await answered(0);
      body.device = null;
      expect(body.made).toBeNull();
      expect(worker().told.at(-1)).toMatchObject({ type: 'make', id: 2, mesh: 'worker' });
      worker().says(made(2));
      expect(body.made!.maker).toMatch(/worker.*no graphics device/);
      if (when === 'under way') await answered(0);
      expect(body.made).toMatchObject({ id: 2 });
      body.device = device;
      body.make(tree, 24, true);
      expect(worker().told.at(-1)).toMatchObject({ id: 3, mesh: 'page' });
    },
  );
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
    expect(body).toMatchObject({ made: { id: 2, draft: false, vertices: 3, triangles: 1 }, progress: null });
    expect(body.made!.maker).toBe('CPU, worker');
  });
});
