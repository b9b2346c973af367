/** The surfaces that forms make, in numbers. */
import type { FormKind, Ink, Shaped, Sum } from '../../../src/document/form/index.ts';
import { bindField } from '../../../src/field/bind.ts';
import type { SkelsNode } from '../../../src/field/node.ts';
import type { TreeField } from '../../../src/field/treeField.ts';
import { kernelNamed } from '../../../src/kernel/index.ts';
import type { Vec3 } from '../../../src/math/vec.ts';

export const THRESHOLD = 0.5;

export interface Formed {
  readonly shaped: Shaped;
  readonly sum: Sum;
  readonly node: SkelsNode;
  readonly field: TreeField;
}

/** As wide as it likes; null where nothing can be made of it. */
export function formed(form: FormKind, ink: Ink, name = 'cauchy'): Formed | null {
  const kernel = kernelNamed(name)!;
  const params = form.width(ink, kernel);
  if (!params) return null;
  const sum = { kernel, params, threshold: THRESHOLD };
  const shaped = form.make(ink, sum);
  if (!shaped) return null;
  const node: SkelsNode = {
    type: 'skels',
    kernel: name,
    params,
    threshold: THRESHOLD,
    skels: shaped.skels.map((skel) => ({ skel })),
  };
  return { shaped, sum, node, field: bindField(node) };
}

/** mm from a place inside to the surface along a unit direction; at most `most`. */
export function depth({ field }: Formed, from: Vec3, way: Vec3, most: number): number {
  const at = (t: number) => field.value(from[0] + t * way[0], from[1] + t * way[1], from[2] + t * way[2]);
  let [low, high] = [0, most];
  for (let i = 0; i < 50; i++) {
    const middle = 0.5 * (low + high);
    if (at(middle) > 0) low = middle;
    else high = middle;
  }
  return low;
}
