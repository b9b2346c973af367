/** The command line's Chromium is that of the tests: pictures of both are comparable. */
import { afterEach, describe, expect, it, vi } from 'vitest';
import * as scripts from '../../scripts/chromium.mjs';
import { findChromium, QUIET, SOFTWARE_WEBGPU } from '../../src/cli/chromium.ts';

afterEach(() => vi.unstubAllEnvs());

describe('chromium', () => {
  it('is started with the same flags', () => {
    expect(SOFTWARE_WEBGPU).toEqual(scripts.SOFTWARE_WEBGPU);
    expect(QUIET).toEqual(scripts.QUIET);
  });

  it.each([undefined, process.execPath, '/nowhere/chromium'])(
    'is found in the same place, CHROMIUM = %s',
    (named) => {
      vi.stubEnv('CHROMIUM', named);
      expect(findChromium()).toBe(scripts.findChromium());
      if (named) expect(findChromium()).toBe(named === process.execPath ? named : null);
    },
  );
});
