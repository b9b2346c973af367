/** The parts of a picture, as workers take them. */
import { expect, it } from 'vitest';
import { type Job, RayJobs } from '../../src/element/rayJobs.ts';
import { OFFSETS } from '../../src/field/rayEdges.ts';

function all(jobs: RayJobs, places: number): Job[] {
  const found: Job[] = [];
  for (let job = jobs.next(places); job; job = jobs.next(places)) found.push(job);
  return found;
}

it.each([1, 16, 17, 100, 700])('%d rows are each handed out once, from the middle outwards', (height) => {
  const seen = new Uint8Array(height);
  let off = 0;
  for (const job of all(new RayJobs(height), 0)) {
    if (job.type !== 'band') throw new Error(job.type);
    for (let row = job.from; row < job.to; row++) seen[row]!++;
    const away = Math.abs((job.from + job.to) / 2 - height / 2);
    // the last may be less high
    expect(away).toBeGreaterThanOrEqual(off - 16);
    off = Math.max(away, off);
  }
  expect(seen.every((count) => count === 1)).toBe(true);
});

it('rays at edges come after the rows, as many as are known, image by image, each once', () => {
  const jobs = new RayJobs(40);
  expect(all(jobs, 0).length).toBe(3);
  const seen = OFFSETS.map(() => new Set<number>());
  let last = 0;
  for (const places of [5, 700, 5000]) {
    last = 0;
    for (const job of all(jobs, places)) {
      if (job.type !== 'again') throw new Error(job.type);
      expect(job.offset).toBeGreaterThanOrEqual(last);
      last = job.offset;
      for (let at = job.first; at < job.first + job.count; at++) {
        expect(seen[job.offset]!.has(at)).toBe(false);
        seen[job.offset]!.add(at);
      }
    }
    for (const set of seen) expect(set.size).toBe(places);
  }
});

it('what was given back comes next', () => {
  const jobs = new RayJobs(40);
  const [a, b] = [jobs.next(0)!, jobs.next(0)!];
  jobs.giveBack([a, b]);
  expect(new Set([jobs.next(0), jobs.next(0)])).toEqual(new Set([a, b]));
  expect(all(jobs, 0).length).toBe(1);
});
