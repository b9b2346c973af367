/** Skeletons of whole outlines: stable, inside, few circles. */
import { describe, expect, it } from 'vitest';
import { medialAxis } from '../../../src/skeleton/medial/axis.ts';
import { along, isInside } from '../../../src/skeleton/medial/outline.ts';
import { prunePaper } from '../../../src/skeleton/medial/prunePaper.ts';
import { skeletonOf } from '../../../src/skeleton/medial/silhouette.ts';
import { blob, jittered, plate, SHAPES } from '../../fixtures/silhouettes.ts';
import { hausdorff } from './hausdorff.ts';

/** The paper's own sampling: edges of 0.05 of the canvas, here of the figure. */
const paper = (loops: Parameters<typeof skeletonOf>[0]) =>
  prunePaper(medialAxis(loops.map((loop) => along([loop], 5))));

describe('skeletonOf', () => {
  it.each(Object.entries(SHAPES))('%s: inside, and few', (_, shape) => {
    for (const jitter of [0, 0.3]) {
      const loops = jittered(shape, jitter, 3);
      const { nodes, links } = skeletonOf(loops);
      expect(nodes.length).toBeLessThan(50);
      expect(links.length - nodes.length).toBe(shape.length - 2);
      for (const { at } of nodes) expect(isInside(at, loops)).toBe(true);
    }
  });

  it('trembles with the outline half as much as the paper’s (seed 1)', () => {
    const apart = (of: typeof paper, shape: (typeof SHAPES)[string], seed: number) =>
      hausdorff(of(jittered(shape, 0, seed)), of(jittered(shape, 0.3, seed)));
    let [ours, theirs] = [0, 0];
    for (const name of ['disc', 'stadium', 'drop', 'bean', 'box', 'ring']) {
      ours += apart(skeletonOf, SHAPES[name]!, 1);
      theirs += apart(paper, SHAPES[name]!, 1);
    }
    expect(ours).toBeLessThan(0.5 * theirs);
  });

  it.each([1, 2, 3, 4, 5])('is the same turned and enlarged, nearly (blob, seed %i)', (seed) => {
    const loop = blob(seed);
    const turned = loop.map(([x, y]) => [-3 * y, 3 * x] as const);
    const back = (graph: ReturnType<typeof skeletonOf>) => ({
      ...graph,
      nodes: graph.nodes.map(({ at, radius }) => ({
        at: [at[1] / 3, -at[0] / 3] as const,
        radius: radius / 3,
      })),
    });
    expect(hausdorff(skeletonOf([loop]), back(skeletonOf([turned])))).toBeLessThan(0.5);
  });

  it.each([
    ['nothing', []],
    [
      'a place',
      [
        [
          [0, 0],
          [0, 0],
          [0, 0],
        ],
      ],
    ],
    [
      'a line',
      [
        [
          [0, 0],
          [5, 5],
          [9, 9],
        ],
      ],
    ],
  ] as [string, [number, number][][]][])('is empty for %s', (_, loops) => {
    expect(skeletonOf(loops).nodes).toEqual([]);
  });

  it.each([1, 2, 3, 5])('has %i rings for as many holes', (holes) => {
    const { nodes, links } = skeletonOf(plate(holes));
    expect(links.length - nodes.length + 1).toBe(holes);
  });
});
