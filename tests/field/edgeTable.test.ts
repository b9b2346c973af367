import { expect, test } from 'vitest';
import { EdgeTable } from '../../src/field/edgeTable.ts';
import { random } from '../fixtures/random.ts';

test('is a map of whole numbers, however they lie (seed 71)', () => {
  const next = random(71);
  const table = new EdgeTable();
  const known = new Map<number, number>();
  const edges = [
    0,
    2 ** 31 - 1,
    ...Array.from({ length: 20_000 }, (_, i) => (i % 2 ? 3 * i : Math.floor(next() * 2 ** 31))),
  ];
  edges.forEach((edge, vertex) => {
    expect(table.get(edge)).toBe(known.get(edge) ?? -1);
    table.set(edge, vertex);
    known.set(edge, vertex);
  });
  for (const [edge, vertex] of known) expect(table.get(edge)).toBe(vertex);
  expect(table.get(1)).toBe(known.get(1) ?? -1);
});
