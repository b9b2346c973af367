/** Documents and scripts for the tests of files. */
import { createHash } from 'node:crypto';
import type { Resolution, Solid } from '../../src/document/build.ts';
import { buildForm, solids } from '../../src/document/build.ts';
import type { Command } from '../../src/document/command/index.ts';
import { type Document, readingOf } from '../../src/document/document.ts';
import type { Drawing } from '../../src/document/drawing.ts';
import { commit, type History, newHistory } from '../../src/document/history.ts';
import { DEFAULT_LOOK } from '../../src/document/look.ts';
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
const add = (stroke = wave(0)): Command => ({ type: 'addStroke', stroke });
const KEEP: Command = { type: 'keep' };

/** One of each, in an order in which each has something to do. */
export const COMMANDS: readonly Command[] = [
  add(wave(0)),
  add(wave(25)),
  KEEP,
  { type: 'setBrush', change: { colour: '#7D5238', radius: 3.3, pressure: true } },
  add(circle(20, 5)),
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
  const forms = kind === 'tube' ? strokes.map((stroke) => [stroke]) : [strokes];
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
