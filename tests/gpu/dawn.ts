/**
 * WebGPU in Node, by Dawn. No adapter: the suites are skipped by name, loudly, and fail when REQUIRE_GPU=1, so
 * that nobody mistakes an untested GPU half for a tested one.
 */
import { describe, expect, it } from 'vitest';
import { create } from 'webgpu';

// The object made by create() has to stay referenced while any of its devices lives, or the process crashes.
const dawn: { gpu: GPU | null } = { gpu: create([]) as GPU };

export function dawnGpu(): GPU {
  if (!dawn.gpu) throw new Error('Dawn was already closed');
  return dawn.gpu;
}

/** Lets Node exit; call it after the last suite. */
export function closeDawn(): void {
  dawn.gpu = null;
}

const adapter = await dawnGpu().requestAdapter();

/** A suite that needs an adapter. */
export function describeGpu(name: string, suite: () => void): void {
  if (adapter) {
    describe(name, suite);
  } else if (process.env.REQUIRE_GPU === '1') {
    describe(name, () => it('has a graphics adapter', () => expect(adapter, 'REQUIRE_GPU=1').not.toBeNull()));
  } else {
    console.warn(`SKIPPED, no graphics adapter: ${name}`);
    describe.skip(`${name} (no graphics adapter)`, suite);
  }
}
