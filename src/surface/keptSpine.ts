/**
 * Spines that remember their stations. A bend asks for a place many times (rows, slopes, arc lengths), again in every frame of a
 * drag, and of a spine that is bent itself each answer asks for several of the spine below, which multiplies from bend to bend
 * (four bends: 559 ms, kept 131).
 */
import type { Spine, Station } from './sheet.ts';

/** stations of one side: frames ask for the same places but where corners are searched for; then all are forgotten */
const MOST = 1 << 14;

const known = new WeakMap<Spine, Spine>();

/** The same spine, always the same object for the same spine. */
export function kept(spine: Spine): Spine {
  const found = known.get(spine) ?? remembering(spine);
  known.set(spine, found);
  known.set(found, found);
  return found;
}

function remembering(spine: Spine): Spine {
  const before = new Map<number, Station>();
  const after = new Map<number, Station>();
  return {
    closed: spine.closed,
    stops: spine.stops,
    at: (u, side) => {
      const stations = side === 1 ? after : before;
      let station = stations.get(u);
      if (!station) {
        if (stations.size >= MOST) stations.clear();
        station = spine.at(u, side);
        stations.set(u, station);
      }
      return station;
    },
  };
}
