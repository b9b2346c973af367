/** `rotund mesh` and `rotund info` of scripts, one for each command that makes sections, bends and what goes with them. */
import { describe, expect, it } from 'vitest';
import { useProgram } from './program.ts';

const { put, run } = useProgram();

const SIDES = [
  {
    type: 'addStroke',
    stroke: {
      samples: [
        [-10, -30],
        [-10, 0],
        [-10, 30],
      ],
    },
  },
  {
    type: 'addStroke',
    stroke: {
      samples: [
        [10, -30],
        [10, 0],
        [10, 30],
      ],
    },
  },
];
const KEEP = { type: 'keep' };
const across = (dip: number) => ({
  stroke: {
    samples: [
      [-10, 0],
      [-5, -dip],
      [0, -1.2 * dip],
      [5, -dip],
      [10, 0],
    ],
  },
});
const section = (u: number, dip: number) => ({ type: 'addSection', u, drawn: across(dip) });
const back = (to: string) => ({ type: 'setSurface', change: { back: to } });
const bump = {
  half: 10,
  stroke: {
    samples: [
      [-6, 8],
      [0, 16],
      [6, 8],
    ],
  },
};
const side = (samples: readonly (readonly number[])[]) => ({ stroke: { plane: { x: [0, 0, -1] }, samples } });
const part = 'part-1';

interface Found {
  readonly volume: number;
  readonly watertight: boolean;
  readonly triangles: number;
  readonly bounds: { readonly min: readonly number[]; readonly max: readonly number[] };
}

const ROD = Math.PI * 10 ** 2 * 60;

const CASES: readonly (readonly [string, readonly object[], (found: Found) => void])[] = [
  [
    'addSection',
    [...SIDES, section(0.5, 6), KEEP],
    ({ watertight, bounds }) => {
      expect(watertight).toBe(false);
      expect(bounds.max[2]).toBeGreaterThan(6);
      expect(bounds.min[2]).toBeGreaterThan(-0.1);
    },
  ],
  [
    'addSection of a back',
    [...SIDES, section(0.5, 6), { ...section(0.5, -3), side: 'back' }, KEEP],
    ({ watertight, bounds }) => {
      expect(watertight).toBe(true);
      expect(bounds.min[2]).toBeLessThan(-3);
    },
  ],
  [
    'removeSection',
    [...SIDES, section(0.5, 6), KEEP, { type: 'removeSection', part, index: 0 }],
    ({ volume }) => expect(volume / ROD).toBeCloseTo(1, 1),
  ],
  [
    'redrawSection',
    [...SIDES, KEEP, { type: 'redrawSection', part, u: 0.5, drawn: bump }],
    ({ watertight, volume, bounds }) => {
      expect(watertight).toBe(true);
      expect(volume / ROD).toBeGreaterThan(1.05);
      expect(bounds.max[2]).toBeGreaterThan(12);
    },
  ],
  [
    'redrawSection here only',
    [...SIDES, KEEP, { type: 'redrawSection', part, u: 0.5, drawn: bump, local: true }],
    ({ watertight, volume }) => {
      expect(watertight).toBe(true);
      expect(volume / ROD).toBeGreaterThan(1.02);
    },
  ],
  [
    'setStroke',
    [...SIDES, KEEP, { type: 'setStroke', part, index: 0, stroke: null }],
    ({ watertight, bounds }) => {
      // a tube is left
      expect(watertight).toBe(true);
      expect(bounds.min[0]).toBeGreaterThan(0);
    },
  ],
  [
    'setSurface',
    [
      ...SIDES,
      section(0.2, 6),
      section(0.8, 2),
      back('front'),
      KEEP,
      {
        type: 'setSurface',
        ids: [part],
        change: { between: 'plain', detail: { rows: 8, columns: 8, u: 0, v: 0 } },
      },
    ],
    ({ watertight, triangles }) => {
      expect(watertight).toBe(true);
      expect(triangles).toBeLessThan(500);
    },
  ],
  [
    'bend',
    [
      ...SIDES,
      KEEP,
      {
        type: 'bend',
        id: part,
        bend: side([
          [0, -30],
          [5, 0],
          [20, 30],
        ]),
      },
    ],
    ({ watertight, volume, bounds }) => {
      expect(watertight).toBe(true);
      expect(volume / ROD).toBeCloseTo(1, 1);
      expect(bounds.min[2]).toBeLessThan(-18);
    },
  ],
  [
    'setBend',
    [
      ...SIDES,
      KEEP,
      {
        type: 'bend',
        id: part,
        bend: side([
          [0, -30],
          [5, 0],
          [20, 30],
        ]),
      },
      { type: 'setBend', id: part, index: 0, change: null },
    ],
    ({ bounds }) => expect(bounds.min[2]).toBeCloseTo(-10, 1),
  ],
  [
    'recreate',
    [...SIDES, KEEP, { type: 'recreate', id: part }, section(0.5, 6), back('front'), KEEP],
    ({ watertight, bounds }) => {
      expect(watertight).toBe(true);
      expect(bounds.max[2]).toBeLessThan(8);
    },
  ],
];

// A process each, on a machine that may be busy.
describe('scripts of surfaces', { timeout: 60_000 }, () => {
  it.each(CASES)('are meshed: %s', async (name, commands, check) => {
    const file = put('script.rotund', JSON.stringify(commands));
    const { status, stdout, stderr } = await run(['mesh', file, '-o', 'out.stl']);
    expect(stderr, name).toBe('');
    expect(status).toBe(0);
    check(JSON.parse(stdout) as Found);
  });

  it('are meshed as finely as one asks', async () => {
    put('patch.rotund', JSON.stringify([...SIDES, section(0.2, 6), section(0.8, 2), back('front'), KEEP]));
    const counts = await Promise.all(
      ['24', '96'].map(async (quads) => {
        const { stdout } = await run([
          'mesh',
          'patch.rotund',
          '-o',
          `${quads}.stl`,
          '--surface-resolution',
          quads,
        ]);
        return (JSON.parse(stdout) as Found).triangles;
      }),
    );
    expect(counts[1]! / counts[0]!).toBeGreaterThan(4);
    expect(counts[1]).toBeGreaterThanOrEqual(2 * 96 * 96);
  });

  it('are counted, and a stroke in hand counts once', async () => {
    const bent = {
      type: 'bend',
      id: part,
      bend: side([
        [0, -30],
        [5, 0],
        [20, 30],
      ]),
    };
    put('counted.rotund', JSON.stringify([...SIDES, section(0.5, 6), KEEP, bent]));
    const found = await run(['info', 'counted.rotund']);
    expect(JSON.parse(found.stdout)).toMatchObject({ parts: 1, strokes: 4, warnings: [] });
    put('hand.rotund', JSON.stringify([...SIDES, section(0.5, 6), KEEP, { type: 'recreate', id: part }]));
    const hand = await run(['info', 'hand.rotund']);
    expect(JSON.parse(hand.stdout)).toMatchObject({
      parts: 1,
      strokes: 3,
      warnings: ['the unfinished form (3 strokes) is left out'],
    });
  });

  it('name parts that are there', async () => {
    put('unknown.rotund', JSON.stringify([...SIDES, { ...section(0.5, 6), part: 'part-7' }]));
    const { status, stderr } = await run(['mesh', 'unknown.rotund', '-o', 'x.stl']);
    expect(status).not.toBe(0);
    expect(stderr).toContain(
      'commands[2].part: expected the id of a part that is there by then, found "part-7"',
    );
  });
});
