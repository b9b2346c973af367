/** Commands that aim at what is not there, or that could do nothing: asked of scripts, where nobody sees it. */
import { distance2 } from '../math/tuple.ts';
import { isBendable } from '../surface/deform.ts';
import type { Command } from './command/index.ts';
import { type Document, formOfDraft, isSurface } from './document.ts';
import type { Fault } from './samples.ts';
import { bendOf, sheetOf } from './sheets.ts';
import type { SectionStroke, SurfaceForm } from './surfacePart.ts';

/** What was expected, where; null: nothing is wrong. Whether parts are there was asked before. */
export function missedBy(document: Document, command: Command): Fault | null {
  switch (command.type) {
    case 'addSection':
      return noForm(document, command) ?? noEnds(command.drawn);
    case 'redrawSection':
      return noForm(document, command);
    case 'setStroke':
      return (
        noForm(document, command) ?? noneAt(formOf(document, command)!.strokes, command.index, 'a stroke')
      );
    case 'removeSection':
      return noForm(document, command) ?? noSection(formOf(document, command)!, command);
    case 'bend':
      return noBend(document, command);
    case 'setBend': {
      const { bends } = formOf(document, { part: command.id }) ?? { bends: [] };
      return noneAt(bends, command.index, 'a bend');
    }
    default:
      return null;
  }
}

function formOf({ draft, parts }: Document, { part }: { readonly part?: string }): SurfaceForm | null {
  if (part === undefined) return draft && formOfDraft(draft);
  return parts.filter(isSurface).find(({ id }) => id === part) ?? null;
}

function noForm(document: Document, whose: { readonly part?: string }): Fault | null {
  if (formOf(document, whose)) return null;
  return whose.part === undefined
    ? { expected: 'an unfinished form by then, or the part that is meant', path: ['type'] }
    : { expected: 'the id of a surface', path: ['part'] };
}

const noneAt = (list: readonly unknown[], index: number, what: string): Fault | null =>
  index in list
    ? null
    : { expected: `the index of ${what} that is there by then (${list.length})`, path: ['index'] };

function noSection(
  { sections }: SurfaceForm,
  { index, only, redraw }: Pick<Extract<Command, { type: 'removeSection' }>, 'index' | 'only' | 'redraw'>,
): Fault | null {
  if (redraw !== undefined && only !== 'redraw')
    return { expected: '"redraw" beside a number of what was drawn over it', path: ['only'] };
  const section = sections[index];
  if (!section || !only) return noneAt(sections, index, 'a section');
  const { back, redraws } = section;
  if (redraw !== undefined && redraws.length > 0) {
    const stray = noneAt(redraws, redraw, 'a redrawing');
    return stray && { ...stray, path: ['redraw'] };
  }
  const isThere = only === 'back' ? back !== null : redraws.length > 0;
  const what = only === 'back' ? 'a back' : 'something drawn over it';
  return isThere ? null : { expected: `a section that has ${what} by then`, path: ['only'] };
}

function noEnds({ stroke: { samples } }: SectionStroke): Fault | null {
  const [first, last] = [samples[0]!, samples.at(-1)!];
  return distance2([first.x, first.y], [last.x, last.y]) > 0
    ? null
    : { expected: 'a stroke whose ends are in two places', path: ['drawn', 'stroke'] };
}

function noBend(document: Document, { id, bend }: Extract<Command, { type: 'bend' }>): Fault | null {
  const part = document.parts.filter(isSurface).find((other) => other.id === id);
  if (!part) return { expected: 'the id of a surface', path: ['id'] };
  const [input] = bendOf(bend, part.strokes[0]!.plane, part.brush);
  if (!input) return { expected: 'a stroke that is longer than a dot', path: ['bend', 'stroke'] };
  const sheet = sheetOf(part.kind, part, part.brush);
  return !sheet || isBendable(sheet.spine, input.plane)
    ? null
    : {
        expected: 'a plane across which the part is seen, not from its end',
        path: ['bend', 'stroke', 'plane'],
      };
}
