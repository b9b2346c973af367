/** Documents and scripts for the tests of files. */
import { createHash } from 'node:crypto';
import type { Resolution, Solid } from '../../src/document/build.ts';
import { buildForm, solids } from '../../src/document/build.ts';
import type { Command } from '../../src/document/command/index.ts';
import {
  DEFAULT_BRUSH,
  type Document,
  formOfDraft,
  type Part,
  readingOf,
} from '../../src/document/document.ts';
import type { Drawing } from '../../src/document/drawing.ts';
import { commit, type History, newHistory } from '../../src/document/history.ts';
import { DEFAULT_LOOK } from '../../src/document/look.ts';
import { DEFAULT_COMPONENT, DEFAULT_SHAPE } from '../../src/document/solid.ts';
import { PLAIN } from '../../src/document/surfacePart.ts';
import { UNMOVED } from '../../src/math/placement.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { Plane } from '../../src/stroke/stroke.ts';
import { EVERY_NODE } from './everyNode.ts';
import { circle, halfCircle, strokeAlong, VIEW } from './strokes.ts';

/** Enough to see whether meshes differ, and quick. */
export const COARSE: Resolution = { u: 8, v: 6 };

const SIDEWAYS: Plane = { origin: [10, -0, 3.3], x: [0, 0, -1], y: [0, 1, 0] };
const HALF = Math.SQRT1_2;

/** All that a name may hold. */
export const NAMES = [
  '<img src=x onerror=alert(1)>',
  '🍐 pear',
  'two\nlines',
  '"quoted" \\ back',
  '\u202eolleh',
  '__proto__',
];

const wave = (x: number, count = 14) => strokeAlong((t) => [x + 4 * Math.sin(7 * t), 30 - 60 * t], {}, count);
const add = (stroke = wave(0)) => ({ type: 'addStroke', stroke }) as const;
const KEEP: Command = { type: 'keep' };

const SKELETON = {
  nodes: [
    { at: [0.1, -3], radius: 4 },
    { at: [9, 1 / 3], radius: 2.5 },
    { at: [-20, 0], radius: 1 },
  ],
  links: [[0, 1]],
} as const;

/** A tap of the pen. */
const tap = (x: number, y: number) => strokeAlong((t) => [x + 0.2 * t, y], {}, 3);

const PASTED = {
  id: 'part-3',
  name: 'Pasted',
  kind: 'solid',
  components: [
    {
      id: 'component-1',
      name: 'C',
      ...DEFAULT_COMPONENT,
      groups: [
        {
          id: 'group-1',
          name: 'G',
          hidden: false,
          form: 'point',
          strokes: [tap(3, 3)],
          brush: DEFAULT_BRUSH,
          shape: { ...DEFAULT_SHAPE, section: 'superQuadric', exponent: 3.3, breadth: 1.1 },
          skeleton: SKELETON,
        },
      ],
    },
  ],
  placement: UNMOVED,
  hidden: false,
} as const satisfies Part;

const loop = (radius: number) =>
  strokeAlong((t) => [40 + radius * Math.cos(6.3 * t), radius * Math.sin(6.3 * t)], { closed: true }, 14);

/** An outline with a hole, a line that carves it, a point beside it, and what can be done to them. The next number is 8. */
const SOLIDS: readonly Command[] = [
  { type: 'setBrush', change: { pressure: false } },
  add(loop(20)),
  add(loop(6)),
  { type: 'setForm', form: 'plate' },
  { type: 'setForm', form: 'soft' },
  KEEP,
  {
    ...add(strokeAlong((t) => [40, 20 - 40 * t], {}, 6)),
    form: 'line',
    joins: { solid: 'part-8', component: 'component-9' },
    carves: true,
  },
  KEEP,
  { ...add(tap(40, 24)), form: 'point', joins: { solid: 'part-8', component: null } },
  KEEP,
  {
    type: 'setGroups',
    ids: ['group-13'],
    change: { weight: -0.3, breadth: 1.2, depth: 0.8, profile: [1, 0.5, 1 / 3], density: 3 },
  },
  {
    type: 'setGroups',
    ids: ['component-15'],
    change: { section: 'extrusion', exponent: 4, knots: [0, 0, 1, 1] },
  },
  { type: 'setComponents', ids: ['group-16'], change: { kernel: 'quartic', threshold: 0.1 + 0.2 } },
  { type: 'moveGroups', ids: ['group-16'], to: null },
  { type: 'duplicateParts', ids: ['group-13'], offset: [0, 3, 1] },
  { type: 'moveGroups', ids: ['group-19'], to: { solid: 'part-8', component: null } },
  { type: 'editSkeleton', id: 'group-13', skeleton: SKELETON },
  { type: 'scaleParts', ids: ['group-13', 'part-18'], factor: 1.1, about: [1, 2, 3] },
  { type: 'mirrorParts', ids: ['part-8', 'group-16', 'part-1'], about: [5, 0, 0], normal: [0.6, 0.8, 0] },
  { type: 'paste', parts: [PASTED], offset: [0, 0, 30] },
  {
    type: 'setPartBrush',
    ids: ['group-10'],
    change: { colour: '#3f9690', radius: 4, finish: { specular: 0.9 } },
  },
  { type: 'showParts', ids: ['component-9'], visible: true },
  { type: 'moveParts', ids: ['group-13'], by: { rotation: [0, 0.6, 0, 0.8], translation: [0.1, -2, 7] } },
  { type: 'renamePart', id: 'group-13', name: 'Groove' },
  { type: 'renamePart', id: 'component-9', name: 'Sum' },
];

const across = (x: number, dip: number) =>
  strokeAlong((t) => [x + 25 * t, 0 - dip * Math.sin(3.1 * t)], {}, 8);
const SIDE: Plane = { origin: [0, 1, 0], x: [0, 0, -1], y: [0, 1, 0] };
const sideways = (by: number) => strokeAlong((t) => [0 + by * t * t, 30 - 60 * t], { plane: SIDE }, 9);

/** A surface with sections, backs, redraws and bends, another whose strokes are in hand. The next number is 25. */
const SURFACES: readonly Command[] = [
  add(wave(0)),
  add(wave(25)),
  { type: 'addSection', u: 0.5, drawn: { stroke: across(0, 9), half: null } },
  { type: 'addSection', u: 1 / 3, drawn: { stroke: across(0, -4), half: null }, side: 'back' },
  { type: 'addSection', u: 0.8, drawn: { stroke: across(-12.5, 5), half: 12.5 } },
  { type: 'setSurface', change: { back: 'front', between: 'linear', detail: { columns: 12, u: 1 } } },
  KEEP,
  { type: 'removeSection', part: 'part-25', index: 0, only: 'back' },
  { type: 'redrawSection', part: 'part-25', u: 0.55, drawn: { stroke: across(-6, -8), half: 12.5 } },
  {
    type: 'redrawSection',
    part: 'part-25',
    u: 0.1,
    drawn: { stroke: across(-6, -7), half: 12 },
    local: true,
  },
  { type: 'setStroke', part: 'part-25', index: 1, stroke: wave(28) },
  { type: 'bend', id: 'part-25', bend: { stroke: sideways(20), keepsLength: true, isOff: false } },
  { type: 'bend', id: 'part-25', bend: { stroke: sideways(-9), keepsLength: false, isOff: true } },
  { type: 'setBend', id: 'part-25', index: 1, change: { keepsLength: true } },
  { type: 'moveParts', ids: ['part-25'], by: { rotation: [0, 0.6, 0, 0.8], translation: [0.1, -2, 7] } },
  { type: 'duplicateParts', ids: ['part-25'], offset: [90, 0, 0] },
  { type: 'setSurface', ids: ['part-26'], change: { between: 'plain', detail: { rows: 9, finer: -1 } } },
  { type: 'mirrorParts', ids: ['part-26'], about: [5, 0, 0], normal: [0.6, 0.8, 0] },
  { type: 'scaleParts', ids: ['part-25'], factor: 0.7, about: [1, 2, 3] },
  { type: 'recreate', id: 'part-25' },
  { type: 'setForm', form: 'crossSection' },
  KEEP,
  { type: 'recreate', id: 'part-26' },
  { type: 'drop' },
];

/** One of each, in an order in which each has something to do. */
export const COMMANDS: readonly Command[] = [
  add(wave(0)),
  add(wave(25)),
  KEEP,
  { type: 'setBrush', change: { colour: '#7D5238', radius: 3.3, pressure: true } },
  { ...add(circle(20, 5)), form: 'tube' },
  KEEP,
  { type: 'setTubesOnly', on: true },
  add({ ...wave(1), plane: SIDEWAYS, view: { ...VIEW, rotation: [0, HALF, 0, HALF], fov: 30 } }),
  KEEP,
  { type: 'setTubesOnly', on: false },
  { type: 'renamePart', id: 'part-1', name: NAMES[0]! },
  { type: 'renamePart', id: 'part-2', name: NAMES[1]! },
  { type: 'setPartBrush', ids: ['part-2'], change: { caps: false, levels: 2, filter: 'chaikin' } },
  { type: 'showParts', ids: ['part-3'], visible: false },
  {
    type: 'moveParts',
    ids: ['part-1', 'part-3'],
    by: { rotation: [0, 0.6, 0, 0.8], translation: [0.1, -2, 7] },
  },
  { type: 'duplicateParts', ids: ['part-2'], offset: [5, 5, 0] },
  { type: 'removeParts', ids: ['part-3'] },
  add(halfCircle(10, 1)),
  KEEP,
  { type: 'removeLast' },
  add(wave(-9)),
  { type: 'drop' },
  { type: 'addBody', node: EVERY_NODE, name: 'Everything' },
  { type: 'addBody', node: EVERY_NODE, colour: '#7D5238' },
  { type: 'setBody', id: 'part-4', node: { type: 'union', form: 'hard', parts: [EVERY_NODE, EVERY_NODE] } },
  ...SOLIDS,
  ...SURFACES,
  add({ ...wave(3), pointer: 'mouse' }),
  add(wave(-30)),
];

export const historyOf = (commands: readonly Command[]): History => commands.reduce(commit, newHistory());

export const drawingOf = (document: Document): Drawing => ({
  name: 'Pear & <b>stem</b>',
  document,
  view: { pivot: [1, 2, 1 / 3], rotation: [0, HALF, 0, HALF], height: 123.4, fov: 30 },
  look: { ...DEFAULT_LOOK, style: 'hbed-ink', grid: true, creases: 0.1 + 0.2 },
});

/** Kept parts and the unfinished form. */
export function meshesOf(document: Document, resolution = COARSE): readonly Mesh[] {
  const kept = solids(document, resolution).map((solid: Solid) => solid.mesh);
  const kind = readingOf(document);
  const strokes = document.draft?.strokes ?? [];
  if (kind === null || kind === 'solid') return kept;
  const whole = formOfDraft(document.draft!);
  const forms = kind === 'tube' ? strokes.map((stroke) => ({ ...PLAIN, strokes: [stroke] })) : [whole];
  const draft = forms.map((form) => buildForm(kind, form, document.brush, resolution));
  return [...kept, ...draft.filter((mesh) => mesh !== null)];
}

/** A digest of all bytes of each mesh. */
export const bytesOf = (meshes: readonly Mesh[]): readonly string[] =>
  meshes.map(({ positions, normals, uvs, indices }) => {
    const hash = createHash('sha256');
    for (const { buffer, byteOffset, byteLength } of [positions, normals, uvs, indices])
      hash.update(new Uint8Array(buffer, byteOffset, byteLength));
    return `${positions.length} ${indices.length} ${hash.digest('hex')}`;
  });
