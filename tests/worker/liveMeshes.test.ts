/** The bodies that a worker keeps for edits: by name and cells, and not more than there is room for. */
import { expect, test } from 'vitest';
import { LiveMeshes } from '../../src/worker/liveMeshes.ts';
import { sphere } from '../field/trees.ts';

test('each name has one mesh, of the cells that it was asked for in last', () => {
  const kept = new LiveMeshes();
  const mesh = kept.at('a', 16);
  expect(kept.at('a', 16)).toBe(mesh);
  expect(kept.known('a', 24)).toBeNull();
  expect(kept.at('b', 16)).not.toBe(mesh);
  expect(kept.at('a', 24)).not.toBe(mesh);
  expect(kept.known('a', 16)).toBeNull();
});

test('those that were asked for longest ago go where all are too many bricks', () => {
  const alone = new LiveMeshes();
  alone.at('a', 24).make(sphere(10));
  const { size } = alone.known('a', 24)!;
  expect(size).toBeGreaterThan(50);
  const kept = new LiveMeshes(3.5 * size);
  const make = (name: string) => {
    kept.at(name, 24).make(sphere(10));
    kept.trim();
  };
  for (const name of ['a', 'b', 'c', 'a', 'd']) make(name);
  expect(kept.names).toEqual(['c', 'a', 'd']);
  kept.at('c', 64).make(sphere(10));
  kept.trim();
  // larger than all that there is room for, it goes itself
  expect(kept.names).not.toContain('c');
});
