/** A figure of three solids' worth of forms, for tests of what is done with groups: a body and a head that blend, an ear, an eye that is attached; a ring apart. */
import { apply, type Command } from '../../src/document/command/index.ts';
import { type Document, EMPTY_DOCUMENT, isSolid, type SolidPart } from '../../src/document/document.ts';
import { type Group, groupsOf } from '../../src/document/solid.ts';
import type { Stroke } from '../../src/stroke/stroke.ts';
import { strokeAlong } from './strokes.ts';

/** A closed stroke. */
export const oval = (x: number, y: number, a: number, b: number, z = 0): Stroke =>
  strokeAlong(
    (t) => [x + a * Math.cos(2 * Math.PI * t), y + b * Math.sin(2 * Math.PI * t)],
    {
      closed: true,
      plane: { origin: [0, 0, z], x: [1, 0, 0], y: [0, 1, 0] },
    },
    61,
  );

const KEEP: Command = { type: 'keep' };

/** part-1: component 1 of body, head and ear, component 2 of the eye; then a ring of its own. */
export function figure(): Document {
  const body = run(EMPTY_DOCUMENT, { type: 'addStroke', stroke: oval(0, -30, 34, 30) }, KEEP);
  const solid = body.parts[0] as SolidPart;
  const joins = { solid: solid.id, component: solid.components[0]!.id };
  return run(
    body,
    { type: 'addStroke', stroke: oval(0, 15, 26, 22), joins },
    KEEP,
    { type: 'addStroke', stroke: oval(-14, 52, 7, 24), joins },
    KEEP,
    {
      type: 'addStroke',
      stroke: oval(-9, 20, 4, 4, 20),
      form: 'point',
      joins: { ...joins, component: null },
    },
    KEEP,
    { type: 'addStroke', stroke: oval(70, 0, 20, 20), form: 'ring' },
    KEEP,
    ...['Body', 'Head', 'Ear', 'Eye'].map((name, i): Command => ({ type: 'renamePart', id: `#${i}`, name })),
  );
}

function run(document: Document, ...commands: readonly Command[]): Document {
  return commands.reduce((before, command) => {
    const [, place] = ('id' in command && /^#(\d)$/.exec(command.id)) || [];
    if (place === undefined || command.type !== 'renamePart') return apply(before, command);
    return apply(before, { ...command, id: solidOf(before).groups[Number(place)]!.id });
  }, document);
}

export interface Figure {
  readonly part: SolidPart;
  readonly groups: readonly Group[];
}

/** The first solid, and its groups in order. */
export function solidOf({ parts }: Document): Figure {
  const part = parts.find(isSolid)!;
  return { part, groups: groupsOf(part) };
}
