/** Loops of places as a graph whose nodes are linked in cycles, and back: what a plate's skeleton is. */
import type { Vec2 } from '../../math/vec.ts';
import type { MedialGraph, MedialNode } from '../../skeleton/medial/axis.ts';
import { neighboursOf } from '../../skeleton/medial/branches.ts';
import { isInside, type Loop } from '../../skeleton/medial/outline.ts';
import { areaOf } from '../../skeleton/region.ts';

export function graphOfLoops(loops: readonly (readonly MedialNode[])[]): MedialGraph {
  let first = 0;
  const links = loops.flatMap((loop) => {
    const start = first;
    first += loop.length;
    return loop.map((_, i) => [start + i, start + ((i + 1) % loop.length)] as const);
  });
  return { nodes: loops.flat(), links };
}

/** Each link in one cycle at most; what ends somewhere is in none. */
export function cyclesOf(graph: MedialGraph): readonly (readonly MedialNode[])[] {
  const near = neighboursOf(graph).map((others, i) => new Set(others.filter((other) => other !== i)));
  const cycles: number[][] = [];
  const take = (from: number): number | undefined => {
    const [next] = near[from]!;
    if (next !== undefined) {
      near[from]!.delete(next);
      near[next]!.delete(from);
    }
    return next;
  };
  for (const start of near.keys()) {
    const path = [start];
    while (path.length > 0) {
      const next = take(path.at(-1)!);
      if (next === undefined) path.pop();
      else if (path.includes(next)) cycles.push([next, ...path.splice(path.indexOf(next) + 1)]);
      else path.push(next);
    }
  }
  return cycles.filter((cycle) => cycle.length > 2).map((cycle) => cycle.map((i) => graph.nodes[i]!));
}

/** A region: its outline counter-clockwise, then its holes clockwise. */
export type Region = readonly Loop[];

/** Of loops that do not cross: those inside an odd number of others are holes. */
export function regionsOf(loops: readonly Loop[]): readonly Region[] {
  const sized = loops.filter((loop) => loop.length > 2 && areaOf(loop) !== 0);
  const around = sized.map((loop) => sized.filter((other) => other !== loop && holds(other, loop)));
  const outers = sized.filter((_, i) => around[i]!.length % 2 === 0);
  return outers.map((outer) => {
    const holes = sized.filter((_, i) => {
      const least = [...around[i]!].sort((a, b) => Math.abs(areaOf(a)) - Math.abs(areaOf(b)))[0];
      return around[i]!.length % 2 === 1 && least === outer;
    });
    return [turned(outer, 1), ...holes.map((hole) => turned(hole, -1))];
  });
}

/** By most of its places: loops may touch. */
function holds(outer: Loop, loop: Loop): boolean {
  const places = loop.filter((_, i) => i % Math.ceil(loop.length / 9) === 0);
  return places.filter((p: Vec2) => isInside(p, [outer])).length > 0.5 * places.length;
}

const turned = (loop: Loop, sign: 1 | -1): Loop => (areaOf(loop) * sign > 0 ? loop : [...loop].reverse());
