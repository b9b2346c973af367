import { describe, expect, it } from 'vitest';
import { medialAxis } from '../../../src/skeleton/medial/axis.ts';
import { neighboursOf } from '../../../src/skeleton/medial/branches.ts';
import { along } from '../../../src/skeleton/medial/outline.ts';
import { PRUNING, prune } from '../../../src/skeleton/medial/prune.ts';
import { blob, box, disc, jittered, plate, polar, SHAPES } from '../../fixtures/silhouettes.ts';

const pruned = (loops: Parameters<typeof prune>[1]) => prune(medialAxis(loops), loops);
const fine = (loops: Parameters<typeof prune>[1]) => loops.map((loop) => along([loop], 1));

describe('prune', () => {
  it.each([
    ...Object.entries(SHAPES),
    ...[1, 2, 3, 4].map((seed) => [`blob (seed ${seed})`, [blob(seed)]] as const),
  ])('%s: circles reach every place of the outline to within the share', (_, shape) => {
    for (const jitter of [0, 0.3]) {
      const loops = jittered(shape, jitter, 5);
      const axis = medialAxis(loops);
      const { nodes } = prune(axis, loops);
      for (const [x, y] of loops.flat()) {
        const gap = (of: typeof nodes) =>
          Math.min(...of.map(({ at, radius }) => Math.hypot(x - at[0], y - at[1]) / radius - 1));
        // no circle reaches into a corner; places between those that are looked at may be a little further
        expect(gap(nodes)).toBeLessThan(Math.max(PRUNING.branch, gap(axis.nodes)) + 0.03);
      }
    }
  });

  it('leaves one circle of a disc, however it trembles (seeds 1 to 3)', () => {
    for (const seed of [1, 2, 3]) {
      expect(pruned(jittered([disc(30)], 0.4, seed)).nodes.length).toBe(1);
    }
  });

  it('takes waves off a round form, and keeps limbs', () => {
    const waves = fine([polar((t) => 30 + 0.6 * Math.sin(34 * Math.PI * t), 300)]);
    expect(pruned(waves).nodes.length).toBe(1);
    const near = neighboursOf(pruned(fine(SHAPES.star!)));
    expect(near.filter((others) => others.length === 1).length).toBe(5);
  });

  it('keeps the corners of a box', () => {
    const near = neighboursOf(pruned(fine([box(60, 20)])));
    expect(near.filter((others) => others.length === 1).length).toBe(4);
  });

  it.each([1, 2, 3])('keeps %i rings', (holes) => {
    const { nodes, links } = pruned(fine(plate(holes)));
    expect(links.length - nodes.length + 1).toBe(holes);
  });

  it('leaves nothing as it is', () => {
    expect(prune({ nodes: [], links: [] }, [])).toEqual({ nodes: [], links: [] });
  });
});
