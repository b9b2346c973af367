import { describe, expect, it } from 'vitest';
import { camera } from '../../src/cli/camera.ts';

describe('camera', () => {
  it('is the drawing’s own view, a side, or angles', () => {
    expect(camera(undefined)).toBeUndefined();
    expect(camera('top')).toBe('top');
    expect(camera('30,-20')).toEqual({ yaw: 30, pitch: -20, roll: 0 });
    expect(camera('-.5,+1.25,90')).toEqual({ yaw: -0.5, pitch: 1.25, roll: 90 });
  });

  it.each(['', 'Top', '30', '1,2,3,4', '1,,2', '1, 2', '1e3,0', 'NaN,0', '0x10,0', '99999,0'])(
    'refuses %j and says what is expected',
    (text) => {
      expect(() => camera(text)).toThrow(/^--camera: expected front.*yaw,pitch/);
      expect(() => camera(text)).toThrow(`'${text}'`);
    },
  );
});
