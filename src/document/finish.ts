/**
 * How a surface answers light (thesis A.3): factors of Phong's equation 7.1, one set for all styles. The defaults are the light that
 * every style has anyway (scene/light.ts), so that a part nobody gave a finish looks as it always did. The thesis sets colours for
 * the three terms; ours are amounts, because a part has one colour, whatever its finish.
 */
import type { Brush } from './document.ts';

export interface Finish {
  /** what light from everywhere is multiplied by */
  readonly ambient: number;
  /** what light from the lamp is multiplied by */
  readonly diffuse: number;
  /** strength of the highlight, 0–1 */
  readonly specular: number;
  /** exponent of the highlight: the larger, the smaller and sharper it is */
  readonly shininess: number;
}

export const DEFAULT_FINISH: Finish = { ambient: 1, diffuse: 1, specular: 0.4, shininess: 40 };

export const FINISH_KEYS = [
  'ambient',
  'diffuse',
  'specular',
  'shininess',
] as const satisfies (keyof Finish)[];

export const sameFinish = (a: Finish, b: Finish): boolean => FINISH_KEYS.every((key) => a[key] === b[key]);

/** As nobody set it. */
export const isPlainFinish = (finish: Finish): boolean => sameFinish(finish, DEFAULT_FINISH);

/** Some of a brush, and some of its finish. */
export interface BrushChange extends Partial<Omit<Brush, 'finish'>> {
  readonly finish?: Partial<Finish>;
}

/** The same brush where nothing changes. */
export function changedBrush(brush: Brush, { finish, ...change }: BrushChange): Brush {
  const next = finish ? { ...brush.finish, ...finish } : brush.finish;
  const keys = Object.keys(change) as (keyof typeof change)[];
  if (keys.every((key) => change[key] === brush[key]) && sameFinish(next, brush.finish)) return brush;
  return { ...brush, ...change, finish: sameFinish(next, brush.finish) ? brush.finish : next };
}
