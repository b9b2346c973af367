/** Terms with a kernel width of their own: the sum of the bodies that each would be. */
import { describe, expect, it } from 'vitest';
import { bindField } from '../../src/field/bind.ts';
import { polygonize } from '../../src/field/polygonize.ts';
import { topology } from '../../src/mesh/check.ts';
import { points } from './trees.ts';
import { widths } from './widths.ts';

describe('a sum of several widths', () => {
  it.each(['cauchy', 'quartic', 'gaussian'])('%s: adds up (300 points, seed 3)', (kernel) => {
    const node = widths(kernel);
    const whole = bindField(node);
    const parts = node.skels.map(({ params, ...term }) =>
      bindField({ ...node, params: params ?? node.params, skels: [term] }),
    );
    for (const p of points(300, 25, 3)) {
      const sum = parts.reduce((total, part) => total + part.value(...p) + node.threshold, -node.threshold);
      expect(whole.value(...p)).toBeCloseTo(sum, 12);
    }
  });

  it.each(['cauchy', 'quartic'])('%s: its mesh is closed and lies on the surface', (kernel) => {
    const node = widths(kernel);
    const field = bindField(node);
    const { mesh } = polygonize(field, 64);
    expect(topology(mesh).watertight).toBe(true);
    const out = new Float64Array(4);
    let worst = 0;
    for (let i = 0; i < mesh.positions.length; i += 3) {
      field.evaluate(mesh.positions[i]!, mesh.positions[i + 1]!, mesh.positions[i + 2]!, out);
      worst = Math.max(worst, Math.abs(out[0]!) / Math.hypot(out[1]!, out[2]!, out[3]!));
    }
    // a cell is half a millimetre and more
    expect(worst).toBeLessThan(0.02);
  });

  it('refuses parameters that the kernel has not, with the place', () => {
    const node = widths('cauchy');
    const skels = [...node.skels, { ...node.skels[0]!, params: { R: 3 } }];
    expect(() => bindField({ ...node, skels })).toThrow(
      "skels[5].params: kernel cauchy has no parameter 'R'",
    );
  });
});
