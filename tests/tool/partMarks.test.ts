/** What the card shows on the form: sections where they are, nets of patches, strokes with their control points. */
import { describe, expect, it } from 'vitest';
import { apply, type Command } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT, isSurface, type SurfacePart } from '../../src/document/document.ts';
import { controlMarks, sectionMarks } from '../../src/tool/partMarks.ts';
import { line, strokeAlong } from '../document/strokes.ts';

const across = (y: number, deep: number) =>
  strokeAlong((t) => [40 * t - 20, y - deep * Math.sin(Math.PI * t)]);
const section = (u: number, deep: number): Command => ({
  type: 'addSection',
  u,
  drawn: { stroke: across(30 - 60 * u, deep), half: null },
});

/** Upright strips, 40 mm wide. */
const made = (...sections: readonly Command[]): SurfacePart => {
  const commands: readonly Command[] = [
    { type: 'addStroke', stroke: line(-20) },
    { type: 'addStroke', stroke: line(20) },
    ...sections,
    { type: 'keep' },
  ];
  const document: Document = commands.reduce(apply, EMPTY_DOCUMENT);
  const [part] = document.parts.filter(isSurface);
  return part!;
};

const lines = (marks: ReturnType<typeof controlMarks>, style: string) =>
  marks.filter((mark) => mark.kind === 'line' && mark.style === style);

describe('a lit section', () => {
  it('goes from side to side at its u, where the part was moved to', () => {
    const part = made(section(0.5, 10));
    const moved = { ...part, placement: { ...part.placement, translation: [0, 0, 7] as const } };
    for (const [some, z] of [
      [part, 0],
      [moved, 7],
    ] as const) {
      const [mark] = sectionMarks(some, 0.25);
      if (mark?.kind !== 'line') throw new Error('no line');
      const [first, last] = [mark.points[0]!, mark.points.at(-1)!];
      expect([first[0], last[0]].map(Math.abs)).toEqual([expect.closeTo(20, 1), expect.closeTo(20, 1)]);
      for (const point of mark.points) expect(Math.abs(point[1] - 15)).toBeLessThan(0.5);
      for (const end of [first, last]) expect(end[2]).toBeCloseTo(z, 1);
      const deepest = Math.max(...mark.points.map((point) => Math.abs(point[2] - z)));
      expect(Math.abs(deepest - 10)).toBeLessThan(0.5);
    }
  });
});

describe('a control mesh', () => {
  it('is there of patches, and of other surfaces their strokes alone', () => {
    const patch = controlMarks(made(section(0.3, 10), section(0.7, 4)));
    expect(lines(patch, 'control').length).toBeGreaterThan(20);
    const plain = controlMarks(made());
    expect(lines(plain, 'control')).toEqual([]);
    for (const marks of [patch, plain]) {
      expect(lines(marks, 'full')).toHaveLength(2);
      expect(marks.filter(({ kind }) => kind === 'knot').length).toBeGreaterThanOrEqual(16);
    }
  });

  it('has no numbers that are none', () => {
    for (const mark of controlMarks(made(section(0.3, 10), section(0.7, -4))))
      if (mark.kind === 'line') expect(mark.points.flat().every(Number.isFinite)).toBe(true);
  });
});
