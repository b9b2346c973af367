/** Sheets of documents: found again by what they are made of, and by nothing else. */
import { describe, expect, it } from 'vitest';
import { DEFAULT_BRUSH } from '../../src/document/document.ts';
import { sheetOf } from '../../src/document/sheets.ts';
import { PLAIN, type SurfaceForm } from '../../src/document/surfacePart.ts';
import { line, strokeAlong } from './strokes.ts';

const bend = {
  stroke: strokeAlong((t) => [20 * t * t, 30 - 60 * t], {
    plane: { origin: [0, 0, 0], x: [0, 0, -1], y: [0, 1, 0] },
  }),
  keepsLength: true,
  isOff: false,
} as const;
const form: SurfaceForm = { ...PLAIN, strokes: [line(-10), line(10)], bends: [bend] };
const sheet = (change: Partial<SurfaceForm> = {}, brush = DEFAULT_BRUSH) =>
  sheetOf('rotational', { ...form, ...change }, brush);

describe('sheets are found again', () => {
  it('with their bends, whatever is painted', () => {
    expect(sheet()).toBe(sheet());
    expect(sheet({}, { ...DEFAULT_BRUSH, colour: '#123456' })).toBe(sheet());
  });

  it('but not with other bends, another detail or another filter', () => {
    const first = sheet()!;
    const off = sheet({ bends: [{ ...bend, isOff: true }] })!;
    expect(off.rows[0]!.points).toEqual(sheet({ bends: [] })!.rows[0]!.points);
    expect(off.rows.map(({ points }) => points)).not.toEqual(first.rows.map(({ points }) => points));
    expect(sheet({ detail: { ...form.detail, u: 3 } })!.rows.length).toBeGreaterThan(first.rows.length);
    expect(sheet({}, { ...DEFAULT_BRUSH, levels: DEFAULT_BRUSH.levels + 1 })).not.toBe(first);
    expect(sheet()!.rows).toEqual(first.rows);
  });

  it('below the bend of a stack that is drawn, and where one above is taken away', () => {
    const drawn = (by: number) => ({
      ...bend,
      stroke: strokeAlong((t) => [by * t * t, 30 - 60 * t], { plane: bend.stroke.plane }),
    });
    const below = sheet();
    const frames = [1, 2, 3].map((by) => sheet({ bends: [bend, drawn(by)] })!);
    expect(new Set(frames).size).toBe(3);
    expect(sheet({ bends: [bend] })).toBe(below);
    expect(sheet({ bends: [bend, { ...drawn(4), isOff: true }] })).toBe(below);
  });
});
