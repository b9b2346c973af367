/** Axes of known spines in a side view that looks along −z, for tests of bends. */
import { type Probe, probesOf } from '../../src/surface/axisProbes.ts';
import { sideView } from '../../src/surface/sideView.ts';
import { type Centre, spineOf } from './sheets.ts';

export const FRONT = sideView({ origin: [0, 0, 0], x: [1, 0, 0], y: [0, 1, 0] });

export const probed = (centre: Centre): Probe[] => probesOf(spineOf(centre), FRONT);

/** Up by 100 mm, with the progress p(u) and its derivative. */
export const upBy = (p: (u: number) => readonly [number, number]): Centre => ({
  at: (u) => {
    const [at, rate] = p(u);
    return [
      [0, 100 * at, 0],
      [0, 100 * rate, 0],
      [0, 0, 0],
    ];
  },
});
