/** What waits for the graphics device: the latest, and all edits of a body that is kept there, in their order. */
import { beforeEach, expect, test, vi } from 'vitest';
import { FieldOnGpu, type MadeOnGpu } from '../../../src/element/field/fieldOnGpu.ts';
import type { Located } from '../../../src/field/fieldWork.ts';
import type { FieldNode } from '../../../src/field/node.ts';
import type { PackedBricks, PackedEdit } from '../../../src/field/packedBricks.ts';
import type { GpuMesh } from '../../../src/gpu/polygonize/gpuMesh.ts';
import type { LivePolygonizer } from '../../../src/gpu/polygonize/livePolygonizer.ts';
import type { GpuPolygonizer } from '../../../src/gpu/polygonize/polygonizer.ts';

const node = (radius: number): FieldNode => ({ type: 'shape', shape: { type: 'sphere', radius } });
const lattice = { origin: [0, 0, 0], step: 1, counts: [5, 5, 5] } as const;
const all = {
  lattice,
  count: 0,
  hasCreases: false,
  grid: new Int32Array(1),
  lists: new Uint32Array(4),
} satisfies PackedBricks;
const edit = {
  grid: all.grid,
  hasCreases: false,
  renewed: new Uint32Array(0),
  lists: all.lists,
} satisfies PackedEdit;

const located = (id: number, bricks: Located['bricks'], isKept: boolean): Located => ({
  type: 'bricks',
  id,
  node: node(id),
  bricks,
  isKept,
  lattice,
  box: { min: [0, 0, 0], max: [1, 1, 1] },
  draft: !isKept,
  evaluations: 0,
  milliseconds: 0,
  workAVertex: 0,
});

let asked: string[];
let open: (() => void)[];
let fail: boolean;
const made: number[] = [];
const failed: number[] = [];

/** Does one after the other when told to. */
function mesh(what: string): Promise<GpuMesh> {
  asked.push(what);
  return new Promise((resolve, reject) => {
    const done = { needed: async () => ({ vertices: 1, triangles: 1 }), destroy: vi.fn() };
    open.push(() => (fail ? reject(new Error('no')) : resolve(done as unknown as GpuMesh)));
  });
}
const radius = (of: FieldNode) => (of.type === 'shape' && of.shape.type === 'sphere' ? of.shape.radius : 0);
const polygonizer = {
  whole: (of: FieldNode) => mesh(`draft ${radius(of)}`),
  destroy: vi.fn(),
} as unknown as GpuPolygonizer;
const live = {
  whole: (of: FieldNode) => mesh(`whole ${radius(of)}`),
  edit: (of: FieldNode, edits: readonly PackedEdit[]) => mesh(`${edits.length} edits to ${radius(of)}`),
  destroy: vi.fn(),
} as unknown as LivePolygonizer;

async function finish(): Promise<void> {
  while (open.length > 0) {
    open.shift()!();
    await new Promise((done) => setTimeout(done));
  }
}

let device: FieldOnGpu;
beforeEach(() => {
  asked = [];
  open = [];
  fail = false;
  made.length = 0;
  failed.length = 0;
  device = new FieldOnGpu(polygonizer, live, {
    made: ({ of }: MadeOnGpu) => void made.push(of.id),
    failed: ({ id }) => void failed.push(id),
  });
});

test('of drafts that wait only the latest is made', async () => {
  for (const id of [1, 2, 3]) device.make(located(id, all, false));
  await finish();
  expect(asked).toEqual(['draft 1', 'draft 3']);
  expect(made).toEqual([1, 3]);
});

test('edits that wait are made at once, and none is left out', async () => {
  device.make(located(1, all, true));
  for (const id of [2, 3, 4]) device.make(located(id, edit, true));
  await finish();
  expect(asked).toEqual(['whole 1', '3 edits to 4']);
  expect(made).toEqual([1, 4]);
});

test('a draft between does not take the bricks from edits that follow', async () => {
  device.make(located(1, all, false));
  device.make(located(2, all, true));
  device.make(located(3, edit, true));
  device.make(located(4, all, false));
  device.make(located(5, edit, true));
  await finish();
  expect(asked).toEqual(['draft 1', 'whole 2', '2 edits to 5', 'draft 4']);
  expect(made).toEqual([1, 5, 4]);
});

test('all bricks anew stand for the edits before them', async () => {
  device.make(located(1, all, false));
  device.make(located(2, edit, true));
  device.make(located(3, all, true));
  await finish();
  expect(asked).toEqual(['draft 1', 'whole 3']);
});

test('who fails is told, and who has left hears nothing', async () => {
  fail = true;
  device.make(located(1, edit, true));
  await finish();
  expect(failed).toEqual([1]);
  fail = false;
  device.make(located(2, all, true));
  device.destroy();
  await finish();
  expect(made).toEqual([]);
});
