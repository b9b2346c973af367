import { expect, test } from 'vitest';
import { graphOf, rowsOf } from '../../../src/document/form/chains.ts';

const row = (count: number, y: number) =>
  Array.from({ length: count }, (_, i) => ({ at: [i, y + i * i] as const, radius: 1 }));

test('rows come back as they were, closed ones closed, lone ones alone', () => {
  const rows = [
    { nodes: row(4, 0), closed: false },
    { nodes: row(5, 50), closed: true },
    { nodes: row(1, 99), closed: false },
  ];
  const back = rowsOf(graphOf(rows));
  const told = (all: typeof back) => all.map(({ nodes, closed }) => `${nodes.length} ${closed}`).sort();
  expect(told(back)).toEqual(told(rows));
  const open = back.find(({ nodes }) => nodes.length === 4)!;
  expect([rows[0]!.nodes, [...rows[0]!.nodes].reverse()]).toContainEqual(open.nodes);
});

test('of nothing nothing', () => {
  expect(rowsOf(graphOf([]))).toEqual([]);
  expect(graphOf([{ nodes: [], closed: true }])).toEqual({ nodes: [], links: [] });
});
