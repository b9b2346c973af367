/**
 * One row across a surface of mixed sections. A stand maps outlines linearly into space, so mixing and placing may as well be done
 * to the control points of outlines as to their points; derivatives along u follow by the product rule.
 */
import type { Mix, Share } from './between.ts';
import { placingAt } from './placing.ts';
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
  const change = blended(forms, shares, 'rate');
  const isPoint = kind === 'points' ? 1 : 0;
  const at = new Float64Array((form.length / 2) * 3);
  const rate = new Float64Array(at.length);
  for (let k = 0; k < 3; k++) {
    const [from, half, depth] = [isPoint * axes.centre[k]!, axes.half[k]!, axes.depth[k]!];
    const [dFrom, dHalf, dDepth] = [isPoint * rates.centre[k]!, rates.half[k]!, rates.depth[k]!];
    for (let j = 0; 2 * j < form.length; j++) {
      const [x, y] = [form[2 * j]!, form[2 * j + 1]!];
      at[3 * j + k] = from + x * half + y * depth;
      rate[3 * j + k] = dFrom + x * dHalf + y * dDepth + (change[2 * j]! * half + change[2 * j + 1]! * depth);
    }
  }
  return { at, rate };
}

function blended(
  forms: readonly (readonly number[])[],
  shares: readonly Share[],
  by: 'weight' | 'rate',
): Float64Array {
  const out = new Float64Array(forms[0]!.length);
  for (const share of shares) {
    const factor = share[by];
    if (factor === 0) continue;
    const form = forms[share.section]!;
    for (let i = 0; i < out.length; i++) out[i]! += factor * form[i]!;
  }
  return out;
}
