/**
 * One row across a surface of mixed sections. A stand maps outlines linearly into space, so mixing and placing may as well be done
 * to the control points of outlines as to their points; derivatives along u follow by the product rule.
 */
import type { Vec3 } from '../math/vec.ts';
import type { Mix, Share } from './between.ts';
import { type Axes, placingAt } from './placing.ts';
import type { Source } from './source.ts';

/** A row, x y z, and its derivative by u. */
export interface WovenRow {
  readonly at: Float64Array;
  readonly rate: Float64Array;
}

/**
 * What becomes of outline vectors (x y x y …, one list a section) at u. `kind`: points, or derivatives of points, which have no
 * place.
 */
export function rowAt(
  { source, mix }: { readonly source: Source; readonly mix: Mix },
  forms: readonly (readonly number[])[],
  kind: 'points' | 'vectors',
  u: number,
  side: -1 | 1,
): WovenRow {
  const shares = mix(u, side);
  const { axes, rates } = placingAt(source, u, side);
  const form = blended(forms, shares, 'weight');
  const isPoint = kind === 'points';
  const moved = onStand(rates, form, isPoint);
  const changed = onStand(axes, blended(forms, shares, 'rate'), false);
  return { at: onStand(axes, form, isPoint), rate: moved.map((x, i) => x + changed[i]!) };
}

function blended(
  forms: readonly (readonly number[])[],
  shares: readonly Share[],
  by: 'weight' | 'rate',
): number[] {
  const out = new Array<number>(forms[0]!.length).fill(0);
  for (const share of shares) {
    const factor = share[by];
    if (factor === 0) continue;
    const form = forms[share.section]!;
    for (let i = 0; i < out.length; i++) out[i]! += factor * form[i]!;
  }
  return out;
}

function onStand({ centre, half, depth }: Axes, form: readonly number[], isPoint: boolean): Float64Array {
  const out = new Float64Array((form.length / 2) * 3);
  const from: Vec3 = isPoint ? centre : [0, 0, 0];
  for (let j = 0; 2 * j < form.length; j++) {
    const [x, y] = [form[2 * j]!, form[2 * j + 1]!];
    for (let k = 0; k < 3; k++) out[3 * j + k] = from[k]! + x * half[k]! + y * depth[k]!;
  }
  return out;
}
