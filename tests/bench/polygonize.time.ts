/**
 * Surfaces of fields on one thread. `ROTUND_TABLES=scenes,growth`, `ROTUND_CELLS=64,128` and `ROTUND_SCENES=tree64,blob200` choose;
 * `ROTUND_FULL=1` adds 512 cells, a hundred chairs, and the errors of all vertices: many minutes.
 */
import { POLYGONS } from '../fixtures/polygons.ts';
import { timeEdits } from './edits.ts';
import { timeKravtsovOnCpu } from './kravtsov.ts';
import { timeMetaballs } from './metaballs.ts';
import { timeBoxes } from './polygonizeBoxes.ts';
import { timeGrowth, timeScenes } from './polygonizeScenes.ts';
import { LINEAR } from './skels.ts';
import { mixCalls } from './timing.ts';

mixCalls([LINEAR, POLYGONS.star]);
const TABLES: Readonly<Record<string, () => void | Promise<void>>> = {
  boxes: timeBoxes,
  scenes: timeScenes,
  growth: timeGrowth,
  edits: timeEdits,
  metaballs: timeMetaballs,
  kravtsov: timeKravtsovOnCpu,
};
const chosen = process.env.ROTUND_TABLES?.split(',') ?? Object.keys(TABLES);
for (const name of chosen) await TABLES[name]?.();
