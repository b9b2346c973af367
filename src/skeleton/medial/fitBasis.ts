/** What each unknown of a fit does at the places of an outline. */
import type { Kernel, KernelParams } from '../../kernel/kernel.ts';
import type { Vec2 } from '../../math/vec.ts';
import { bindSkel } from '../index.ts';
import type { MedialGraph } from './axis.ts';
import { type Layout, layoutOf, type Part } from './skelsOf.ts';

/** Of each place: value, ∂x, ∂y of each unknown by itself, with a relative weight of 1. */
export type Basis = readonly Float64Array[];

export function basisAt(
  { parts, nodes }: Layout,
  scales: readonly number[],
  places: readonly Vec2[],
  kernel: Kernel,
  params: KernelParams,
): Basis {
  const rows = places.map(() => new Float64Array(3 * nodes.length));
  const out = new Float64Array(4);
  for (const { skel, unknowns } of parts) {
    unknowns.forEach((unknown, k) => {
      const field = bindSkel(skel(unknowns.map((_, i) => (i === k ? scales[unknown]! : 0))), kernel, params);
      places.forEach(([px, py], at) => {
        out.fill(0);
        field.add(px, py, 0, 1, out);
        const row = rows[at]!;
        for (let i = 0; i < 3; i++) row[3 * unknown + i]! += out[i]!;
      });
    });
  }
  return rows;
}

/** The field with these relative weights, and how steep it is. */
export function fieldOf(row: Float64Array, x: readonly number[]): { value: number; slope: number } {
  let [value, dx, dy] = [0, 0, 0];
  x.forEach((weight, i) => {
    value += weight * row[3 * i]!;
    dx += weight * row[3 * i + 1]!;
    dy += weight * row[3 * i + 2]!;
  });
  return { value, slope: Math.sqrt(dx * dx + dy * dy) };
}

/** radii by which a node is moved to see what that does */
const NUDGE = 0.01;

/** Of each place: what the field gains as each node moves by a radius, to the right and up. */
export function shiftsAt(
  graph: MedialGraph,
  scales: readonly number[],
  x: readonly number[],
  places: readonly Vec2[],
  kernel: Kernel,
  params: KernelParams,
): readonly Float64Array[] {
  const rows = places.map(() => new Float64Array(2 * graph.nodes.length));
  const weights = x.map((weight, i) => weight * scales[i]!);
  const { parts, nodeOf } = layoutOf(graph);
  graph.nodes.forEach((node, i) => {
    const touched = parts.flatMap((part, k) =>
      part.unknowns.some((unknown) => nodeOf[unknown] === i) ? [k] : [],
    );
    const before = valuesOf(
      touched.map((k) => parts[k]!),
      weights,
      places,
      kernel,
      params,
    );
    for (const axis of [0, 1]) {
      const at = node.at.map((value, d) => value + (d === axis ? NUDGE * node.radius : 0)) as unknown as Vec2;
      const nodes = graph.nodes.map((other, j) => (j === i ? { at, radius: node.radius } : other));
      const moved = layoutOf({ nodes, links: graph.links }).parts;
      const after = valuesOf(
        touched.map((k) => moved[k]!),
        weights,
        places,
        kernel,
        params,
      );
      for (const [place, row] of rows.entries()) row[2 * i + axis] = (after[place]! - before[place]!) / NUDGE;
    }
  });
  return rows;
}

function valuesOf(
  parts: readonly Part[],
  weights: readonly number[],
  places: readonly Vec2[],
  kernel: Kernel,
  params: KernelParams,
): Float64Array {
  const sums = new Float64Array(places.length);
  for (const { skel, unknowns } of parts) {
    const field = bindSkel(skel(unknowns.map((i) => weights[i]!)), kernel, params);
    places.forEach(([px, py], at) => {
      sums[at]! += field.value(px, py, 0);
    });
  }
  return sums;
}
