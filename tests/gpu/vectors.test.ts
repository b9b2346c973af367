/** WGSL against the reference vectors, which come from quadrature alone: what `rotund field --backend gpu` does. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, expect, it } from 'vitest';
import { reportsOf } from '../../src/cli/field.ts';
import { gpuEvaluator } from '../../src/cli/gpuEvaluator.ts';
import { readVectors } from '../../src/cli/vectors.ts';
import { closeDawn, dawnGpu, describeGpu } from './dawn.ts';

afterAll(closeDawn);

describeGpu('the reference vectors', () => {
  for (const family of ['point', 'segment', 'polygon']) {
    it(`${family}: WGSL is within the float32 tolerances`, async () => {
      const path = join(import.meta.dirname, '../fixtures/vectors', `${family}.json`);
      const cases = readVectors(readFileSync(path, 'utf8'), path);
      const reports = await reportsOf(
        cases,
        gpuEvaluator((use) => use(dawnGpu())),
      );
      for (const { kernel, valueError, gradientError, worst } of reports) {
        console.info(
          `${family} ${kernel}: ${valueError} ${gradientError}, worst ${worst.index} ${worst.tag}`,
        );
      }
      expect(reports.length).toBeGreaterThan(4);
      expect(reports.filter(({ pass }) => !pass)).toEqual([]);
    });
  }
});
