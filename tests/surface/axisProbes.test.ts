import { expect, test } from 'vitest';
import { depthOf, extentOf, probesOf, wayOf } from '../../src/surface/axisProbes.ts';
import { FRONT, probed } from './probed.ts';
import { arc, spineOf, upright } from './sheets.ts';

test('every piece is probed from stop to stop, its ends from inside', () => {
  const spine = { ...spineOf(upright), stops: [0, 0.01, 1] };
  const probes = probesOf(spine, FRONT);
  expect(probes[0]).toMatchObject({ u: 0, side: 1, l: [0, 0] });
  expect(probes.filter(({ u }) => u === 0.01).map(({ side }) => side)).toEqual([-1, 1]);
  expect(probes[probes.length - 1]).toMatchObject({ u: 1, side: -1 });
  expect(probes.every(({ u }, i) => i === 0 || u >= probes[i - 1]!.u)).toBe(true);
  expect(probes.filter(({ u }) => u <= 0.01).length).toBeGreaterThan(9);
});

test('a half circle is π r long and 2 r by r in extent', () => {
  const probes = probed(arc(0, Math.PI));
  expect(Math.abs(wayOf(probes) - 60 * Math.PI)).toBeLessThan(0.01);
  expect(Math.abs(extentOf(probes) - 60 * Math.sqrt(5))).toBeLessThan(0.01);
  expect(Math.abs(depthOf(spineOf(arc(0, Math.PI))) - 60 * Math.sqrt(5))).toBeLessThan(0.2);
});
