/** Solids in numbers: each part's, and all of them together. */
import type { Solid } from '../document/build.ts';
import { topology } from '../mesh/check.ts';
import { area, bounds, volume } from '../mesh/measure.ts';
import type { Box } from '../mesh/mesh.ts';

export interface Measures {
  /** in the mesh: copies at creases and seams count */
  readonly vertices: number;
  readonly triangles: number;
  /** judged by position */
  readonly watertight: boolean;
  /** null when it is not watertight */
  readonly genus: number | null;
  /** mm³ */
  readonly volume: number;
  /** mm² */
  readonly area: number;
  /** mm */
  readonly bounds: Box;
}

export interface PartMeasures extends Measures {
  readonly name: string;
}

export function measuresOf({ name, mesh }: Solid): PartMeasures {
  const { watertight, genus } = topology(mesh);
  return {
    name,
    vertices: mesh.positions.length / 3,
    triangles: mesh.indices.length / 3,
    watertight,
    genus: watertight ? genus : null,
    volume: volume(mesh),
    area: area(mesh),
    bounds: bounds(mesh),
  };
}

/** Sums over the parts: where they overlap volume and area count twice. Watertight when all are. */
export function total(parts: readonly Measures[]): Measures {
  const sum = (of: (part: Measures) => number): number =>
    parts.reduce((before, part) => before + of(part), 0);
  const watertight = parts.every((part) => part.watertight);
  return {
    vertices: sum(({ vertices }) => vertices),
    triangles: sum(({ triangles }) => triangles),
    watertight,
    genus: watertight ? sum(({ genus }) => genus ?? 0) : null,
    volume: sum(({ volume }) => volume),
    area: sum(({ area }) => area),
    bounds: parts.map(({ bounds }) => bounds).reduce(around),
  };
}

function around(a: Box, b: Box): Box {
  const edge = (pick: (x: number, y: number) => number, key: keyof Box) =>
    [0, 1, 2].map((k) => pick(a[key][k]!, b[key][k]!)) as unknown as Box['min'];
  return { min: edge(Math.min, 'min'), max: edge(Math.max, 'max') };
}
