/** Pictures as they are asked for: sizes, sides and angles, and what is refused. */
import { describe, expect, it } from 'vitest';
import { apply } from '../../src/document/command/index.ts';
import { EMPTY_DOCUMENT } from '../../src/document/document.ts';
import { FRONT_VIEW } from '../../src/document/drawing.ts';
import { DEFAULT_LOOK } from '../../src/document/look.ts';
import { FileError } from '../../src/document/serialize.ts';
import { type Angles, type Now, pictureOptions, type Shot } from '../../src/element/shot.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { axes } from '../../src/scene/view.ts';
import { strokeAlong } from '../document/strokes.ts';

const NOW: Now = {
  document: EMPTY_DOCUMENT,
  view: { ...FRONT_VIEW, height: 77 },
  look: DEFAULT_LOOK,
  width: 320,
  height: 200,
  fit: false,
};

const rotation = (camera: NonNullable<Shot['camera']>) => pictureOptions({ camera }, NOW).view.rotation;

const close = (found: Vec3, wanted: Vec3) =>
  found.forEach((value, i) => {
    expect(value).toBeCloseTo(wanted[i]!, 12);
  });

describe('a shot', () => {
  it('is what the screen shows unless it says otherwise', () => {
    const { width, height, view, look } = pictureOptions({}, NOW);
    expect({ width, height, view, look }).toEqual({
      width: 320,
      height: 200,
      view: NOW.view,
      look: DEFAULT_LOOK,
    });
    expect(pictureOptions({ style: 'hbed-ink', background: 'white' }, NOW).look).toEqual({
      ...DEFAULT_LOOK,
      style: 'hbed-ink',
      background: 'white',
    });
  });

  it('narrower than usual still shows a model that is whole in a usual one, and what was near stays near', () => {
    const wide = strokeAlong((t) => [-60 + 120 * t, 0]);
    const document = [{ type: 'addStroke', stroke: wide } as const, { type: 'keep' } as const].reduce(
      apply,
      EMPTY_DOCUMENT,
    );
    const heightOf = (height: number, size: Shot) =>
      pictureOptions(size, { ...NOW, document, view: { ...FRONT_VIEW, height } }).view.height;
    expect(heightOf(200, { width: 800, height: 600 })).toBe(200);
    const tall = heightOf(200, { width: 300, height: 900 });
    expect(tall / 3).toBeGreaterThan(120);
    expect(tall / 3).toBeLessThan(150);
    expect(heightOf(60, { width: 300, height: 900 })).toBe(60);
  });

  it('from a side is the shot from its angles', () => {
    const sides: readonly (readonly [NonNullable<Shot['camera']>, Angles])[] = [
      ['front', { yaw: 0, pitch: 0 }],
      ['right', { yaw: 90, pitch: 0 }],
      ['back', { yaw: 180, pitch: 0 }],
      ['left', { yaw: -90, pitch: 0 }],
      ['top', { yaw: 0, pitch: 90 }],
      ['bottom', { yaw: 0, pitch: -90 }],
    ];
    for (const [side, angles] of sides) {
      const wanted = axes(rotation(side));
      axes(rotation(angles)).forEach((axis, i) => {
        close(axis, wanted[i]!);
      });
    }
  });

  it('looks from where yaw and pitch point, and roll turns the picture about that', () => {
    const radians = Math.PI / 180;
    for (const [yaw, pitch] of [
      [30, 20],
      [-140, -65],
      [350, 89],
    ] as const) {
      const [right, , back] = axes(rotation({ yaw, pitch }));
      const level = Math.cos(pitch * radians);
      close(back, [
        Math.sin(yaw * radians) * level,
        Math.sin(pitch * radians),
        Math.cos(yaw * radians) * level,
      ]);
      expect(right[1]).toBeCloseTo(0, 12);
      const [rolled, up, same] = axes(rotation({ yaw, pitch, roll: 90 }));
      close(same, back);
      // A picture turned counter-clockwise has on top what was on its right.
      close(up, right);
      expect(rolled[1]).toBeLessThan(0);
    }
  });

  it('is refused with the place when it cannot be taken', () => {
    const bad: readonly (readonly [place: string, shot: object])[] = [
      ['width', { width: 15 }],
      ['width', { width: 8193 }],
      ['height', { height: 20.5 }],
      ['height', { height: '20' }],
      ['style', { style: 'cubist' }],
      ['background', { background: 'plaid' }],
      ['camera', { camera: 'above' }],
      ['camera.yaw', { camera: {} }],
      ['camera.yaw', { camera: null }],
      ['camera.roll', { camera: { yaw: 0, pitch: 0, roll: Number.NaN } }],
    ];
    for (const [place, shot] of bad) {
      let error: unknown;
      try {
        pictureOptions(shot as Shot, NOW);
      } catch (thrown) {
        error = thrown;
      }
      expect(error, place).toBeInstanceOf(FileError);
      expect((error as FileError).place).toBe(place);
    }
  });
});
