/** WGSL = TypeScript for every shape of the list, inputs rounded to float32 before both see them. */
import { afterAll, expect, it } from 'vitest';
import { SHADERS } from '../../src/gpu/shaders.ts';
import { bindShape, kindOf, type Shape, shapes } from '../../src/shape/index.ts';
import { random } from '../fixtures/random.ts';
import { compute, withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';

afterAll(closeDawn);

const COUNT = 500;
type Point = readonly [x: number, y: number, z: number];

/** A shape of numbers that float32 has. */
const rounded = (shape: Shape): Shape =>
  JSON.parse(JSON.stringify(shape), (_, value) => (typeof value === 'number' ? Math.fround(value) : value));

/** `sphere_field(p, 10.0)`: the numbers of the shape in the places that the signature has. */
function call(shape: Shape): string {
  const [, name, list] = /fn (\w+_field)\(p: vec3f, ([^)]*)\)/.exec(SHADERS[`shape/${shape.type}`]!)!;
  const numbers = kindOf(shape)
    .numbers(shape)
    .map((x) => `f32(${x})`);
  const args = list!.split(',').map((parameter) => {
    const width = parameter.includes('vec3f') ? 3 : 1;
    const own = numbers.splice(0, width);
    return width === 3 ? `vec3f(${own})` : own[0]!;
  });
  expect(numbers).toEqual([]);
  return `${name}(p, ${args.join(', ')})`;
}

async function evaluate(shape: Shape, points: readonly Point[]): Promise<Float32Array> {
  const test = `#import shape/${shape.type}
    @group(0) @binding(0) var<storage, read> places: array<vec4f>;
    @group(0) @binding(1) var<storage, read_write> out: array<vec4f>;
    @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
      if (id.x >= arrayLength(&out)) { return; }
      let p = places[id.x].xyz;
      out[id.x] = ${call(shape)};
    }`;
  const input = Float32Array.from(points.flatMap((p) => [...p, 0]));
  const count = points.length;
  return withDevice((device) => compute(device, { ...SHADERS, test }, input.buffer, 4 * count, count));
}

describeGpu('shapes in WGSL', () => {
  for (const kind of Object.values(shapes)) {
    const examples = (kind.examples as readonly Shape[]).map(rounded);
    it.each(examples)(`${kind.name} is its twin: %j (seed 7)`, async (shape) => {
      const field = bindShape(shape);
      const { min, max } = field.box ?? { min: [-10, -10, -10], max: [10, 10, 10] };
      const size = Math.max(...max.map((x, i) => x - min[i]!)) / 2;
      const next = random(7);
      const at = (i: 0 | 1 | 2) => Math.fround((min[i]! + max[i]!) / 2 + 2 * size * (2 * next() - 1));
      const nasty: Point[] = [[0, 0, 0], max, min, [max[0], 0, 0], [0, max[1], 0]].map(
        (p) => p.map(Math.fround) as unknown as Point,
      );
      const points = [...nasty, ...Array.from({ length: COUNT }, (): Point => [at(0), at(1), at(2)])];
      const got = await evaluate(shape, points);
      const out = new Float64Array(4);
      const beside = new Float64Array(4);
      let valueError = 0;
      let gradientError = 0;
      points.forEach(([x, y, z], k) => {
        field.evaluate(x, y, z, out);
        valueError = Math.max(valueError, Math.abs(got[4 * k]! - out[0]!) / size);
        // on a crease either side's gradient is right
        field.evaluate(x + 1e-5 * size, y + 2e-5 * size, z + 3e-5 * size, beside);
        const creased = [1, 2, 3].some((i) => !(Math.abs(out[i]! - beside[i]!) < 1e-3));
        for (const i of creased ? [] : [1, 2, 3]) {
          gradientError = Math.max(gradientError, Math.abs(got[4 * k + i]! - out[i]!));
        }
      });
      expect(valueError).toBeLessThan(2e-6);
      expect(gradientError).toBeLessThan(2e-5);
    });
  }
});
