/** More rays at edges: against casting all pixels again. */
import { describe, expect, it } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { locating } from '../../src/field/polygonize.ts';
import { edgesOf, imageThrough, OFFSETS } from '../../src/field/rayEdges.ts';
import { NOWHERE, type RayCamera, type RayImage } from '../../src/field/rayImage.ts';
import { emptyImage, SceneCaster, type Standing } from '../../src/field/rayScene.ts';
import { type Placement, UNMOVED } from '../../src/math/placement.ts';
import { finished } from './finished.ts';
import { placed } from './trees.ts';

const NODE: FieldNode = {
  type: 'union',
  form: 'hard',
  parts: [
    { type: 'shape', shape: { type: 'torus', ring: 20, tube: 6 }, colour: [0.8, 0.1, 0.1] },
    { type: 'shape', shape: { type: 'box', half: [8, 8, 12] }, colour: [0.1, 0.1, 0.8] },
  ],
};
const BODIES: readonly Standing[] = [
  { located: finished(locating(bindField(NODE), 48)), placement: UNMOVED },
];

const turned = [0.3, 0.2, 0, Math.sqrt(0.87)] as const;
const camera = (fov: number): RayCamera => ({
  view: { pivot: [0, 0, 0], rotation: turned, height: 70, fov },
  width: 90,
  height: 70,
  offset: [0.5, 0.5],
});

function cast(through: RayCamera): RayImage {
  const image = emptyImage(through);
  const caster = new SceneCaster(BODIES, through);
  for (let y = 0; y < through.height; y++) caster.row(image, y);
  return image;
}

/** 50 mm upright, mm of radius. */
const NEEDLES: Readonly<Record<string, (radius: number) => FieldNode>> = {
  capsule: (radius) => ({ type: 'shape', shape: { type: 'capsule', radius, half: 25 } }),
  // −threshold from twice its radius on
  segment: (radius) => {
    const node = (threshold: number): FieldNode => ({
      type: 'skels',
      kernel: 'quartic',
      params: { R: 2 * radius },
      threshold,
      skels: [{ skel: { type: 'segment', a: [0, -25, 0], b: [0, 25, 0], weights: [1, 1] } }],
    });
    return node(bindField(node(1e-9)).value(radius, 0, 0));
  },
};
const WALL = placed({ type: 'shape', shape: { type: 'box', half: [90, 90, 5] } }, 0, 0, -45);
const TURN = { rotation: [0, 0, Math.sin(0.2), Math.cos(0.2)], translation: [0.4, 0, 0] } as const;

describe('a needle thinner than a pixel', () => {
  const standing = (node: FieldNode, placement: Placement = TURN): Standing => ({
    located: finished(locating(bindField(node), 64)),
    placement,
  });
  const before: Readonly<Record<string, (needle: FieldNode) => readonly Standing[]>> = {
    nothing: (needle) => [standing(needle)],
    'a wall of the same body': (needle) => [standing({ type: 'union', form: 'hard', parts: [needle, WALL] })],
    'another body': (needle) => [standing(needle), standing(WALL, UNMOVED)],
    'a body before it in the list': (needle) => [standing(WALL, UNMOVED), standing(needle)],
  };
  const front = (fov: number): RayCamera => ({
    ...camera(fov),
    view: { ...camera(fov).view, rotation: [0, 0, 0, 1] },
  });
  const cases = Object.keys(NEEDLES).flatMap((kind) =>
    Object.keys(before).flatMap((behind) =>
      [0, 40].flatMap((fov) => [0.45, 0.1].map((thick) => [kind, behind, fov, thick] as const)),
    ),
  );

  it.each(cases)(
    '%s before %s, opening %d°, %d pixels thick, is a line without gaps in what is looked at again',
    (kind, behind, fov, thick) => {
      const bodies = before[behind]!(NEEDLES[kind]!(0.5 * thick));
      const through = front(fov);
      const image = emptyImage(through);
      const caster = new SceneCaster(bodies, through);
      for (let y = 0; y < through.height; y++) caster.row(image, y);
      const edges = edgesOf(image, through);
      // some pixels to its sides (92 to 141 of them), more in larger bricks, whose bounds are looser: with a wall of the same body a segment's, which
      // are of sums, say of 1,118 to 1,178 pixels that it may be there; the wall fills the picture, and has no edges
      const isLoose = kind === 'segment' && behind === 'a wall of the same body';
      expect(edges.length).toBeLessThan(isLoose ? 25 * 50 : 4 * 50);
      let met = 0;
      for (const offset of OFFSETS) {
        const again = new SceneCaster(bodies, { ...through, offset });
        for (const at of edges) {
          const one = emptyImage({ width: 1, height: 1 });
          again.pixel(one, 0, at % 90, Math.floor(at / 90));
          if (one.surface[3]! > -10) met++;
        }
      }
      // what its middle line comes through
      for (let y = -22; y <= 22; y += 0.25) {
        const x = 0.4 - Math.tan(0.4) * y;
        const at = Math.floor(35 - y) * 90 + Math.floor(45 + x);
        expect(edges.includes(at), `at ${y}`).toBe(true);
      }
      // of the rays through a band as wide as it is thick
      const expected = (OFFSETS.length * thick * 50) / 1;
      expect(met).toBeGreaterThan(0.6 * expected);
      expect(met).toBeLessThan(1.5 * expected);
    },
  );
});

describe.each([0, 40])('opening %d°', (fov) => {
  const base = cast(camera(fov));
  const edges = edgesOf(base, camera(fov));

  it('finds edges and little else', () => {
    const hits = base.surface.filter((value, i) => i % 4 === 3 && value !== NOWHERE).length;
    expect(hits).toBeGreaterThan(500);
    expect(edges.length).toBeGreaterThan(100);
    // .638 orthographic, .618 in perspective: so small a picture of rings, creases and corners is half edges
    expect(edges.length).toBeLessThan(0.65 * hits);
    expect([...edges]).toEqual([...edges].sort((a, b) => a - b));
  });

  it.each(OFFSETS)('gives what all rays through %d, %d of the pixels give', (x, y) => {
    const through = { ...camera(fov), offset: [x, y] as const };
    const truth = cast(through);
    const again = emptyImage({ width: edges.length, height: 1 });
    const caster = new SceneCaster(BODIES, through);
    for (const [i, at] of edges.entries()) caster.pixel(again, i, at % 90, Math.floor(at / 90));
    const image = imageThrough(base, camera(fov), edges, { offset: [x, y], ...again });
    const pixel = 70 / 70;
    for (let at = 0; at < 90 * 70; at++) {
      const [found, expected] = [image.surface[4 * at + 3]!, truth.surface[4 * at + 3]!];
      expect(found === NOWHERE, `pixel ${at}`).toBe(expected === NOWHERE);
      // what the curvature of a tube of 6 mm makes of a pixel of 1 mm
      if (expected !== NOWHERE) expect(Math.abs(found - expected), `pixel ${at}`).toBeLessThan(0.4 * pixel);
    }
  });
});
