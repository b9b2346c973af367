/**
 * Kravtsov et al., tables 1.1 (a GeForce 8800 Ultra) and 1.2 (a Xeon of 2.66 GHz): milliseconds a mesh. Their characters are not given;
 * ours are the first limbs of a tree, as many, and for the hybrid, which is a mesh with a stand-in, an ellipsoid that
 * blends with them.
 */
import type { FieldNode } from '../../src/field/node.ts';
import { measured } from './polygonizing.ts';
import { sceneNode } from './scenes/index.ts';
import { rounded } from './timing.ts';

const limbs = (count: number): FieldNode => {
  const tree = sceneNode('tree64');
  return { ...tree, skels: tree.skels.slice(0, count) };
};

const SCENES = {
  '11 segments': limbs(11),
  '45 segments': limbs(45),
  '10, hybrid': {
    type: 'blend',
    a: limbs(10),
    b: { type: 'shape', shape: { type: 'ellipsoid', radii: [0.2, 0.3, 0.2] } },
    a0: 0.02,
    a1: 0.02,
    a2: 0.1,
  },
} as const satisfies Record<string, FieldNode>;

type SceneName = keyof typeof SCENES;
type Paper = Readonly<Record<number, readonly [number, number, number]>>;

/** cells → milliseconds of the scenes, in their order */
const ON_CPU: Paper = { 20: [25, 80, 30], 30: [80, 220, 60], 50: [310, 930, 260], 70: [810, 2580, 670] };
const ON_GPU: Paper = { 32: [3, 9, 2], 64: [7, 22, 3], 128: [30, 95, 14] };

export async function timeKravtsovOnCpu(): Promise<void> {
  console.log('\nKravtsov et al., table 1.2, CPU, ms');
  await timeTable(ON_CPU, (node, cells) => Promise.resolve(measured(node, cells).milliseconds));
}

/** `time`: milliseconds from a tree to its mesh on the GPU. */
export async function timeKravtsovOnGpu(
  time: (node: FieldNode, cells: number) => Promise<number>,
): Promise<void> {
  console.log('\nKravtsov et al., table 1.1, GPU, ms');
  await timeTable(ON_GPU, time);
}

async function timeTable(
  paper: Paper,
  time: (node: FieldNode, cells: number) => Promise<number>,
): Promise<void> {
  const rows = [];
  for (const [cells, theirs] of Object.entries(paper)) {
    const row: Record<string, number> = { cells: Number(cells) };
    for (const [i, name] of (Object.keys(SCENES) as SceneName[]).entries()) {
      row[name] = rounded(await time(SCENES[name], Number(cells)), 1);
      row[`paper’s${' '.repeat(i)}`] = theirs[i]!;
    }
    rows.push(row);
  }
  console.table(rows);
}
