/** WGSL = TypeScript for random trees of every kernel, skel, section, shape and operation: values, gradients, colours. */
import { afterAll, expect, it } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode } from '../../src/field/node.ts';
import type { TreeField } from '../../src/field/treeField.ts';
import { kernelNamed } from '../../src/kernel/index.ts';
import { Lot } from '../field/lot.ts';
import { randomTree } from '../field/randomTrees.ts';
import { type Point, points } from '../field/trees.ts';
import { withDevice } from './compute.ts';
import { closeDawn, describeGpu } from './dawn.ts';
import { evaluated } from './everything.ts';

afterAll(closeDawn);

const TREES = 80;
const COUNT = 60;
/** mm: places in float32, through matrices and warps, are not known better */
const BLUR = 2e-5;

/** Beside a plate and close to its plane little of a singular kernel's field is left in float32 (docs/fields.md). */
function hasSingularPlate(node: FieldNode): boolean {
  switch (node.type) {
    case 'skels':
      return (
        kernelNamed(node.kernel)!.homogeneity !== 0 && node.skels.some(({ skel }) => skel.type === 'polygon')
      );
    case 'shape':
      return false;
    case 'affine':
      return hasSingularPlate(node.node);
    case 'blend':
      return hasSingularPlate(node.a) || hasSingularPlate(node.b);
    case 'morph':
      return hasSingularPlate(node.from) || hasSingularPlate(node.to);
    default:
      return node.parts.some(hasSingularPlate);
  }
}

/** As many trees as are asked for. */
function trees(seed: number, count: number): FieldNode[] {
  const lot = new Lot(seed);
  const found: FieldNode[] = [];
  while (found.length < count) {
    const node = randomTree(lot);
    if (!hasSingularPlate(node)) found.push(node);
  }
  return found;
}

/** What is compared at a point: value, gradient, colour. */
type Numbers = readonly number[];

/** Where a ray of Newton steps from p meets the surface, or gives up: rounded to float32. */
function towardsSurface(field: TreeField, start: Point): Point {
  const p: [number, number, number] = [...start];
  const out = new Float64Array(4);
  for (let k = 0; k < 12; k++) {
    field.evaluate(...p, out);
    const steep = Math.hypot(out[1]!, out[2]!, out[3]!);
    if (!(steep > 1e-4)) break;
    const step = Math.max(-1, Math.min(1, -out[0]! / steep)) / steep;
    p.forEach((x, axis) => {
      p[axis] = x + step * out[axis + 1]!;
    });
  }
  return p.map(Math.fround) as unknown as Point;
}

/** of value, gradient, colour */
function twin(field: TreeField, p: Point): Numbers {
  const out = new Float64Array(4);
  field.evaluate(...p, out);
  const numbers = [...out];
  field.colour(...p, out);
  return [...numbers, ...out.subarray(0, 3)];
}

const apart = (a: Numbers, b: Numbers, from: number, to: number) =>
  Math.hypot(...a.slice(from, to).map((x, i) => x - b[from + i]!));

/** Away from the surface colours are the ratio of residues. */
const isNear = ([value]: Numbers) => Math.abs(value!) < 0.05;

/** Errors of value, gradient and colour in units of what is allowed. */
function errors(field: TreeField, p: Point, got: Numbers): Numbers {
  const truth = twin(field, p);
  // beside a crease, an axis or a joint the field is not known better than there
  const near = [0, 1, 2].flatMap((axis) =>
    [-BLUR, BLUR].map((d) => twin(field, p.map((x, i) => (i === axis ? x + d : x)) as unknown as Point)),
  );
  return [
    [0, 1, 1e-5],
    [1, 4, 5e-4],
    [4, 7, 1e-3],
  ].map(([from, to, share]) => {
    const blur = Math.max(...near.map((numbers) => apart(numbers, truth, from!, to!)));
    const size = 1 + Math.hypot(...truth.slice(from, to));
    if (from === 4 && !isNear(truth)) return 0;
    return apart(got, truth, from!, to!) / (share! * size + 2 * blur);
  });
}

describeGpu('a tree on the GPU is its twin', () => {
  it(`values, gradients, colours (${TREES} trees of ${COUNT} points, seed 41)`, async () => {
    const wrong: string[] = [];
    let near = 0;
    await withDevice(async (device) => {
      for (const [i, node] of trees(41, TREES).entries()) {
        const field = bindField(node);
        const at = points(COUNT, 8, 42).map((p) => towardsSurface(field, p));
        const flat = Float32Array.from(at.flat());
        const values = await evaluated(device, node, 'points', flat);
        const colours = await evaluated(device, node, 'colours', flat);
        at.forEach((p, k) => {
          const got = [...values.subarray(4 * k, 4 * k + 4), ...colours.subarray(4 * k + 1, 4 * k + 4)];
          const own = errors(field, p, got);
          if (isNear(twin(field, p))) near++;
          if (!own.every((error) => error <= 1))
            wrong.push(`tree ${i} at ${p}: ${own.map((e) => e.toPrecision(3))} ${got} ${twin(field, p)}`);
        });
      }
    });
    expect(wrong).toEqual([]);
    expect(near).toBeGreaterThan(0.5 * TREES * COUNT);
  });
});
