/** Solids in documents: what commands on them keep, and what files say of them. */
import { describe, expect, it } from 'vitest';
import { apply, type Command } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT, isSolid, type SolidPart } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { bodiesOf } from '../../src/document/fieldParts.ts';
import { parse, serialize, serializeScript } from '../../src/document/serialize.ts';
import { groupsOf } from '../../src/document/solid.ts';
import { nodeOf } from '../../src/document/solidNode.ts';
import { bindField } from '../../src/field/bind.ts';
import { place3, unplaced } from '../../src/math/placement.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import { random } from '../fixtures/random.ts';
import { COMMANDS, historyOf } from './files.ts';
import { circle, line } from './strokes.ts';

const after = (commands: readonly Command[], from = EMPTY_DOCUMENT): Document => commands.reduce(apply, from);
const add = (stroke = circle(20)) => ({ type: 'addStroke', stroke }) as const;
const KEEP: Command = { type: 'keep' };
const JOINS = { solid: 'part-1', component: 'component-2' } as const;
const SECOND = { solid: 'part-1', component: 'component-8' } as const;
const BESIDE = { solid: 'part-1', component: null } as const;

/** A ball of strokes, a limb that blends with it (group-6), another beside it (group-9); moved and turned as a whole. */
const figure = after([
  add(),
  KEEP,
  { ...add(line(30, 40)), form: 'line', joins: JOINS },
  KEEP,
  { ...add(line(-30, 40)), form: 'line', joins: { solid: 'part-1', component: null } },
  KEEP,
  { type: 'moveParts', ids: ['part-1'], by: { rotation: [0.48, 0.6, 0, 0.64], translation: [3, -7, 11] } },
]);
const IDS = ['part-1', 'group-6', 'component-8'] as const;

const next = random(51);
const PLACES = Array.from({ length: 60 }, (): Vec3 => [80 * next() - 40, 80 * next() - 40, 80 * next() - 40]);

/** The field of all parts, at places of the model's space. */
function valuesIn(document: Document, places = PLACES): number[] {
  const fields = bodiesOf(document).map(({ node, placement }) => ({ field: bindField(node), placement }));
  return places.map((place) =>
    Math.max(...fields.map(({ field, placement }) => field.value(...place3(unplaced(placement), place)))),
  );
}

function expectNear(found: readonly number[], wanted: readonly number[], within = 1e-12): void {
  found.forEach((value, i) => {
    expect(Math.abs(value - wanted[i]!)).toBeLessThan(within * Math.max(1, Math.abs(wanted[i]!)));
  });
}

const mirrorAt = (id: string) =>
  ({ type: 'mirrorParts', ids: [id], about: [1, 2, 3], normal: [0.48, 0.6, 0.64] }) as const;

/** The other side of that mirror. */
const over = (place: Vec3): Vec3 => {
  const { about, normal } = mirrorAt('');
  const far = place.reduce((sum, value, i) => sum + (value - about[i]!) * normal[i]!, 0);
  return place.map((value, i) => value - 2 * far * normal[i]!) as unknown as Vec3;
};

describe('a mirror', () => {
  it.each(IDS)('of a mirror changes nothing: %s', (id) => {
    const twice = after([mirrorAt(id), mirrorAt(id)], figure);
    expectNear(valuesIn(twice), valuesIn(figure), 1e-9);
    const planes = (document: Document) =>
      document.parts
        .filter(isSolid)
        .flatMap(groupsOf)
        .flatMap(({ strokes }) => strokes.flatMap(({ plane }) => [...plane.origin, ...plane.x, ...plane.y]));
    expectNear(planes(twice), planes(figure));
  });

  it('shows the other side', () => {
    expectNear(valuesIn(after([mirrorAt('part-1')], figure), PLACES.map(over)), valuesIn(figure), 1e-9);
  });
});

describe('a scale', () => {
  it.each(IDS)('by k and then 1/k changes nothing: %s', (id) => {
    const scale = (factor: number): Command => ({ type: 'scaleParts', ids: [id], factor, about: [4, 5, 6] });
    expectNear(valuesIn(after([scale(1.7), scale(1 / 1.7)], figure)), valuesIn(figure), 1e-6);
  });

  it('makes all of it larger', () => {
    const about: Vec3 = [4, 5, 6];
    const larger = after([{ type: 'scaleParts', ids: ['part-1'], factor: 2, about }], figure);
    const far = PLACES.map((place) => place.map((value, i) => 2 * value - about[i]!) as unknown as Vec3);
    const signs = (values: readonly number[]) =>
      values.map((value) => (Math.abs(value) > 0.02 ? value > 0 : null));
    const before = signs(valuesIn(figure));
    const there = signs(valuesIn(larger, far));
    expect(there.filter((sign, i) => sign !== null && before[i] !== null && sign !== before[i])).toEqual([]);
  });
});

describe('groups that move', () => {
  it.each([
    ['on their own', null],
    ['into the sum of another', { solid: 'part-1', component: 'component-8' }],
    ['beside the others', { solid: 'part-1', component: null }],
  ] as const)('%s stay where they are', (_, to) => {
    const alone = (document: Document) => only(document, 'group-6');
    const moved = after([{ type: 'moveGroups', ids: ['group-6'], to }], figure);
    expectNear(valuesIn(alone(moved)), valuesIn(alone(figure)), 1e-9);
    expect(allGroups(moved)).toHaveLength(allGroups(figure).length);
  });

  it('come back into a solid that lies elsewhere', () => {
    const apart = after([{ type: 'moveGroups', ids: ['group-6'], to: null }], figure);
    const back = after([{ type: 'moveGroups', ids: ['group-6'], to: JOINS }], apart);
    expect(back.parts).toHaveLength(1);
    expectNear(valuesIn(back), valuesIn(figure), 1e-9);
  });

  it('of two components are one of their own, beside the rest', () => {
    const two = after([{ ...add(line(50, 40)), form: 'line', joins: SECOND }, KEEP], figure);
    const [a, b] = (two.parts[0] as SolidPart).components.map(({ groups }) => groups.map(({ id }) => id));
    const moved = after([{ type: 'moveGroups', ids: [a![0]!, b![0]!], to: BESIDE }], two);
    const found = (moved.parts[0] as SolidPart).components.map(({ groups }) => groups.map(({ id }) => id));
    expect([a!.length, b!.length]).toEqual([2, 2]);
    expect(found).toEqual([[a![1]], [b![1]], [a![0], b![0]]]);
  });

  it('of a whole solid are apart as they were: at home, beside others, never in one', () => {
    const ids = allGroups(figure).map(({ id }) => id);
    for (const to of [null, BESIDE])
      for (const taken of [ids, ['part-1']])
        expect(after([{ type: 'moveGroups', ids: taken, to }], figure)).toBe(figure);
    const host = after([add(circle(9)), KEEP], figure);
    const other = host.parts[1] as SolidPart;
    for (const taken of [ids, [...ids, ...groupsOf(other).map(({ id }) => id)]]) {
      const to = { solid: other.id, component: null };
      const moved = after([{ type: 'moveGroups', ids: taken, to }], host);
      const [only, ...others] = moved.parts as readonly SolidPart[];
      expect(others).toEqual([]);
      expect(only!.components.map(({ id, groups }) => [id, groups.length])).toEqual([
        [other.components[0]!.id, 1],
        ...(figure.parts[0] as SolidPart).components.map(({ id, groups }) => [id, groups.length]),
      ]);
      expectNear(valuesIn(moved), valuesIn(host), 1e-9);
    }
  });

  it('go nowhere where the solid or the component is not there', () => {
    for (const to of [
      { solid: 'part-9', component: null },
      { ...JOINS, component: 'x' },
    ])
      expect(after([{ type: 'moveGroups', ids: ['group-6'], to }], figure)).toBe(figure);
  });
});

const allGroups = (document: Document) => document.parts.filter(isSolid).flatMap(groupsOf);

/** All else hidden. */
const only = (document: Document, id: string): Document =>
  after(
    [
      {
        type: 'showParts',
        ids: allGroups(document)
          .map((group) => group.id)
          .filter((other) => other !== id),
        visible: false,
      },
    ],
    document,
  );

describe('ids of groups', () => {
  it('serve the commands of parts', () => {
    const seen = after(
      [
        { type: 'renamePart', id: 'group-6', name: 'Limb' },
        { type: 'setPartBrush', ids: ['component-8'], change: { colour: '#112233' } },
        { type: 'duplicateParts', ids: ['group-9'], offset: [0, 9, 0] },
      ],
      figure,
    );
    expect(allGroups(seen).map(({ name }) => name)).toContain('Limb');
    expect(allGroups(seen).filter(({ brush }) => brush.colour === '#112233')).toHaveLength(2);
    expect(allGroups(after([{ type: 'removeParts', ids: ['component-2'] }], figure))).toHaveLength(1);
    expect(after([{ type: 'removeParts', ids: ['group-3', 'group-6', 'group-9'] }], figure).parts).toEqual(
      [],
    );
  });

  it('change nothing where nothing is to change, so that no step is made', () => {
    const idle: readonly Command[] = [
      { type: 'setGroups', ids: ['group-6'], change: { weight: 1, form: 'line' } },
      { type: 'setComponents', ids: ['part-1'], change: { kernel: 'cauchy', threshold: 0.5 } },
      { type: 'editSkeleton', id: 'group-6', skeleton: null },
      { type: 'showParts', ids: ['group-6'], visible: true },
      { type: 'moveGroups', ids: ['group-6'], to: JOINS },
      { type: 'scaleParts', ids: ['group-6'], factor: 1, about: [0, 0, 0] },
      { type: 'setForm', form: 'soft' },
      { type: 'paste', parts: [], offset: [0, 0, 0] },
    ];
    for (const command of idle) expect(apply(figure, command), command.type).toBe(figure);
  });

  it('are new of what is pasted, and nothing has an id twice', () => {
    const solid = figure.parts[0] as SolidPart;
    const pasted = after([{ type: 'paste', parts: [solid, solid], offset: [9, 0, 0] }], figure);
    const ids = pasted.parts
      .filter(isSolid)
      .flatMap((part) => [part, ...part.components, ...groupsOf(part)].map(({ id }) => id));
    expect(new Set(ids).size).toBe(ids.length);
    expect(nodeOf(pasted.parts[1] as SolidPart)).toEqual(nodeOf(solid));
  });
});

describe('another form', () => {
  it('takes its skeleton from the strokes again, and its own form keeps it', () => {
    const skeleton = { nodes: [{ at: [0, 0], radius: 9 }], links: [] } as const;
    const edited = after([{ type: 'editSkeleton', id: 'group-3', skeleton }], figure);
    const shapeOf = (command: Command) => allGroups(apply(edited, command))[0]!.skeleton;
    expect(shapeOf({ type: 'setGroups', ids: ['group-3'], change: { form: 'plate' } })).toBe(null);
    expect(shapeOf({ type: 'setGroups', ids: ['group-3'], change: { weight: 2 } })).toBe(skeleton);
  });
});

describe('the version of a file', () => {
  const versionIn = (text: string) => (JSON.parse(text) as { version: number }).version;
  const drawn = (document: Document) => versionIn(serialize({ ...EMPTY_DRAWING, document }));
  const script = (commands: readonly Command[]) => versionIn(serializeScript(commands, EMPTY_DRAWING));

  it('is 4 only where something needs it', () => {
    expect(drawn(figure)).toBe(4);
    expect(drawn(after([add()]))).toBe(4);
    expect(drawn(after([{ ...add(line(0)), form: 'tube' }]))).toBe(4);
    expect(drawn(after([add(line(0)), KEEP]))).toBe(1);
    expect(drawn(after([{ ...add(), form: 'tube' }, KEEP]))).toBe(1);
    expect(script([add(line(0)), KEEP])).toBe(1);
    expect(script([add()])).toBe(4);
    const isLatest = (command: Command) => script([command]) === 5;
    expect(drawn(historyOf(COMMANDS.slice(0, COMMANDS.findIndex(isLatest))).present)).toBe(4);
  });

  it('below 4 is refused with solids in it', () => {
    const text = serialize({ ...EMPTY_DRAWING, document: figure }).replace('"version": 4', '"version": 3');
    expect(() => parse(text, 'x.rotund')).toThrow(
      'x.rotund, version: expected 4, because there are solids in it, found 3',
    );
  });

  it('says what closed strokes were: tubes and sides before 4, silhouettes since', () => {
    const commands = [add(circle(9)), KEEP, add(circle(9)), add(circle(5)), KEEP];
    const file = (version: number) => JSON.stringify({ format: 'rotund-script', version, commands });
    const kinds = (version: number) => parse(file(version), 'x').document.parts.map(({ kind }) => kind);
    expect(kinds(1)).toEqual(['tube', 'rotational']);
    expect(kinds(4)).toEqual(['solid', 'solid']);
    const draft = (version: number) =>
      parse(JSON.stringify({ format: 'rotund', version, document: { draft: { strokes: [circle(9)] } } }), 'x')
        .document;
    expect(after([KEEP], draft(1)).parts[0]!.kind).toBe('tube');
    expect(after([KEEP], draft(4)).parts[0]!.kind).toBe('solid');
  });
});

describe('what is wrong with a solid', () => {
  const refusal = (change: (solid: SolidPart) => object): string => {
    const solid = change(figure.parts[0] as SolidPart);
    try {
      parse(JSON.stringify({ format: 'rotund', version: 4, document: { parts: [solid] } }), 'x');
    } catch (error) {
      return (error as Error).message;
    }
    throw new Error('was read');
  };
  const first = (change: object) => (solid: SolidPart) => {
    const [component, ...others] = solid.components;
    const [group, ...rest] = component!.groups;
    return {
      ...solid,
      components: [{ ...component, groups: [{ ...group, ...change }, ...rest] }, ...others],
    };
  };
  const GROUP = 'x, document.parts[0].components[0].groups[0]';

  it.each<readonly [(solid: SolidPart) => object, string]>([
    [
      (solid) => ({ ...solid, components: [] }),
      'x, document.parts[0].components: expected a list of 1 to 10000 components, found an empty list',
    ],
    [
      first({ form: 'bag' }),
      `${GROUP}.form: expected one of "soft", "plate", "ring", "line", "curve", "point", found "bag"`,
    ],
    [
      first({ form: 'ring', strokes: [circle(9), circle(3)] }),
      `${GROUP}.strokes: expected 1 stroke, which "ring" is made of, found a list of 2`,
    ],
    [
      first({ strokes: [circle(9), line(3)] }),
      `${GROUP}.strokes[1]: expected a stroke on the very plane of strokes[0], open or closed like it, found an object`,
    ],
    [
      first({ shape: { profile: [] } }),
      `${GROUP}.shape.profile: expected a list of 1 to 64 factors, found an empty list`,
    ],
    [
      first({ shape: { section: 'extrusion', exponent: 1 } }),
      `${GROUP}.shape.exponent: expected a number from 2 to 100, of an extrusion, found 1`,
    ],
    [
      first({ skeleton: { nodes: [{ at: [0, 0], radius: 0 }] } }),
      `${GROUP}.skeleton.nodes[0].radius: expected a number from 0.000001 to 1000000, found 0`,
    ],
    [
      first({ skeleton: { nodes: [{ at: [0, 0], radius: 1 }], links: [[0, 1]] } }),
      `${GROUP}.skeleton.links[0]: expected two indices of circles that are there, found [0, 1]`,
    ],
    [
      first({ id: 'part-1' }),
      'x, document.parts[0].components[0].groups[0].id: expected an id that nothing else has, found "part-1"',
    ],
  ])('is said with its place: %#', (change, message) => expect(refusal(change)).toBe(message));
});
