/** The table and its reading in WGSL against the loops that the CPU follows: every mask, with values that decide open faces either way. */
import { afterAll, expect, it } from 'vitest';
import { CubeLoops } from '../../../src/field/cubeLoops.ts';
import { loopModule, loopTable } from '../../../src/gpu/polygonize/loopTable.ts';
import { SHADERS } from '../../../src/gpu/shaders.ts';
import { random } from '../../fixtures/random.ts';
import { compute, withDevice } from '../compute.ts';
import { closeDawn, describeGpu } from '../dawn.ts';

afterAll(closeDawn);

const ROUNDS = 40;
/** numbers of a case in the answer: loops, triangles, middles, of four loops end and twist, of twelve edges corner and axis */
const NUMBERS = 3 + 8 + 24;
const CROSSINGS = 12;

/** The table, and behind it eight values a case; both in binding 0. */
const ENTRY = (rows: number, cases: number) => `#import polygonize/loops
@group(0) @binding(1) var<storage, read_write> answers: array<f32>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
  if (id.x >= ${cases}u) { return; }
  var values: array<f32, 8>;
  var mask = 0u;
  for (var i = 0u; i < 8u; i++) {
    values[i] = bitcast<f32>(loop_table[${rows}u + 2u * id.x + i / 4u][i % 4u]);
    mask |= select(0u, 1u, values[i] > 0.0) << i;
  }
  let row = loop_table[loop_case(mask, values)];
  let at = ${NUMBERS}u * id.x;
  answers[at] = f32(loop_count(row));
  answers[at + 1u] = f32(loop_triangles(row));
  answers[at + 2u] = f32(loop_middles(row));
  for (var i = 0u; i < 4u; i++) {
    answers[at + 3u + i] = f32(loop_end(row, i));
    answers[at + 7u + i] = select(0.0, 1.0, is_twisted(row, i));
  }
  for (var i = 0u; i < ${CROSSINGS}u; i++) {
    let edge = loop_edge(row, i);
    answers[at + 11u + 2u * i] = f32(edge.x + 2u * edge.y + 4u * edge.z);
    answers[at + 12u + 2u * i] = f32(edge.w);
  }
}
`;

/** What the CPU says, in the same order. */
function expected(values: Float32Array): readonly number[] {
  const loops = new CubeLoops();
  loops.trace(
    values.reduce((mask, value, i) => mask | (value > 0 ? 1 << i : 0), 0),
    values,
  );
  const numbers = (given: Uint8Array, count: number) =>
    Array.from({ length: given.length }, (_, i) => (i < count ? given[i]! : 0));
  const ends = numbers(loops.ends, loops.count);
  const twists = numbers(loops.isTwisted, loops.count);
  const total = loops.count > 0 ? ends[loops.count - 1]! : 0;
  const lengths = ends.slice(0, loops.count).map((end, i) => end - (i > 0 ? ends[i - 1]! : 0));
  const triangles = lengths.map((length, i) => (twists[i] ? length : length - 2));
  return [
    loops.count,
    triangles.reduce((sum, count) => sum + count, 0),
    twists.reduce((sum, twist) => sum + twist, 0),
    ...ends,
    ...twists,
    ...numbers(loops.edges, total).flatMap((edge) => [edge & 7, edge >> 3]),
  ];
}

describeGpu('the table of loops', () => {
  it(`has the loops of the CPU, ${256 * ROUNDS} cubes (seed 63)`, async () => {
    const next = random(63);
    const cubes = Array.from({ length: 256 * ROUNDS }, (_, i) =>
      Float32Array.from({ length: 8 }, (_, corner) => (((i >> corner) & 1) === 1 ? 1 : -1) * (0.1 + next())),
    );
    const table = loopTable();
    const input = new Uint32Array(table.length + 8 * cubes.length);
    input.set(table);
    cubes.forEach((values, i) => {
      input.set(new Uint32Array(values.buffer), table.length + 8 * i);
    });
    const corners = loopModule().replace(/@group.*/, '');
    const modules = {
      ...SHADERS,
      'table/loops': `${corners}@group(0) @binding(0) var<storage, read> loop_table: array<vec4u>;\n`,
      test: ENTRY(table.length / 4, cubes.length),
    };
    const answers = await withDevice((device) =>
      compute(device, modules, input.buffer, NUMBERS * cubes.length, cubes.length),
    );
    cubes.forEach((values, i) => {
      expect([...answers.subarray(NUMBERS * i, NUMBERS * (i + 1))]).toEqual(expected(values));
    });
  });
});
