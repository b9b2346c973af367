/** Random sequences of commands of surfaces: what a file holds is the document there is, and undo leads back to the start. */
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { draftSolids, solids } from '../../src/document/build.ts';
import type { Command } from '../../src/document/command/index.ts';
import { isSurface } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { commit, type History, newHistory, undo, undoable } from '../../src/document/history.ts';
import { parse, replay, serialize } from '../../src/document/serialize.ts';
import { BACKS, BETWEENS } from '../../src/document/surfacePart.ts';
import { topology } from '../../src/mesh/check.ts';
import { anyStrokes } from './anySurface.ts';

const BLOCKS = process.env.ROTUND_FULL ? 20 : 2;
const BLOCK = 25;
const STEPS = 14;

/** What may be of a part, or of the unfinished form. */
const choice = fc.record({
  pick: fc.nat(99),
  u: fc.double({ min: 0, max: 1, noNaN: true }),
  index: fc.nat(2),
  flag: fc.boolean(),
  line: anyStrokes.line,
  across: anyStrokes.across,
  onSection: anyStrokes.onSection,
  bend: anyStrokes.bend,
  back: fc.constantFrom(...BACKS),
  between: fc.constantFrom(...BETWEENS),
});
type Choice = typeof choice extends fc.Arbitrary<infer T> ? T : never;

const MAKERS: readonly ((from: Choice, ids: readonly string[]) => Command)[] = [
  ({ line }) => ({ type: 'addStroke', stroke: line }),
  ({ line }) => ({ type: 'addStroke', stroke: line }),
  () => ({ type: 'keep' }),
  ({ flag }) => ({ type: flag ? 'drop' : 'keep' }),
  ({ flag }) => ({ type: 'setTubesOnly', on: flag }),
  ({ index }) => ({ type: 'setForm', form: (['tube', 'rotational', 'crossSection'] as const)[index]! }),
  ({ u, across, flag }, ids) => ({
    type: 'addSection',
    u,
    drawn: across,
    side: flag ? 'front' : 'back',
    ...whose(ids),
  }),
  ({ u, across }, ids) => ({ type: 'addSection', u, drawn: across, ...whose(ids) }),
  ({ index, flag, back }, ids) => ({
    type: 'removeSection',
    index,
    ...(flag && { only: 'redraw', ...(back === 'drawn' && { redraw: 0 }) }),
    ...whose(ids),
  }),
  ({ u, onSection, flag }, ids) => ({
    type: 'redrawSection',
    u,
    drawn: onSection,
    ...(flag && { local: true as const }),
    ...whose(ids),
  }),
  ({ index, flag, line }, ids) => ({ type: 'setStroke', index, stroke: flag ? line : null, ...whose(ids) }),
  ({ back, between, index, u }, ids) => ({
    type: 'setSurface',
    change: [{ back }, { between }, { detail: { rows: 2 + index, u: Math.round(u) } }][index]!,
    ...(ids.length > 0 && { ids }),
  }),
  ({ bend }, ids) => ({ type: 'bend', id: ids[0] ?? 'none', bend }),
  ({ index, flag }, ids) => ({
    type: 'setBend',
    id: ids[0] ?? 'none',
    index,
    change: flag ? { isOff: true } : null,
  }),
  (_, ids) => ({ type: 'recreate', id: ids[0] ?? 'none' }),
  (_, ids) => ({ type: 'removeParts', ids }),
  ({ u }, ids) => ({
    type: 'moveParts',
    ids,
    by: { rotation: [0.48, 0.6, 0, 0.64], translation: [9 * u, 3, 1] },
  }),
  (_, ids) => ({ type: 'mirrorParts', ids, about: [1, 2, 3], normal: [0.6, 0.8, 0] }),
  ({ u }, ids) => ({ type: 'scaleParts', ids, factor: 0.5 + u, about: [1, 2, 3] }),
  (_, ids) => ({ type: 'duplicateParts', ids: ids.slice(0, 1), offset: [5, 5, 5] }),
];

const whose = ([part]: readonly string[]) => (part === undefined ? {} : { part });

function step(history: History, { maker, from }: { readonly maker: number; readonly from: Choice }): History {
  const { parts } = history.present;
  const part = parts[from.pick % (parts.length + 1)];
  return commit(history, MAKERS[maker]!(from, part ? [part.id] : []));
}

const toStart = (history: History): History =>
  undoable(history) === null ? history : toStart(undo(history));

describe.each(Array.from({ length: BLOCKS }, (_, block) => block + 1))('walks of seed %i', (seed) => {
  it('are what files hold, and lead back', { timeout: 240_000 }, () => {
    const move = fc.record({ maker: fc.nat(MAKERS.length - 1), from: choice });
    const moves = fc.array(move, { minLength: STEPS, maxLength: STEPS });
    fc.assert(
      fc.property(fc.noBias(moves), (all) => {
        const history = all.reduce(step, newHistory());
        const document = history.present;
        expect(parse(serialize({ ...EMPTY_DRAWING, document }), 'x').document).toEqual(document);
        expect(replay(history.past.map(({ command }) => command))).toEqual(document);
        expect(toStart(history).present).toBe(newHistory().present);
        const meshes = [...solids(document, { u: 8, v: 6 }), ...draftSolids(document)];
        for (const { mesh } of meshes) expect(topology(mesh).finite).toBe(true);
        for (const part of document.parts.filter(isSurface)) expect(part.strokes.length).toBeGreaterThan(0);
      }),
      { seed, numRuns: BLOCK, endOnFailure: true },
    );
  });
});
