/**
 * What a mesh on the GPU asks of skels, counted on the CPU from its bricks, because counting on the device would cost more than it tells. Points
 * on creases count as vertices. Not counted: nodes whose sign the list leaves in doubt, which are asked of all skels; and shapes that
 * others outdo in a brick, which the device asks all the same. Both are few.
 */
import { BEFORE, inCommon } from '../../field/brickNodes.ts';
import { around, type Bricks } from '../../field/bricks.ts';
import { SIDE } from '../../field/hermite.ts';
import type { Near } from '../../field/near.ts';
import { WITH_GRADIENT } from '../../skeleton/work.ts';

export interface GpuWork {
  /** the values at all nodes, each by the list of the brick that owns it */
  readonly nodes: number;
  /** of a vertex, by the mean of the lists */
  readonly aVertex: number;
}

/** Newton's steps of nearly all vertices, each with a gradient, and a value for the colour (shaders/polygonize/crossing.wgsl). */
export const ASKED_A_VERTEX = 2 * WITH_GRADIENT + 1;

const SAME_CORNERS = inCommon(SIDE);

/** In values of one skel at one point. */
export function gpuWork(bricks: Bricks): GpuWork {
  const near = new Int32Array(27);
  let [nodes, listed] = [0, 0];
  for (const brick of bricks.active) {
    const asked = askedOf(brick.near);
    around(bricks, brick, near);
    const hasOwner = (before: number) => before < BEFORE && near[before]! >= 0;
    nodes += asked * SAME_CORNERS.filter((common) => !common.some(({ brick: b }) => hasOwner(b))).length;
    listed += asked;
  }
  return { nodes, aVertex: (ASKED_A_VERTEX * listed) / Math.max(1, bricks.active.length) };
}

/** A value in that brick. */
function askedOf(near: Near): number {
  let asked = 0;
  near.eachLeaf(({ terms, dropped }) => {
    asked += terms?.length ?? (dropped === null ? 1 : 0);
  });
  return asked;
}
