/**
 * Meshes of the CPU and of the GPU from the same bricks are of one surface: each vertex of one on the other's, the same Euler number, as
 * many triangles, but where values at nodes are so small that float32 may take the other sign; those are listed.
 */
import { afterAll, expect, it } from 'vitest';
import { bindField } from '../../../src/field/bind.ts';
import type { FieldMesh } from '../../../src/field/brickMesh.ts';
import { type Bricks, hasCreases } from '../../../src/field/bricks.ts';
import { BRICK } from '../../../src/field/lattice.ts';
import type { FieldNode, Term } from '../../../src/field/node.ts';
import { polygonize } from '../../../src/field/polygonize.ts';
import { gpuField } from '../../../src/gpu/field.ts';
import { gpuPolygonizer } from '../../../src/gpu/polygonize/polygonizer.ts';
import { topology } from '../../../src/mesh/check.ts';
import { body, placed, RIGID, SKEW, sphere } from '../../field/trees.ts';
import { random } from '../../fixtures/random.ts';
import { withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';

afterAll(closeDawn);

const CELLS = 32;
/** of a cell */
const LEAST = 1e-4;
/** of what is summed up: what float32 may be off by */
const FLOAT = 2e-6;
/** cells: a vertex of the CPU may leave the edge that it is of */
const BESIDE = 0.3;

const torus: FieldNode = { type: 'shape', shape: { type: 'torus', ring: 4, tube: 1 } };

function bush(seed: number): FieldNode {
  const next = random(seed);
  const at = () => [8 * next() - 4, 8 * next() - 4, 8 * next() - 4] as const;
  const one = (): Term => ({
    skel: { type: 'segment', a: at(), b: at(), weights: [1 + next(), 0.1 * next()] },
    colour: [next(), next(), next()],
  });
  return body(Array.from({ length: 12 }, one));
}

/** S: the sum of the terms is T on the surface; distances are off by what coordinates are. */
const BODIES: Readonly<Record<string, readonly [FieldNode, S: number]>> = {
  'a torus': [torus, 5],
  'a body of three skels': [body(), 1],
  'a moved body': [{ type: 'affine', matrix: RIGID, node: body() }, 1],
  'a stretched body that blends with a ball': [
    {
      type: 'blend',
      a: { type: 'affine', matrix: SKEW, node: body() },
      b: placed(sphere(3), 5, 1, 0),
      a0: 0.5,
      a1: 1,
      a2: 1,
    },
    8,
  ],
  'a bush of 12 segments (seed 5)': [bush(5), 1],
  'a bush of 12 segments (seed 6)': [bush(6), 1],
};

interface Local {
  /** |f| / |∇f| and |∇f|, in the brick whose field says the least */
  readonly off: number;
  readonly slope: number;
}

/** By the fields of the bricks around, in float64. */
function local({ lattice, counts, grid, active }: Bricks, at: readonly [number, number, number]): Local {
  const out = new Float64Array(4);
  const range = (axis: 0 | 1 | 2) => {
    const cell = (at[axis] - lattice.origin[axis]) / lattice.step;
    const [low, high] = [cell - BESIDE, cell + BESIDE].map((x) => Math.floor(x / BRICK));
    return [low!, high!].filter((b, i, both) => b >= 0 && b < counts[axis] && both.indexOf(b) === i);
  };
  let best: Local = { off: Infinity, slope: 0 };
  for (const k of range(2))
    for (const j of range(1))
      for (const i of range(0)) {
        const place = grid[i + counts[0] * (j + counts[1] * k)]!;
        if (place < 0) continue;
        active[place]!.near.evaluate(...at, out);
        const slope = Math.hypot(out[1]!, out[2]!, out[3]!);
        if (Math.abs(out[0]!) / slope < best.off) best = { off: Math.abs(out[0]!) / slope, slope };
      }
  return best;
}

const vertexOf = ({ positions }: FieldMesh, v: number) =>
  [positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!] as const;

/**
 * The farthest of the vertices from the other mesh's surface, in parts of what is allowed. `blur`: by how much the other's values are
 * off at a vertex. Where a list misses so much that all skels gave a sign the surface is where the other's vertex is.
 */
function farthest(
  mesh: FieldMesh,
  other: FieldMesh,
  bricks: Bricks,
  S: number,
  blur: (v: number) => number = () => 0,
): number {
  let most = 0;
  for (let v = 0; v < mesh.positions.length / 3; v++) {
    const at = vertexOf(mesh, v);
    const { off, slope } = local(bricks, at);
    const allowed = Math.max(LEAST * bricks.lattice.step, (2 * FLOAT * S) / slope);
    const part = (off + blur(v) / slope) / allowed;
    most = Math.max(most, part < 1 ? part : nearest(other, at) / allowed);
  }
  return most;
}

/** mm to the nearest vertex */
function nearest(mesh: FieldMesh, [x, y, z]: ReturnType<typeof vertexOf>): number {
  let least = Infinity;
  for (let v = 0; v < mesh.positions.length / 3; v++) {
    const [a, b, c] = vertexOf(mesh, v);
    least = Math.min(least, Math.hypot(a - x, b - y, c - z));
  }
  return least;
}

/** Nodes whose sign is float32's to choose, as x y z of the lattice. */
function unsure({ active, lattice: { origin, step } }: Bricks, S: number): readonly string[] {
  const found = new Set<string>();
  for (const { i, j, k, near } of active) {
    for (let n = 0; n < 125; n++) {
      const at = [BRICK * i + (n % 5), BRICK * j + (Math.floor(n / 5) % 5), BRICK * k + Math.floor(n / 25)];
      const [x, y, z] = at.map((cells, axis) => origin[axis]! + cells * step) as [number, number, number];
      if (Math.abs(near.value(x, y, z)) < FLOAT * S) found.add(at.join(' '));
    }
  }
  return [...found];
}

describeGpu('meshes of the CPU and the GPU', () => {
  it.each(Object.entries(BODIES))('agree: %s', async (_, [node, S]) => {
    const field = bindField(node);
    const cpu = polygonize(field, CELLS);
    const { bricks } = cpu;
    expect(hasCreases(bricks.active)).toBe(false);
    const { gpu, values } = await withDevice(async (device) => {
      const polygonizer = gpuPolygonizer(device);
      const mesh = await (await polygonizer.whole(node, bricks)).read();
      polygonizer.destroy();
      const tree = gpuField(device, node);
      const found = await tree.evaluate(cpu.mesh.positions);
      tree.destroy();
      return { gpu: mesh, values: found };
    });

    expect(farthest(gpu, cpu.mesh, bricks, S)).toBeLessThan(1);
    // the GPU's surface is where its own values are 0
    const blur = (v: number) => Math.abs(values[4 * v]! - field.value(...vertexOf(cpu.mesh, v)));
    expect(farthest(cpu.mesh, gpu, bricks, S, blur)).toBeLessThan(1);

    const close = unsure(bricks, S);
    if (close.length > 0) console.info(`values within float32 of 0 at the nodes ${close.join(', ')}`);
    const [own, expected] = [topology(gpu), topology(cpu.mesh)];
    expect(own).toMatchObject({ watertight: true, finite: true });
    if (close.length === 0) {
      expect(own.euler).toBe(expected.euler);
      expect(gpu.indices.length).toBe(cpu.mesh.indices.length);
    }
    expect(close.length).toBeLessThan(10);
  });
});
