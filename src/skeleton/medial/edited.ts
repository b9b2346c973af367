/** Skels of a skeleton that was edited by hand. */
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import type { MedialGraph } from './axis.ts';
import type { Silhouette, SilhouetteOptions } from './silhouette.ts';

export function skeletonSkels(
  _graph: MedialGraph,
  _kernel: Kernel,
  _params: KernelParams,
  _threshold: number,
  _options: SilhouetteOptions = {},
): Silhouette | null {
  return null;
}
