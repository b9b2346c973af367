/** What a worker keeps of the bodies that rays were cast onto: parts that are moved are not looked for, of those that are edited little is. */
import { describe, expect, test } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import type { LiveStep } from '../../src/field/liveField.ts';
import type { FieldNode, SkelsNode, Term } from '../../src/field/node.ts';
import type { RayCamera } from '../../src/field/rayImage.ts';
import { emptyImage, SceneCaster } from '../../src/field/rayScene.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import { LocatedBodies } from '../../src/worker/locatedBodies.ts';
import { finished } from '../field/finished.ts';
import { sphere } from '../field/trees.ts';

const point = (i: number, weight = 1): Term => ({ skel: { type: 'point', at: [5 * i - 57, 0, 0], weight } });
const POINTS = Array.from({ length: 24 }, (_, i) => point(i));
const MIDDLE = [1, 0.95, 0.9].map((weight) => point(11, weight));

/** A row of points with finite support, one in the middle with another weight; the others are the same objects. */
const row = (middle: number): SkelsNode => ({
  type: 'skels',
  kernel: 'quartic',
  params: { R: 8 },
  threshold: 0.3,
  skels: POINTS.with(11, MIDDLE[middle]!),
});

const asked = (name: string, key: number, node: FieldNode, cells = 96) => ({ name, key, node, cells });

const CAMERA: RayCamera = {
  view: { pivot: [0, 0, 0], rotation: [0, 0, 0, 1], height: 24, fov: 0 },
  width: 96,
  height: 32,
  offset: [0.5, 0.5],
};

function pictureOf(located: LiveStep): Float32Array {
  const image = emptyImage(CAMERA);
  const caster = new SceneCaster([{ located, placement: UNMOVED }], CAMERA);
  for (let y = 0; y < CAMERA.height; y++) caster.row(image, y);
  return image.surface;
}

describe('bodies that are kept', () => {
  test('are the same for the same tree, wherever the part is and whatever its name', () => {
    const kept = new LocatedBodies();
    const node = row(0);
    const first = finished(kept.locating(asked('a', 1, node)));
    const { work } = first.tally;
    expect(finished(kept.locating(asked('a', 1, node)))).toBe(first);
    expect(finished(kept.locating(asked('copy', 1, node)))).toBe(first);
    expect(first.tally.work).toBe(work);
    expect(finished(kept.locating(asked('a', 1, node, 64)))).not.toBe(first);
  });

  test('are made anew where an edit reaches, and show what was edited, back and forth', () => {
    const kept = new LocatedBodies();
    const first = finished(kept.locating(asked('a', 1, row(0))));
    const anew = { work: first.tally.work, bricks: first.bricks.active.length };
    for (const [middle, key] of [
      [1, 2],
      [2, 3],
      [1, 2],
      [0, 1],
    ] as const) {
      const node = row(middle);
      expect(kept.isEdit(asked('a', key, node))).toBe(true);
      const { renewed, whole, tally, bricks } = finished(kept.locating(asked('a', key, node)));
      expect(renewed.size).toBeGreaterThan(0);
      expect(renewed.size).toBeLessThan(0.25 * anew.bricks);
      expect(tally.work).toBeLessThan(0.3 * anew.work);
      const field = bindField(node);
      const image = emptyImage(CAMERA);
      const caster = new SceneCaster([{ located: { whole, tally, bricks }, placement: UNMOVED }], CAMERA);
      let hits = 0;
      for (let y = 0; y < 32; y++) caster.row(image, y);
      for (let at = 0; at < 96 * 32; at++) {
        if (image.colours[4 * at + 3] === 0) continue;
        hits++;
        const [x, y] = [((at % 96) + 0.5 - 48) * 0.75, (16 - Math.floor(at / 96) - 0.5) * 0.75];
        const off = field.value(x, y, image.surface[4 * at + 3]!);
        // a thousandth of a millimetre; slopes are about 0.1
        expect(Math.abs(off)).toBeLessThan(1e-3);
      }
      expect(hits).toBeGreaterThan(300);
    }
  });

  test.each(['first', 'last'])(
    'of two parts with one tree the one edited %s leaves the other as it was',
    (order) => {
      const kept = new LocatedBodies();
      const [before, after] = [row(0), row(1)];
      const names = order === 'first' ? ['edited', 'other'] : ['other', 'edited'];
      const pair = names.map((name) => finished(kept.locating(asked(name, 1, before))));
      expect(pair[0]).toBe(pair[1]);
      kept.trim(names);
      expect(kept.names).toEqual(names);
      const alone = pictureOf(pair[0]!);
      // as a worker does it, in the order of the picture
      for (let edit = 0; edit < 2; edit++) {
        const all = names.map((name) => {
          const [key, node] = name === 'other' ? [1, before] : edit === 0 ? [2, after] : [3, row(2)];
          return { name, step: finished(kept.locating(asked(name, key, node))) };
        });
        const [one, two] = all as [(typeof all)[0], (typeof all)[0]];
        expect(one.step.tally).not.toBe(two.step.tally);
        for (const { name, step } of all) {
          if (name === 'other') expect(pictureOf(step)).toEqual(alone);
          else expect(pictureOf(step)).not.toEqual(alone);
          // once they are two an edit is one again
          if (name === 'edited') expect(step.isEdit).toBe(edit === 1);
          else expect(step).toBe(pair[0]);
        }
        kept.trim(names);
      }
    },
  );

  test('a part that is gone keeps no other of its tree from being edited', () => {
    const kept = new LocatedBodies();
    for (const name of ['gone', 'a']) finished(kept.locating(asked(name, 1, row(0))));
    expect(kept.isEdit(asked('a', 2, row(1)))).toBe(false);
    kept.trim(['a']);
    expect(kept.names).toEqual(['a']);
    expect(kept.isEdit(asked('a', 2, row(1)))).toBe(true);
  });

  test('are located anew in other cells, and after a tree that has no field', () => {
    const kept = new LocatedBodies();
    const bad: FieldNode = { ...row(0), kernel: 'nobody' as SkelsNode['kernel'] };
    expect(() => finished(kept.locating(asked('a', 1, bad)))).toThrow(/nobody/);
    expect(kept.isEdit(asked('a', 2, row(0)))).toBe(false);
    const { renewed, bricks } = finished(kept.locating(asked('a', 2, row(0))));
    expect(renewed.size).toBe(bricks.active.length);
    expect(kept.isEdit(asked('a', 3, row(1), 64))).toBe(false);
  });

  test('go where they are not in the picture and all are too many bricks, the longest unused first', () => {
    const size = finished(new LocatedBodies().locating(asked('a', 1, sphere(10), 24))).bricks.active.length;
    const kept = new LocatedBodies(1.5 * size);
    for (const [i, name] of ['a', 'b', 'c', 'd', 'e'].entries())
      finished(kept.locating(asked(name, i, sphere(10 + i), 24)));
    kept.trim(['a', 'b']);
    expect(kept.names).toEqual(['a', 'b', 'e']);
  });
});
