/** Stand-in for stand.ts. */
import { dot2 } from '../math/tuple.ts';
import type { Vec3 } from '../math/vec.ts';
import type { Pair } from './pair.ts';
import { ringAt } from './ring.ts';

export interface Stand {
  readonly centre: Vec3;
  readonly half: Vec3;
  readonly depth: Vec3;
}

export interface Standing {
  readonly closed: boolean;
  readonly length: number;
  readonly stops: readonly { readonly u: number; readonly pole: boolean }[];
  at(u: number, side: -1 | 1): { readonly stand: Stand; readonly rate: Stand };
}

export function standingOf(pair: Pair): Standing {
  const isPole = (u: number): boolean => pair.stops.some((stop) => stop.pole && stop.u === u);
  return {
    closed: pair.closed,
    length: pair.length,
    stops: pair.stops,
    at: (u, side) => {
      const ring = ringAt(pair, u, side, isPole(u));
      return {
        stand: {
          centre: [ring.centre[0], ring.centre[1], 0],
          half: [-ring.axis[0] * ring.radius, -ring.axis[1] * ring.radius, 0],
          depth: [0, 0, ring.radius],
        },
        rate: {
          centre: [ring.dCentre[0], ring.dCentre[1], 0],
          half: [-ring.dHalf[0], -ring.dHalf[1], 0],
          depth: [0, 0, dot2(ring.dHalf, ring.axis)],
        },
      };
    },
  };
}
