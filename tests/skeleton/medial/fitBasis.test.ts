/** Gauss points against the fields themselves. */
import { describe, expect, it } from 'vitest';
import { kernels } from '../../../src/kernel/index.ts';
import { bindSkel } from '../../../src/skeleton/index.ts';
import type { MedialGraph } from '../../../src/skeleton/medial/axis.ts';
import { basisAt } from '../../../src/skeleton/medial/fitBasis.ts';
import { layoutOf, skelsWith } from '../../../src/skeleton/medial/skelsOf.ts';

const bent: MedialGraph = {
  nodes: [
    { at: [-12, 3], radius: 4 },
    { at: [0, 0], radius: 6 },
    { at: [9, 8], radius: 5 },
  ],
  links: [
    [0, 1],
    [1, 2],
  ],
};
const WEIGHTS = [0.4, 1.1, 0.7, 0.2, 0.1, 0.3];
/** about a radius away, and one over a node */
const PLACES = [
  [-16, 3, 0],
  [-5, 8, 0],
  [2, -6, 0],
  [12, 12, 0],
  [4, 9, 0],
  [0, 0, 6],
];

function fieldOf(graph: MedialGraph, kernel: (typeof kernels)[number], x: readonly number[]) {
  const layout = layoutOf(graph);
  const scales = layout.nodes.map(() => 1);
  // between all that is about: no support ends among the places
  const params =
    kernel.support < Infinity ? { R: 40 } : kernel.params.some(({ name }) => name === 's') ? { s: 0.15 } : {};
  const weights = x.slice(0, layout.nodes.length);
  const fields = skelsWith(layout, scales, weights).map((skel) => bindSkel(skel, kernel, params));
  const at = Float64Array.from(PLACES.flat());
  return { basis: basisAt(graph, layout, scales, at, kernel, params, weights), weights, fields };
}

const moved = (node: number, [dx, dy]: readonly [number, number]): MedialGraph => ({
  ...bent,
  nodes: bent.nodes.map((n, i) => (i === node ? { ...n, at: [n.at[0] + dx, n.at[1] + dy] as const } : n)),
});

describe.each(kernels.map((kernel) => [kernel.name, kernel] as const))('basisAt, %s', (_, kernel) => {
  const { basis, weights, fields } = fieldOf(bent, kernel, WEIGHTS);
  const sum = (row: Float64Array, place: number) =>
    weights.reduce((all, weight, i) => all + weight * row[place * weights.length + i]!, 0);

  it('sums up to the field and its gradient', () => {
    PLACES.forEach(([x, y, z], place) => {
      const out = new Float64Array(4);
      for (const field of fields) field.add(x!, y!, z!, 1, out);
      const slope = Math.hypot(out[1]!, out[2]!, out[3]!);
      expect(Math.abs(sum(basis.value, place) / out[0]! - 1)).toBeLessThan(5e-3);
      [basis.dx, basis.dy, basis.dz].forEach((row, axis) => {
        expect(Math.abs(sum(row, place) - out[axis + 1]!)).toBeLessThan(2e-2 * slope);
      });
    });
  });

  it('tells what moves of nodes do', () => {
    for (const [node, { radius }] of bent.nodes.entries()) {
      for (const axis of [0, 1] as const) {
        const by = (step: number) => moved(node, axis === 0 ? [step, 0] : [0, step]);
        const value = (step: number, place: number) => {
          const there = fieldOf(by(step), kernel, WEIGHTS);
          return there.weights.reduce(
            (all, weight, i) => all + weight * there.basis.value[place * there.weights.length + i]!,
            0,
          );
        };
        for (const place of PLACES.keys()) {
          const gain = ((value(1e-4, place) - value(-1e-4, place)) / 2e-4) * radius;
          const found = basis.shifts![2 * (place * bent.nodes.length + node) + axis]!;
          expect(Math.abs(found - gain)).toBeLessThan(1e-4 * (Math.abs(gain) + sum(basis.value, place)));
        }
      }
    }
  });
});
