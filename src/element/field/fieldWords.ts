/** The words of the field page. */
import type { Made } from '../../field/fieldWork.ts';

const count = (value: number): string => {
  if (value < 10_000) return String(value);
  return value < 1e6 ? `${Math.round(value / 1000)} k` : `${(value / 1e6).toFixed(1)} M`;
};

export const FIELD_WORDS = {
  title: 'Field',
  making: 'Making the body',
  body: (made: Made) =>
    made.mesh.indices.length === 0 ? 'Nothing is inside. A lower T or a larger radius helps' : 'Body made',
  kept: 'Not made. The last body stays',
  none: 'Not made',
  facts: ({ mesh }: Made) =>
    `${count(mesh.indices.length / 3)} triangles · ${count(mesh.positions.length / 3)} vertices`,
  work: ({ evaluations, lattice, difference, milliseconds }: Made) => {
    const where =
      difference === null ? 'CPU, worker' : `GPU float32, off by ${difference.toExponential(1)} at most`;
    const cells = lattice.counts.map((nodes) => nodes - 1).join(' × ');
    const time = Math.max(1, Math.round(milliseconds));
    return `${where} · ${cells} cells · ${count(evaluations)} evaluations · ${time} ms`;
  },
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
  label: (made: Made | null) =>
    made ? `Body of a field. ${count(made.mesh.indices.length / 3)} triangles` : 'Body of a field',
} as const;
