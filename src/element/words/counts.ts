/** Counts, times and sizes as people read them. */

export const thousands = (count: number): string => String(count).replace(/\B(?=(\d{3})+$)/g, ',');

export const seconds = (milliseconds: number): string =>
  milliseconds < 995
    ? `${Math.max(1, Math.round(milliseconds))} ms`
    : `${(milliseconds / 1000).toFixed(1)} s`;

/** A byte count as people read it. */
export const bytes = (size: number) =>
  size < 1e6 ? `${Math.max(1, Math.round(size / 1e3))} kB` : `${(size / 1e6).toFixed(1)} MB`;

export const placesOf = (places: number): string => (places === 1 ? '1 place' : `${places} places`);
