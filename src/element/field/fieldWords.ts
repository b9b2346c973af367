/** The words of the field page. */
import type { Thin } from '../../field/thin.ts';
import type { Comparison, RayCount } from '../../field/zhuImage.ts';
import type { Shown } from './shown.ts';

const count = (value: number): string => {
  if (value < 10_000) return String(value);
  return value < 1e6 ? `${Math.round(value / 1000)} k` : `${(value / 1e6).toFixed(1)} M`;
};

const rate = ({ evaluationsPerPixel, missed }: RayCount) =>
  `${evaluationsPerPixel < 10 ? evaluationsPerPixel.toFixed(1) : count(Math.round(evaluationsPerPixel))} evaluations a pixel, ${missed}`;

export const FIELD_WORDS = {
  title: 'Field',
  making: 'Making the body',
  body: ({ triangles, thin }: Shown) => {
    if (triangles > 0) return 'Body made';
    return thin
      ? 'All of it is thinner than the cells. More cells show it'
      : 'Nothing is inside. A lower T or a larger radius helps';
  },
  kept: 'Not made. The last body stays',
  none: 'Not made',
  facts: ({ triangles, vertices }: Shown) => `${count(triangles)} triangles · ${count(vertices)} vertices`,
  work: ({ maker, evaluations, lattice, milliseconds }: Shown) => {
    const cells = lattice.counts.map((nodes) => nodes - 1).join(' × ');
    const time = Math.max(1, Math.round(milliseconds));
    return `${maker} · ${cells} cells · ${count(evaluations)} evaluations · mesh after ${time} ms`;
  },
  thin: ({ places, least }: Thin) =>
    `Hardly thicker than a cell in ${places === 1 ? '1 place' : `${places} places`} (${Number(least.toPrecision(2))} mm): finer cells show all of it`,
  compared: ({ hits, zhu, bricks }: Comparison) =>
    `Zhu’s rays, ${rate(zhu)} of ${count(hits)} hits missed · by bricks ${rate(bricks)} missed`,
  /** `reason`: why it is not the graphics device */
  worker: (reason: string | null) => (reason === null ? 'CPU, worker' : `CPU, worker: ${reason}`),
  device: 'GPU, float32',
  deviceFailed: 'the graphics device could not make it',
  noDevice: 'there is no graphics device for it',
  webgl2: 'WebGL2, slower',
  loading: 'Preparing the picture',
  badAddress: (problem: string) => `Not understood in the address: ${problem}. All else there holds.`,
  inverse: '1/r hardly falls off: where there are many pieces, all are thicker than their radii.',
  noWidth: 'It has no width: only weights and T count.',
  plateSection: 'Of a plate y is the normal and z is u: its section is seen from the right.',
  reset: 'Everything as at first',
  copied: 'Tree copied as JSON',
  notCopied: 'Not copied: the browser has to allow this page its clipboard',
  nothingToCopy: 'There is no tree to copy before what is wrong with it is set right',
  noWorker: 'The part of the program that makes bodies could not start. Loading the page again may help.',
  lost: 'The graphics device was lost. The picture comes back.',
  label: (made: Shown | null) =>
    made ? `Body of a field. ${count(made.triangles)} triangles` : 'Body of a field',
} as const;
