/** The kinds of skels: one line each is the registry; the conformance suite runs over it. */
import type { Kernel, KernelParams } from '../kernel/kernel.ts';
import { point } from './point.ts';
import { polygon } from './polygon.ts';
import { segment } from './segment.ts';
import type { Skeleton, SkelField } from './skeleton.ts';
import type { Skel } from './skels.ts';

type Skeletons = { readonly [K in Skel['type']]: Skeleton<Extract<Skel, { readonly type: K }>> };

export const skeletons: Skeletons = { point, segment, polygon };

/** The field of one skel; throws FieldError for what has none. */
export function bindSkel(skel: Skel, kernel: Kernel, params: KernelParams): SkelField {
  switch (skel.type) {
    case 'point':
      return point.bind(skel, kernel, params);
    case 'segment':
      return segment.bind(skel, kernel, params);
    case 'polygon':
      return polygon.bind(skel, kernel, params);
  }
}
