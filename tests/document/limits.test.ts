/** What a file may just hold makes finite meshes, so that nothing further in has to ask. */
import { describe, expect, it } from 'vitest';
import { RANGES } from '../../src/document/limits.ts';
import { parse } from '../../src/document/serialize.ts';
import { topology } from '../../src/mesh/check.ts';
import { meshesOf } from './files.ts';

const { coordinate, height, radius } = RANGES;
const far = coordinate.max;

const tube = (
  rows: readonly (readonly number[])[],
  brush: object,
  view: object = {},
  plane: object = {},
) => ({
  kind: 'tube',
  brush,
  placement: { translation: [far, -far, far], rotation: [0.5, 0.5, 0.5, 0.5] },
  strokes: [{ samples: rows, view, plane }],
});

const wave = (scale: number) =>
  Array.from({ length: 12 }, (_, i) => [scale * (i / 11), scale * (i % 3) * 0.1]);
/** four digits are enough for a person, so they must be enough for us */
const TILTED = { origin: [far, far, -far], x: [0.6, 0, -0.7999], y: [0, 1, 0] };

describe('at the edge of what is allowed', () => {
  const cases: Readonly<Record<string, object>> = {
    'as large as can be': tube(wave(far), { radius: radius.max }, { height: height.max }, TILTED),
    'as small as can be': tube(wave(1e-9), { radius: radius.min }, { height: height.min }),
    'hardly there': tube(wave(1e-300), { radius: radius.min }),
    'a dot': tube([[5, 5]], { radius: radius.max }),
    'one place twice': tube(
      [
        [5, 5],
        [5, 5],
      ],
      { levels: 0 },
    ),
    'without smoothing': tube(wave(50), { levels: 0, filter: 'chaikin' }),
    'with most smoothing': tube(wave(50), { levels: 6, filter: 'cubic' }),
    'two sides far apart': {
      kind: 'rotational',
      strokes: [-far, far].map((x) => ({
        samples: [
          [x, -far],
          [x, far],
        ],
        view: { height: height.max },
      })),
    },
    'two sides on each other': {
      kind: 'rotational',
      strokes: [wave(40), wave(40)].map((samples) => ({ samples })),
    },
  };

  it.each(Object.keys(cases))('%s', (name) => {
    const file = { format: 'rotund', version: 1, document: { parts: [cases[name]] } };
    const { document } = parse(JSON.stringify(file), 'edge.rotund');
    for (const mesh of meshesOf(document)) expect(topology(mesh).finite).toBe(true);
  });
});
