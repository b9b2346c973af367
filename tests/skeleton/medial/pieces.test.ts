/** Pieces of a medial axis: as many as the region has, each with its own loops, holes among them. */
import { describe, expect, it } from 'vitest';
import { medialAxis } from '../../../src/skeleton/medial/axis.ts';
import { neighboursOf } from '../../../src/skeleton/medial/branches.ts';
import { edgesOf, isWithin, spaced } from '../../../src/skeleton/medial/outline.ts';
import { joined, piecesOf } from '../../../src/skeleton/medial/pieces.ts';
import { box, disc, shifted } from '../../fixtures/silhouettes.ts';

const ring = [disc(10), disc(4)];
const bar = shifted(box(30, 2), [40, 0]);
const touching = shifted(box(8, 8), [14, 0]);

function piecesAround(loops: Parameters<typeof spaced>[0]) {
  const places = spaced(loops, 200);
  const axis = medialAxis(places);
  return { places, axis, pieces: piecesOf(axis, places) };
}

describe('piecesOf', () => {
  it('one piece is the axis itself', () => {
    const { axis, places, pieces } = piecesAround(ring);
    expect(pieces).toEqual([{ graph: axis, loops: places }]);
  });

  it('nothing is one piece of nothing', () => {
    const axis = medialAxis([]);
    expect(piecesOf(axis, [])).toEqual([{ graph: axis, loops: [] }]);
  });

  it('each has the loops that its circles are in', () => {
    const { axis, places, pieces } = piecesAround([...ring, bar, touching]);
    expect(pieces.map(({ loops }) => loops.map((loop) => places.indexOf(loop))).sort()).toEqual([
      [0, 1],
      [2],
      [3],
    ]);
    for (const { graph, loops } of pieces) {
      for (const { at } of graph.nodes) expect(isWithin(edgesOf(loops), ...at)).toBe(true);
    }
    const whole = joined(pieces.map(({ graph }) => graph));
    expect(whole.nodes).toHaveLength(axis.nodes.length);
    const degrees = (graph: typeof whole) =>
      neighboursOf(graph)
        .map((near, i) => [...graph.nodes[i]!.at, near.length].join(' '))
        .sort();
    expect(degrees(whole)).toEqual(degrees(axis));
  });

  it.each([0, 1e-14, 1e-12])('a loop that is pinched to %f has one: all of its outline', (neck) => {
    const { pieces, axis, places } = piecesAround([
      [
        ...([
          [-20, -5],
          [-2, -5],
          [-1, -neck],
          [1, -neck],
          [2, -5],
          [12, -5],
        ] as const),
        ...([
          [12, 5],
          [2, 5],
          [1, neck],
          [-1, neck],
          [-2, 5],
          [-20, 5],
        ] as const),
      ],
    ]);
    expect(pieces).toEqual([{ graph: axis, loops: places }]);
  });
});
