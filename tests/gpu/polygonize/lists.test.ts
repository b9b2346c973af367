/** The field by a brick's lists: the terms that are asked, the polynomial that stands for the others, sums that were dropped. */
import { afterAll, describe, expect, it } from 'vitest';
import { type Affine, IDENTITY, inverted } from '../../../src/field/affine.ts';
import { bindField } from '../../../src/field/bind.ts';
import type { Far, NearLeaf } from '../../../src/field/near.ts';
import type { FieldNode } from '../../../src/field/node.ts';
import { compile, link } from '../../../src/gpu/link.ts';
import { readBack } from '../../../src/gpu/polygonize/buffers.ts';
import { type ListedBrick, packLists } from '../../../src/gpu/polygonize/lists.ts';
import { modulesOf } from '../../../src/gpu/polygonize/stages.ts';
import { programOf } from '../../../src/gpu/program.ts';
import { Lot } from '../../field/lot.ts';
import { BONE, body, type Point, RIGID, SKEW, sphere } from '../../field/trees.ts';
import { withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';

afterAll(closeDawn);

const PLAIN = body();
const union = (...parts: readonly FieldNode[]): FieldNode => ({ type: 'union', form: 'hard', parts });
/** Heavier on the right, so that the program's order is not the tree's; the bodies are leaves 0, 2, 3 and 4. */
const TREE = union(
  PLAIN,
  union(
    sphere(0.5),
    union(
      { type: 'affine', matrix: RIGID, node: PLAIN },
      union({ type: 'affine', matrix: SKEW, node: PLAIN }, PLAIN),
    ),
  ),
);
const BODIES: readonly (readonly [leaf: number, matrix: Affine])[] = [
  [0, IDENTITY],
  [2, RIGID],
  [3, SKEW],
  [4, IDENTITY],
];

function randomLeaf(lot: Lot, leaf: number): NearLeaf {
  if (lot.is(0.3)) return { leaf, dropped: 'low', terms: null, far: null };
  const far: Far = {
    centre: lot.place(),
    taylor: Float64Array.from({ length: 10 }, (_, i) => lot.between(-0.2, 0.2) - (i === 0 ? 0.7 : 0)),
    colour: Float64Array.of(0.5, 0.1, 0.2, 0.4),
  };
  return { leaf, dropped: null, terms: [0, 1, 2].filter(() => lot.is(0.5)), far: lot.is(0.8) ? far : null };
}

const brickOf = (leaves: readonly NearLeaf[]): ListedBrick => ({
  i: 1,
  j: 2,
  k: 3,
  near: { error: 0.25, branches: 1, eachLeaf: (visit) => leaves.forEach(visit) },
});

/** In float64, by other means: bodies of the terms that are asked, and the polynomial written out. */
function truth(
  leaves: readonly NearLeaf[],
  p: Point,
): { value: number; second: number; colour: readonly number[] } {
  const found = BODIES.map(([leaf, matrix]) => {
    const near = leaves.find((one) => one.leaf === leaf)!;
    return near.dropped === null ? leafAt(near, local(matrix, p)) : { value: -1e30, colour: [0, 0, 0] };
  });
  found.push({ value: bindField(sphere(0.5)).value(...p), colour: [...bound(sphere(0.5), p)] });
  found.sort((a, b) => b.value - a.value);
  return { ...found[0]!, second: found[1]!.value };
}

function bound(node: FieldNode, p: Point): Float64Array {
  const colour = new Float64Array(3);
  bindField(node).colour(...p, colour);
  return colour;
}

function leafAt({ terms, far }: NearLeaf, [x, y, z]: Point): { value: number; colour: readonly number[] } {
  let value = -1;
  let weights = [0, 0, 0, 0];
  if (far) {
    const [u, v, w] = [x - far.centre[0], y - far.centre[1], z - far.centre[2]];
    const powers = [1, u, v, w, u * u, v * v, w * w, u * v, v * w, w * u];
    value = powers.reduce((sum, power, i) => sum + power * far.taylor[i]!, 0);
    weights = [...far.colour];
  }
  for (const term of terms!) {
    const part = bindField({ ...PLAIN, skels: [BONE[term]!] }).value(x, y, z) + 1;
    value += part;
    const seen = Math.max(0, part - 1e-3);
    weights = [1, ...(BONE[term]!.colour ?? PLAIN.colour!)].map((c, i) => weights[i]! + seen * c);
  }
  const colour = weights.slice(1).map((c) => c / weights[0]!);
  return { value, colour: weights[0]! > 0 ? colour : [...PLAIN.colour!] };
}

function local(matrix: Affine, [x, y, z]: Point): Point {
  const m = inverted(matrix);
  const row = (i: 0 | 4 | 8) => m[i]! * x + m[i + 1]! * y + m[i + 2]! * z + m[i + 3]!;
  return [row(0), row(4), row(8)];
}

/** Field and colour at each point, by the brick of the same number. */
const ENTRY = `#import polygonize/near
@group(0) @binding(0) var<storage, read> points: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> values: array<vec4f>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
  if (id.x >= arrayLength(&points)) { return; }
  let header = lists[id.x];
  for (var i = 0u; i < 2u; i++) {
    values[2u * id.x + i] = near_field(header.y, points[id.x].xyz, i == 1u);
  }
}
`;

const onGpu = (
  node: FieldNode,
  bricks: readonly ListedBrick[],
  at: readonly Point[],
): Promise<Float32Array> =>
  withDevice(async (device) => {
    const program = programOf(node);
    const modules = { ...modulesOf(program.ingredients), test: ENTRY };
    const module = await compile(device, 'lists', link(modules, 'test'));
    const pipeline = await device.createComputePipelineAsync({ layout: 'auto', compute: { module } });
    const put = (bytes: ArrayBuffer) => {
      const buffer = device.createBuffer({ size: bytes.byteLength, usage: 0x80 | 0x4 | 0x8 });
      device.queue.writeBuffer(buffer, 0, bytes);
      return { buffer, size: bytes.byteLength };
    };
    const points = put(Float32Array.from(at.flatMap((p) => [...p, 0])).buffer);
    const values = put(new ArrayBuffer(32 * at.length));
    const groups = [
      [points, values],
      [put(program.records), put(packLists(program, bricks).buffer)],
    ];
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    groups.forEach((slices, group) => {
      const entries = slices.map((resource, binding) => ({ binding, resource }));
      const layout = pipeline.getBindGroupLayout(group);
      pass.setBindGroup(group, device.createBindGroup({ layout, entries }));
    });
    pass.dispatchWorkgroups(Math.ceil(at.length / 64));
    pass.end();
    device.queue.submit([encoder.finish()]);
    const [bytes] = await readBack(device, [values]);
    for (const { buffer } of groups.flat()) buffer.destroy();
    return new Float32Array(bytes!);
  });

const COUNT = 600;

describeGpu('lists of a brick', () => {
  it(`give the field of what they name: value, gradient, colour (${COUNT} bricks, seed 81)`, async () => {
    const lot = new Lot(81);
    const lists = lot.many(COUNT, () => [
      { leaf: 1, dropped: null, terms: null, far: null },
      ...BODIES.map(([leaf]) => randomLeaf(lot, leaf)),
    ]);
    const at = lot.many(COUNT, () => lot.place().map(Math.fround) as unknown as Point);
    const values = await onGpu(TREE, lists.map(brickOf), at);
    let decided = 0;
    at.forEach((p, i) => {
      const [value, gx, gy, gz, again, ...colour] = values.subarray(8 * i, 8 * i + 8);
      const expected = truth(lists[i]!, p);
      const scale = 1 + Math.abs(expected.value);
      expect(Math.abs(value! - expected.value)).toBeLessThan(2e-5 * scale);
      expect(again).toBe(value);
      // at creases there are two gradients
      if (expected.value - expected.second < 0.02) return;
      decided++;
      [gx!, gy!, gz!].forEach((g, axis) => {
        const moved = (h: number) =>
          truth(lists[i]!, p.map((x, k) => (k === axis ? x + h : x)) as unknown as Point).value;
        expect(Math.abs(g - (moved(1e-4) - moved(-1e-4)) / 2e-4)).toBeLessThan(1e-4 * scale);
      });
      colour.forEach((c, k) => {
        expect(Math.abs(c - expected.colour[k]!)).toBeLessThan(1e-4);
      });
    });
    expect(decided).toBeGreaterThan(COUNT / 2);
  });
});

describeGpu('sums that were dropped', () => {
  const cut: FieldNode = { type: 'intersection', form: 'hard', parts: [PLAIN, body(BONE, 2), PLAIN] };
  const low = (leaf: number): NearLeaf => ({ leaf, dropped: 'low', terms: null, far: null });
  const high = (leaf: number): NearLeaf => ({ leaf, dropped: 'high', terms: null, far: null });
  const all = (leaf: number): NearLeaf => ({ leaf, dropped: null, terms: [0, 1, 2], far: null });

  it('leave the value to the others, or are all that is left', async () => {
    const at: Point = [1, 0.5, 0.25];
    const lists = [
      [high(0), all(1), high(2)],
      [all(0), high(1), high(2)],
      [low(0), all(1), all(2)],
    ];
    const values = await onGpu(cut, lists.map(brickOf), [at, at, at]);
    expect(values[0]).toBeCloseTo(bindField(body(BONE, 2)).value(...at), 5);
    expect(values[8]).toBeCloseTo(bindField(PLAIN).value(...at), 5);
    expect(values[16]).toBe(Math.fround(-1e30));
  });
});

describe('packed lists', () => {
  const program = programOf(TREE);
  const whole = (leaf: number): NearLeaf => ({ leaf, dropped: null, terms: [0, 1, 2], far: null });
  const dropped = (leaf: number): NearLeaf => ({ leaf, dropped: 'high', terms: null, far: null });

  it('have a row a brick, and a row a run of dropped sums', () => {
    expect(packLists(program, [])).toEqual(new Uint32Array(4));
    const one = brickOf([0, 2, 3, 4].map(dropped));
    const words = packLists(program, [one, one]);
    const error = new Uint32Array(Float32Array.of(0.25).buffer)[0]!;
    const place = 1 | (2 << 10) | (3 << 20);
    expect([...words.subarray(0, 8)]).toEqual([place, 2, error, 0, place, 3, error, 0]);
    expect([...words.subarray(8)]).toEqual([2, 4, 0, 0, 2, 4, 0, 0]);
  });

  it('say which leaf a brick is silent about', () => {
    expect(() => packLists(program, [brickOf([0, 2, 4].map(whole))])).toThrow('leaf 3');
  });
});
