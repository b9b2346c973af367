/**
 * The first step of the filter: what the pen reported, less what says nothing.
 *
 * Theory: the thesis, chapter 4, lists noise, uneven spacing and the sheer number of points as the troubles of raw strokes.
 * Departure: a resting pen reports the same place many times, trembling by a pixel; left in, that tremble adds arc length
 * in one place (three millimetres were seen), and so does the noise of a pen that reports faster than it moves. So runs of
 * samples closer together than `rest` become their mean. Tried: dropping all but the first, which throws away what
 * the others know.
 */
import type { Sample } from './stroke.ts';

export interface CleanStroke {
  /** at least two, the first and last as drawn, all neighbours apart */
  readonly samples: readonly Sample[];
  /** samples with a coordinate that is not a number, or absurd */
  readonly broken: number;
  /** samples merged into others, because the pen rested */
  readonly resting: number;
}

/** mm: a thousand kilometres; squares of what is beyond overflow sooner or later */
const FARTHEST = 1e9;
/** A small drawing keeps its detail: samples further apart than this share of its extent are never merged. */
const SHARE_OF_EXTENT = 1 / 100;

/** Drops broken samples and merges resting ones; `rest` in mm. Null when fewer than two places are left (a dot). */
export function clean(samples: readonly Sample[], rest: number): CleanStroke | null {
  const sound = samples.filter(isSound).map(withSoundPressure);
  const runs = runsWithin(sound, Math.min(rest, extent(sound) * SHARE_OF_EXTENT));
  if (runs.length < 2) return null;
  const kept = runs.map((run, i) => {
    // the stroke begins where the pen landed and ends where it was lifted
    if (i === 0) return run[0]!;
    return i === runs.length - 1 ? run[run.length - 1]! : meanOf(run);
  });
  return { samples: kept, broken: samples.length - sound.length, resting: sound.length - kept.length };
}

/** Runs of samples within `nearest` of the first of their run. */
function runsWithin(samples: readonly Sample[], nearest: number): readonly (readonly Sample[])[] {
  const runs: Sample[][] = [];
  for (const sample of samples) {
    const run = runs[runs.length - 1];
    if (run !== undefined && apart(run[0]!, sample) <= nearest) run.push(sample);
    else runs.push([sample]);
  }
  return runs;
}

/** The mean place and pressure, with the tilt and time of the first. */
function meanOf(run: readonly Sample[]): Sample {
  if (run.length === 1) return run[0]!;
  const mean = (of: (sample: Sample) => number) => run.reduce((sum, s) => sum + of(s), 0) / run.length;
  return { ...run[0]!, x: mean((s) => s.x), y: mean((s) => s.y), pressure: mean((s) => s.pressure) };
}

function isSound(sample: Sample): boolean {
  return Math.abs(sample.x) <= FARTHEST && Math.abs(sample.y) <= FARTHEST;
}

function withSoundPressure(sample: Sample): Sample {
  const { pressure } = sample;
  if (pressure >= 0 && pressure <= 1) return sample;
  return { ...sample, pressure: pressure > 1 ? 1 : pressure < 0 ? 0 : 0.5 };
}

function extent(samples: readonly Sample[]): number {
  let left = Infinity;
  let right = -Infinity;
  let bottom = Infinity;
  let top = -Infinity;
  for (const { x, y } of samples) {
    left = Math.min(left, x);
    right = Math.max(right, x);
    bottom = Math.min(bottom, y);
    top = Math.max(top, y);
  }
  return samples.length === 0 ? 0 : Math.max(right - left, top - bottom);
}

function apart(a: Sample, b: Sample): number {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  return Math.sqrt(dx * dx + dy * dy);
}
