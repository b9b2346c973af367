/**
 * Materials of files: one a colour and a finish. What nobody gave a finish is clay, as it always was: no metal, hardly a gleam. Files that
 * speak of roughness and metal get what comes nearest: strong and sharp highlights are smooth, and those on a dark ground are metal.
 */
import { DEFAULT_FINISH, type Finish, isPlainFinish } from '../document/finish.ts';
import type { FilePart } from './parts.ts';

/** what vertices are painted on */
const WHITE = '#ffffff';

export interface Material {
  /** colour_d9cb4a; with the number of its finish among those of the file, where it has one: colour_d9cb4a_1 */
  readonly name: string;
  /** #rrggbb, display values */
  readonly colour: string;
  readonly finish: Finish;
}

/** One for each part, in their order; parts that look alike share one. */
export function materialsOf(parts: readonly FilePart[]): readonly Material[] {
  const finishes: string[] = [];
  const made = new Map<string, Material>();
  return parts.map(({ colour: own, finish, mesh }) => {
    const colour = mesh.colours ? WHITE : own.toLowerCase();
    const { ambient, diffuse, specular, shininess } = finish;
    const key = JSON.stringify([ambient, diffuse, specular, shininess]);
    if (!isPlainFinish(finish) && !finishes.includes(key)) finishes.push(key);
    const number = isPlainFinish(finish) ? '' : `_${1 + finishes.indexOf(key)}`;
    const name = `colour_${colour.slice(1)}${number}`;
    const material = made.get(name) ?? { name, colour, finish };
    made.set(name, material);
    return material;
  });
}

const within = (value: number, least: number): number => Math.min(1, Math.max(least, value));

/** rough as clay where nobody set anything; polished where highlights are strong and sharp, never a perfect mirror */
export function roughnessOf({ specular, shininess }: Finish): number {
  const sharpness = Math.sqrt(shininess / DEFAULT_FINISH.shininess);
  return within(1 - 0.5 * specular * sharpness, 0.05);
}

/** Metal has a strong highlight and little light of its own. */
export const metalnessOf = ({ ambient, specular }: Finish): number =>
  within(2 * (DEFAULT_FINISH.ambient - ambient), 0) * within(2.5 * (specular - 0.6), 0);
