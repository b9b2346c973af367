/** 500 outlines of fourteen kinds, 5,000 with ROTUND_FULL: skels or none, numbers all of them, and a surface that follows. */
import { describe, expect, it } from 'vitest';
import { kernels } from '../../../src/kernel/index.ts';
import { bindSkel } from '../../../src/skeleton/index.ts';
import { distanceFrom, edgesOf, isWithin, sizeOf, spaced } from '../../../src/skeleton/medial/outline.ts';
import { type Silhouette, silhouetteOf } from '../../../src/skeleton/medial/silhouette.ts';
import { type AnySilhouette, anySilhouette } from './anySilhouette.ts';

const BLOCKS = process.env.ROTUND_FULL ? 100 : 10;
const BLOCK = 50;
const usual = (kernel: (typeof kernels)[number]) =>
  Object.fromEntries(kernel.params.map(({ name, default: value }) => [name, value]));
const cauchy = kernels.find(({ name }) => name === 'cauchy')!;

/** Of what is a number. */
const soundOf = ({ loops }: AnySilhouette) =>
  loops.map((loop) => loop.filter((p) => p.every(Number.isFinite))).filter((loop) => loop.length > 2);

function expectNumbers({ skels, relative, residual, most, ratio, graph }: Silhouette, about: string): void {
  const numbers = skels.flatMap((skel) => Object.values(skel).flat()).filter((v) => typeof v !== 'string');
  const nodes = graph.nodes.flatMap(({ at, radius }) => [...at, radius]);
  const all = [...numbers, ...nodes, ...relative, residual, most, ratio];
  expect(all.every(Number.isFinite), about).toBe(true);
  expect(skels.length, about).toBeGreaterThan(0);
}

/** Ascending, shares of the size, to first order. */
function offsAlong({ skels, params }: Silhouette, loops: AnySilhouette['loops']): number[] {
  const fields = skels.map((skel) => bindSkel(skel, cauchy, params));
  const out = new Float64Array(4);
  const places = spaced(loops, 120).flat();
  const offs = places.map(([x, y]) => {
    out.fill(0);
    for (const field of fields) field.add(x, y, 0, 1, out);
    return Math.abs(out[0]! - 1) / Math.hypot(out[1]!, out[2]!) / sizeOf(loops);
  });
  return offs.sort((a, b) => a - b);
}

describe.each(Array.from({ length: BLOCKS }, (_, block) => block * BLOCK + 1))('seeds from %i', (first) => {
  const seeds = Array.from({ length: BLOCK }, (_, i) => first + i);

  it('are followed, by skeletons inside', { timeout: 120_000 }, () => {
    for (const seed of seeds) {
      const any = anySilhouette(seed);
      const about = `${any.kind}, seed ${seed}`;
      const found = silhouetteOf(any.loops, cauchy, usual(cauchy), 1);
      if (any.kind === 'collinear') expect(found, about).toBeNull();
      if (!found) {
        expect(['collinear', 'few places', 'needle'], about).toContain(any.kind);
        continue;
      }
      expectNumbers(found, about);
      const loops = soundOf(any);
      const edges = edgesOf(loops);
      for (const { at } of found.graph.nodes) {
        // to within the spacing of the places that the skeleton is made from
        const isOut = !isWithin(edges, ...at) && distanceFrom(edges, ...at) > 0.01 * sizeOf(loops);
        expect(isOut, about).toBe(false);
      }
      // a hair is thinner than its places are apart
      if (any.kind === 'needle') continue;
      const offs = offsAlong(found, loops);
      expect(offs[Math.floor(0.5 * offs.length)], about).toBeLessThan(0.015);
      expect(offs[Math.floor(0.9 * offs.length)], about).toBeLessThan(0.05);
    }
  });

  it('have skels that are numbers in every kernel, quickly, by the paper’s skeleton and with any width', {
    timeout: 120_000,
  }, () => {
    for (const seed of seeds.filter((seed) => seed % 3 === 0)) {
      const { kind, loops } = anySilhouette(seed);
      const kernel = kernels[Math.floor(seed / 3) % kernels.length]!;
      const options = [
        { quick: true },
        { width: 'given' },
        { quick: true, width: 'given' },
        { skeleton: 'paper', quick: true },
      ] as const;
      const found = silhouetteOf(loops, kernel, usual(kernel), 1, options[seed % options.length]);
      if (found) expectNumbers(found, `${kind}, ${kernel.name}, seed ${seed}`);
    }
  });
});
