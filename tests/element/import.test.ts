/** The element must be importable where there is no DOM: servers render pages too. */
import { describe, expect, it } from 'vitest';

describe('importing the element without a DOM', () => {
  it('has no DOM here', () => {
    expect(typeof globalThis.window).toBe('undefined');
    expect(typeof globalThis.document).toBe('undefined');
  });

  it('gives the class and defines nothing it cannot', async () => {
    const { RotundSketch } = await import('../../src/element/index.ts');
    expect(typeof RotundSketch).toBe('function');
    await expect(import('../../src/element/define.ts')).resolves.toBeDefined();
  });
});
