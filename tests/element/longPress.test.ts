/** Long presses: pinned once, and no click after them is lost. */
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { LongPress } from '../../src/element/longPress.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

const menu = { preventDefault() {} };
const tap = { detail: 1 };
const key = { detail: 0 };

function press() {
  const deed = vi.fn();
  return { deed, press: new LongPress(deed) };
}

test('a press that lasts is the deed, and its click is none', () => {
  const { deed, press: held } = press();
  held.begin({ button: 0 });
  vi.runAllTimers();
  // a finger that stays is told of a second time
  held.menu(menu);
  held.end();
  expect(deed).toHaveBeenCalledTimes(1);
  expect(held.swallows(tap)).toBe(true);
  expect(held.swallows(tap)).toBe(false);
});

test('a tap is a tap', () => {
  const { deed, press: held } = press();
  held.begin({ button: 0 });
  held.end();
  vi.runAllTimers();
  expect(deed).not.toHaveBeenCalled();
  expect(held.swallows(tap)).toBe(false);
});

test('after the other button the next click, of a key too, counts', () => {
  const { deed, press: held } = press();
  held.begin({ button: 2 });
  vi.runAllTimers();
  held.end();
  held.menu(menu);
  expect(deed).toHaveBeenCalledTimes(1);
  expect(held.swallows(key)).toBe(false);
  held.begin({ button: 0 });
  vi.runAllTimers();
  held.end();
  expect(held.swallows(key)).toBe(false);
});

test('of two elements each has its own, and what is gone does nothing', () => {
  const [one, other] = [press(), press()];
  one.press.begin({ button: 0 });
  other.press.begin({ button: 0 });
  one.press.stop();
  vi.runAllTimers();
  expect(one.deed).not.toHaveBeenCalled();
  expect(other.deed).toHaveBeenCalledTimes(1);
  expect(one.press.swallows(tap)).toBe(false);
});
