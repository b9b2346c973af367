import { describe, expect, it } from 'vitest';
import { marginsInHand, marginsOf } from '../../src/element/margins.ts';
import type { Box } from '../../src/mesh/mesh.ts';
import { AIR, fitted } from '../../src/scene/view.ts';
import { project } from '../../src/stroke/plane.ts';
import type { View } from '../../src/stroke/stroke.ts';

const BOX: Box = { min: [-20, 10, -5], max: [50, 130, 25] };
const VIEWS: readonly View[] = [
  { pivot: [3, 4, 5], rotation: [0, 0, 0, 1], height: 200, fov: 0 },
  { pivot: [0, 0, 0], rotation: [0.3, 0.5, 0.1, Math.sqrt(1 - 0.35)], height: 90, fov: 0 },
  { pivot: [0, 0, 0], rotation: [0.3, 0.5, 0.1, Math.sqrt(1 - 0.35)], height: 90, fov: 30 },
];
const SIZES = [
  { width: 1240, height: 384 },
  { width: 553, height: 300 },
  { width: 390, height: 844 },
  { width: 1280, height: 960 },
];

function* corners({ min, max }: Box) {
  for (const x of [min[0], max[0]])
    for (const y of [min[1], max[1]]) for (const z of [min[2], max[2]]) yield [x, y, z] as const;
}

describe('what is fitted', () => {
  for (const size of SIZES) {
    it(`lies between the controls, ${size.width} × ${size.height}`, () => {
      const margins = marginsOf(size, false, false);
      for (const view of VIEWS) {
        const fit = fitted(view, BOX, size.width / size.height, margins);
        for (const corner of corners(BOX)) {
          const [x, y] = project(fit, size, corner)!;
          // A perspective view that is moved aside sees the box a little askew.
          const slack = view.fov ? 6 : 1e-6;
          expect(x).toBeGreaterThan(margins.left * size.width - slack);
          expect(x).toBeLessThan((1 - margins.right) * size.width + slack);
          expect(y).toBeGreaterThan(margins.top * size.height - slack);
          expect(y).toBeLessThan((1 - margins.bottom) * size.height + slack);
        }
      }
    });
  }

  it('has nothing but air around it where there are no controls', () => {
    expect(marginsOf({ width: 300, height: 200 }, true, false)).toEqual(AIR);
  });

  it('keeps two fifths of a picture that is too small for all of it', () => {
    const { top, bottom } = marginsOf({ width: 300, height: 120 }, false, false);
    expect(1 - top - bottom).toBeCloseTo(0.4, 12);
  });
});

describe('with a card in hand', () => {
  it('a narrow picture keeps clear of the meter and the card, a wide one needs no more', () => {
    const margins = marginsOf({ width: 390, height: 800 }, false, false);
    const held = marginsInHand(margins, { width: 390, height: 800 });
    expect(held.top * 800).toBeGreaterThanOrEqual(120);
    expect(held.bottom * 800).toBeGreaterThanOrEqual(250);
    expect(held.top + held.bottom).toBeLessThan(0.6);
    expect(marginsInHand(margins, { width: 1280, height: 900 })).toBe(margins);
  });
});
