/** Rays on the device against the CPU's, pixel by pixel: hits, places, normals, colours. */
import { afterAll, expect, it } from 'vitest';
import { bindField } from '../../../src/field/bind.ts';
import type { FieldNode } from '../../../src/field/node.ts';
import { locating } from '../../../src/field/polygonize.ts';
import { NOWHERE, type RayCamera, type RayImage } from '../../../src/field/rayImage.ts';
import { emptyImage, raycasting, SceneCaster } from '../../../src/field/rayScene.ts';
import type { Warp } from '../../../src/field/warp.ts';
import { castsOnDevice } from '../../../src/gpu/raycast/castsOnDevice.ts';
import { type GpuRaycaster, gpuRaycaster, type PlacedBody } from '../../../src/gpu/raycast/raycaster.ts';
import { type Placement, UNMOVED } from '../../../src/math/placement.ts';
import { sceneNode } from '../../bench/scenes/index.ts';
import { carvedTree } from '../../bench/scenes/trees.ts';
import { finished } from '../../field/finished.ts';
import { Lot } from '../../field/lot.ts';
import { shape } from '../../field/meshes.ts';
import { randomTree } from '../../field/randomTrees.ts';
import { body, placed, sphere } from '../../field/trees.ts';
import { widths } from '../../field/widths.ts';
import { withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';

afterAll(closeDawn);

const PIXELS = 48;

const camera = (height: number, fov = 30): RayCamera => ({
  view: { pivot: [0, 0, 0], rotation: [0.1, 0.2, 0, 0.9746794], height, fov },
  width: PIXELS,
  height: PIXELS,
  offset: [0.5, 0.5],
});

interface Compared {
  hits: number;
  /** hits of one only */
  either: number;
  /** of the height, of unit normals, of colours; of those hits that both have, all but the worst 2 % */
  apart: number;
  normal: number;
  colour: number;
}

function compared(a: RayImage, b: RayImage, height: number): Compared {
  const found = { hits: 0, either: 0 };
  const apart: number[] = [];
  const normal: number[] = [];
  const colour: number[] = [];
  const off = (x: Float32Array, y: Float32Array, at: number) =>
    Math.max(...[0, 1, 2].map((k) => Math.abs(x[at + k]! - y[at + k]!)));
  for (let at = 0; at < a.surface.length; at += 4) {
    const [isA, isB] = [a.surface[at + 3] !== NOWHERE, b.surface[at + 3] !== NOWHERE];
    if (isA !== isB) found.either++;
    if (!isA || !isB) continue;
    found.hits++;
    apart.push(Math.abs(a.surface[at + 3]! - b.surface[at + 3]!) / height);
    normal.push(off(a.surface, b.surface, at));
    colour.push(off(a.colours, b.colours, at));
  }
  const most = (of: number[]) => of.sort((x, y) => x - y)[Math.floor(0.98 * (of.length - 1))] ?? 0;
  return { ...found, apart: most(apart), normal: most(normal), colour: most(colour) };
}

const located = (node: FieldNode, cells: number) => finished(locating(bindField(node), cells));

async function compare(node: FieldNode, cells: number, of: RayCamera): Promise<Compared> {
  const found = located(node, cells);
  const cpu = finished(raycasting(found, of));
  return withCaster(async (caster) => {
    const body = await caster.body(node, found.bricks);
    const { image } = await castBy(caster, [{ body, placement: UNMOVED }], of);
    body.destroy();
    return compared(cpu, image, of.view.height);
  });
}

const withCaster = <T>(use: (caster: GpuRaycaster, device: GPUDevice) => Promise<T>): Promise<T> =>
  withDevice(async (device) => {
    const caster = await gpuRaycaster(device);
    try {
      return await use(caster, device);
    } finally {
      caster.destroy();
    }
  });

/** In bands of so many rows. */
async function castBy(caster: GpuRaycaster, bodies: readonly PlacedBody[], of: RayCamera, rows = of.height) {
  const image = caster.image(of.width, of.height);
  for (let row = 0; row < of.height; row += rows)
    caster.cast(image, bodies, of, row, Math.min(row + rows, of.height));
  const [read, work] = [await image.read(), await image.work()];
  image.destroy();
  return { image: read, work };
}

const two: FieldNode = {
  type: 'union',
  form: 'smooth',
  parts: [
    placed(sphere(6), -4, 0, 0),
    body([{ skel: { type: 'point', at: [5, 0, 0], weight: 6 }, colour: [1, 0, 0] }]),
  ],
};
const cut: FieldNode = {
  type: 'subtraction',
  form: 'hard',
  parts: [
    shape({ type: 'box', half: [7, 5, 6] }),
    placed(sphere(5), 6, 5, 5),
    placed(shape({ type: 'torus', ring: 5, tube: 1.5 }), -3, 0, 5),
  ],
};
const blend: FieldNode = {
  type: 'blend',
  a: placed(sphere(5), -4, 0, 0),
  b: placed(sphere(4), 5, 0, 0),
  a0: 1.5,
  a1: 2,
  a2: 2,
};

const LOBES = Array.from({ length: 24 }, (_, i) => 1 + 0.15 * (i % 3));
const eggs: FieldNode = {
  type: 'subtraction',
  form: 'hard',
  parts: [
    shape({ type: 'ellipsoid', radii: [4, 8, 6] }),
    placed(shape({ type: 'ellipsoid', radii: [5, 2, 3] }), 3, 2, 4),
  ],
};
const sectioned = (section: Warp['section'], kernel: 'cauchy' | 'quartic' = 'cauchy'): FieldNode => ({
  type: 'skels',
  kernel,
  params: kernel === 'cauchy' ? { s: 0.4 } : { R: 6 },
  threshold: 1,
  skels: [
    {
      skel: { type: 'segment', a: [-6, 0, 0], b: [6, 1, 0], radii: [3, 2] },
      warp: { section, scale: [1, 1.6], up: [0, 0, 1] },
    },
    { skel: { type: 'point', at: [0, 5, 2], radius: 2 } },
  ],
});

describeGpu('rays on the device are those of the CPU', () => {
  it.each([
    ['16 segments, in perspective', sceneNode('tree16'), 64, camera(2.2)],
    ['64 segments, orthographic', sceneNode('tree64'), 128, camera(2.2, 0)],
    ['carved', carvedTree(), 96, camera(2)],
    ['a smooth union with colours', two, 48, camera(26)],
    ['a box less a sphere and a torus', cut, 48, camera(24)],
    ['a blend', blend, 48, camera(26)],
    ['from within', sphere(10), 32, camera(2, 100)],
    ['an oval section', sectioned({ type: 'round' }), 48, camera(24)],
    [
      'a squarish section, finite support',
      sectioned({ type: 'superQuadric', exponent: 4 }, 'quartic'),
      48,
      camera(24),
    ],
    ['a drawn section', sectioned({ type: 'polar', radii: LOBES }), 48, camera(24, 0)],
    ['an egg less another', eggs, 48, camera(24)],
    ['terms with widths of their own', widths('quartic'), 48, camera(50)],
  ] as const)('%s', async (_, node, cells, of) => {
    const { hits, either, apart, normal, colour } = await compare(node, cells, of);
    expect(hits).toBeGreaterThan(50);
    // a ray that only just touches is either
    expect(either).toBeLessThanOrEqual(Math.ceil(0.01 * hits));
    expect(apart).toBeLessThan(1e-5);
    expect(normal).toBeLessThan(2e-3);
    expect(colour).toBeLessThan(2e-3);
  });

  it('bodies cover each other, and where nothing is nothing is written', async () => {
    const nodes = [placed(sphere(4), 0, 0, 3), placed(sphere(6), 0, 0, -3)];
    const of = camera(20);
    const union: FieldNode = { type: 'union', form: 'hard', parts: nodes };
    const whole = finished(raycasting(located(union, 48), of));
    await withCaster(async (caster) => {
      const bodies = await Promise.all(nodes.map((node) => caster.body(node, located(node, 32).bricks)));
      const standing = bodies.map((body) => ({ body, placement: UNMOVED }));
      for (const order of [standing, [...standing].reverse()]) {
        const { image } = await castBy(caster, order, of);
        const { hits, either, apart } = compared(whole, image, 20);
        expect(hits).toBeGreaterThan(100);
        expect(either).toBeLessThanOrEqual(2);
        expect(apart).toBeLessThan(1e-5);
      }
      const none = await castBy(caster, [], of);
      expect(none.image.surface.filter((_, i) => i % 4 === 3).every((x) => x === NOWHERE)).toBe(true);
      expect(none.work).toEqual({ terms: 0, lost: 0 });
    });
  });

  it('bodies that were put somewhere, whose bricks the device finds: places, normals, colours, numbers', async () => {
    const placements: readonly Placement[] = [
      { rotation: [0.5, 0, 0, Math.sqrt(0.75)], translation: [3, -1, 2] },
      { rotation: [0, 0.6, 0, 0.8], translation: [-4, 2, -6] },
      // behind the eye
      { rotation: [0, 0, 0, 1], translation: [-60, 20, 120] },
      UNMOVED,
    ];
    const nodes = [two, cut, sphere(3), two];
    // rows that are no whole blocks of a texture's, in bands that are no whole groups
    const of = { ...camera(30), width: 53, height: 47, offset: [0.3, 0.8] } as const;
    const standing = nodes.map((node, i) => ({ located: located(node, 40), placement: placements[i]! }));
    const cpu = emptyImage(of);
    const rays = new SceneCaster(standing, of);
    for (let row = 0; row < of.height; row++) rays.row(cpu, row);
    await withCaster(async (caster) => {
      const bodies = await Promise.all(
        nodes.map(async (node, i) => {
          const { lattice } = standing[i]!.located.bricks;
          return { body: await caster.body(node, lattice), placement: placements[i]! };
        }),
      );
      const { image, work } = await castBy(caster, bodies, of, 19);
      const { hits, either, apart, normal, colour } = compared(cpu, image, 30);
      expect(hits).toBeGreaterThan(300);
      expect(either).toBeLessThanOrEqual(Math.ceil(0.01 * hits));
      expect(apart).toBeLessThan(1e-5);
      expect(normal).toBeLessThan(2e-3);
      expect(colour).toBeLessThan(2e-3);
      expect(work.lost).toBe(0);
      const other = image.colours.filter((number, i) => i % 4 === 3 && number !== cpu.colours[i]);
      // where two bodies meet it is either
      expect(other.length).toBeLessThanOrEqual(Math.ceil(0.01 * hits));
      expect(new Set(image.colours.filter((_, i) => i % 4 === 3))).toEqual(new Set([0, 1, 2, 4]));
    });
    // of pipelines, which a busy machine takes long for
  }, 240_000);

  it('what tells nothing ahead is refused', async () => {
    const egg = shape({ type: 'ellipsoid', radii: [3, 5, 4] });
    const refused: readonly FieldNode[] = [
      sectioned({ type: 'superQuadric', exponent: 1.5 }),
      sectioned({ type: 'extrusion', exponent: 4 }),
      { ...blend, a: egg },
    ];
    for (const node of refused) {
      expect(castsOnDevice(node)).toBe(false);
      await withCaster((caster) =>
        expect(caster.body(node, located(node, 16).bricks)).rejects.toThrow(RangeError),
      );
    }
  });

  const SEED = 3300;
  const COUNT = process.env.ROTUND_FULL ? 60 : 8;
  it(`trees drawn by lot (${COUNT} from seed ${SEED})`, async () => {
    let hits = 0;
    const faults: string[] = [];
    for (let seed = SEED; hits < 20 * COUNT && seed < SEED + 10 * COUNT; seed++) {
      const node = randomTree(new Lot(seed), 1);
      const box = bindField(node).box;
      if (!box || !castsOnDevice(node)) continue;
      const height =
        1.2 * Math.max(...box.max.map((x, i) => Math.max(Math.abs(x), Math.abs(box.min[i]!)) * 2));
      if (!(height < 1e3)) continue;
      const found = await compare(node, 24, camera(height));
      hits += found.hits;
      const isSame =
        found.either <= Math.ceil(0.03 * found.hits) && found.apart < 1e-4 && found.normal < 0.02;
      if (!isSame) faults.push(`seed ${seed}: ${JSON.stringify(found)}`);
    }
    expect(faults).toEqual([]);
    expect(hits).toBeGreaterThan(100);
  }, 600_000);
});
