/** Parameters that several kernels share. */
import type { ParamSpec } from './kernel.ts';

export const S: ParamSpec = {
  name: 's',
  min: 1e-9,
  max: 1e9,
  default: 0.1,
  help: 'width, 1/mm: the larger, the narrower',
};

export const R: ParamSpec = {
  name: 'R',
  min: 1e-9,
  max: 1e9,
  default: 10,
  help: 'radius of the support, mm: nothing beyond',
};

export const N: ParamSpec = {
  name: 'n',
  min: 1.001,
  max: 8,
  default: 4,
  help: 'smoothness, above 1: the larger, the faster it falls; 4 is the Cauchy kernel',
};
