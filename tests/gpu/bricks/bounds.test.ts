/** As many bounds as terms, whichever widths of the kernel curves became pieces by. */
import { expect, it } from 'vitest';
import { boundTerms } from '../../../src/field/bind.ts';
import { boundedProgram } from '../../../src/gpu/bricks/bounds.ts';
import { programOf } from '../../../src/gpu/program.ts';
import { BOUND, LEAF } from '../../../src/gpu/structs.ts';
import { widths } from '../../field/widths.ts';

it.each(['cauchy', 'quartic', 'gaussian'])('%s: bounds are those of the terms', (kernel) => {
  const node = widths(kernel);
  for (const skels of [node.skels, [...node.skels].reverse()]) {
    const body = { ...node, skels };
    const program = programOf(body);
    const { records, leaves } = boundedProgram(body, program);
    const pieces = skels.flatMap((term) => boundTerms(term, body));
    // by their own width curves become more pieces, or fewer
    const shared = skels.flatMap(({ params: _, ...term }) => boundTerms(term, body));
    expect(shared.length).not.toBe(pieces.length);
    expect(16 * leaves - program.records.byteLength).toBe(BOUND.stride * pieces.length);
    expect(records.byteLength - 16 * leaves).toBe(LEAF.stride * program.steps.length);
  }
});
