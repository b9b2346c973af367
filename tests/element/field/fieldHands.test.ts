/** Keys on the field page's picture. */
import { describe, expect, test, vi } from 'vitest';
import { FieldHands } from '../../../src/element/field/fieldHands.ts';
import type { CameraRig } from '../../../src/scene/index.ts';

const orbit = vi.fn();
const host = {
  rig: { orbit } as unknown as CameraRig,
  wake: vi.fn(),
  showAll: vi.fn(),
  reset: vi.fn(),
  setStyle: vi.fn((number: number) => number === 2),
  toggleWires: vi.fn(),
  toggleRays: vi.fn(),
  toggleVolumes: vi.fn(),
};
const hands = new FieldHands(host);

/** Whether the key meant something. */
function press(key: string, more: { readonly ctrlKey?: boolean } = {}): boolean {
  const preventDefault = vi.fn();
  hands.key({ key, preventDefault, ...more } as unknown as KeyboardEvent);
  return preventDefault.mock.calls.length > 0;
}

describe('keys', () => {
  test('W shows the triangles, with and without Caps Lock', () => {
    expect([press('w'), press('W')]).toEqual([true, true]);
    expect(host.toggleWires).toHaveBeenCalledTimes(2);
  });

  test('X casts rays', () => {
    expect(press('x')).toBe(true);
    expect(host.toggleRays).toHaveBeenCalledTimes(1);
  });

  test('arrows turn as far as in the application', () => {
    expect(press('ArrowLeft')).toBe(true);
    expect(press('ArrowDown')).toBe(true);
    expect(orbit.mock.calls).toEqual([
      [-24, 0],
      [0, 24],
    ]);
  });

  test('numbers are styles; what means nothing, or belongs to the browser, is left to it', () => {
    expect(press('2')).toBe(true);
    expect([press('9'), press('y'), press('Tab'), press('w', { ctrlKey: true })]).toEqual([
      false,
      false,
      false,
      false,
    ]);
  });
});
