/**
 * Surfaces from strokes on one thread, by the processor's time: each kind built anew at two resolutions, straight and bent; one bend and
 * the last of three that follow the pen; and what a frame of dragging takes of a document with 100 parts when one of them follows the pen.
 */
import { readFileSync } from 'node:fs';
import { solids } from '../../src/document/build.ts';
import { apply, type Command } from '../../src/document/command/index.ts';
import { curveOfStroke } from '../../src/document/curves.ts';
import { DEFAULT_BRUSH, type Document, isSurface, type SurfacePart } from '../../src/document/document.ts';
import { outlinesOf } from '../../src/document/outlines.ts';
import { parse } from '../../src/document/serialize.ts';
import { sheetOf } from '../../src/document/sheets.ts';
import { PI, sincos } from '../../src/math/trig.ts';
import { facingPlane } from '../../src/stroke/plane.ts';
import type { Stroke } from '../../src/stroke/stroke.ts';
import { buildSurface, type SurfaceKind, sheetMesh } from '../../src/surface/index.ts';
import { within } from '../../src/surface/sideView.ts';
import { processorTime, rounded } from './timing.ts';

const KINDS: readonly SurfaceKind[] = ['tube', 'rotational', 'crossSection', 'bspline'];
const SIDES = [64, 256];
const COPIES = 25;
const brush = DEFAULT_BRUSH;

const read = (): SurfacePart =>
  parse(readFileSync('public/samples/pumpkin.rotund', 'utf8'), 'pumpkin').document.parts.find(isSurface)!;

/** The pumpkin's body as all kinds: one stroke, two, two with its ribs across, and with them in two places. */
function formOf(kind: SurfaceKind, { strokes, sections, ...part }: SurfacePart): SurfacePart {
  const [ribs] = sections;
  return {
    ...part,
    kind,
    strokes: kind === 'tube' ? strokes.slice(0, 1) : strokes,
    sections:
      kind === 'crossSection'
        ? sections
        : kind === 'bspline'
          ? [
              { ...ribs!, u: 0.3 },
              { ...ribs!, u: 0.7 },
            ]
          : [],
  };
}

/** A centre line that leans over, as drawn from the side; `by` makes it another one. */
function leaning(from: Stroke, by: number): Stroke {
  const view = { ...from.view, rotation: [0, Math.SQRT1_2, 0, Math.SQRT1_2] as const };
  const samples = Array.from({ length: 60 }, (_, i) => {
    const [sin, cos] = sincos((PI * i) / 118);
    return { x: -80 * (1 - cos) + by, y: 30 - 80 * sin, pressure: 0.5, tiltX: 0, tiltY: 0, time: 8 * i };
  });
  return { samples, plane: facingPlane(view, [0, 0, 0]), view, pointer: 'pen', closed: false };
}

const bendOf = (stroke: Stroke) => ({ stroke, keepsLength: true, isOff: false });

function builder(kind: SurfaceKind, side: number, bent: boolean): () => unknown {
  const part = formOf(kind, read());
  const plane = part.strokes[0]!.plane;
  const curves = part.strokes.map((stroke) => curveOfStroke(stroke, brush)!);
  const stroke = leaning(part.strokes[0]!, 0);
  const bend = {
    curve: curveOfStroke(stroke, brush)!,
    plane: within(stroke.plane, plane),
    keepsLength: true,
  };
  const input = { curves, sections: outlinesOf(kind, part, brush, curves), bends: bent ? [bend] : [] };
  const options = { radius: 6, pressure: false, caps: true, u: side, v: side };
  return () => buildSurface(kind, input, plane, options);
}

/** Of curves that nothing is known of yet. */
function anew(kind: SurfaceKind, side: number, bent: boolean, rounds: number): number {
  return Math.min(...Array.from({ length: rounds }, () => processorTime(builder(kind, side, bent), 1)));
}

for (const kind of KINDS) anew(kind, 64, true, 20);
console.log(
  'Surfaces built anew from filtered strokes, ms; and how often a rotational surface is built meanwhile',
);
const whole = SIDES.map((side) => anew('rotational', side, false, 20));
console.table(
  KINDS.flatMap((kind) =>
    [false, true].map((bent) => ({
      kind: bent ? `${kind}, bent` : kind,
      ...Object.fromEntries(
        SIDES.flatMap((side, i) => {
          const ms = anew(kind, side, bent, 12);
          return [
            [`${side} × ${side}`, ms],
            [`ratio, ${side}`, rounded(ms / whole[i]!, 2)],
          ];
        }),
      ),
    })),
  ),
);

/** A frame in which the last of `bends` follows the pen: the sheet and its mesh. */
function following(kind: SurfaceKind, side: number, bends: number): () => unknown {
  const part = formOf(kind, read());
  const kept = Array.from({ length: bends - 1 }, (_, i) => bendOf(leaning(part.strokes[0]!, i)));
  let by = 0;
  return () => {
    const last = bendOf(leaning(part.strokes[0]!, 0.01 * ++by));
    const form = { ...part, bends: [...kept, last] };
    return sheetMesh(sheetOf(kind, form, brush, { u: side, v: side }), part.strokes[0]!.plane);
  };
}

console.log('A bend that follows the pen, from its filtered stroke to the mesh, ms');
console.table(
  KINDS.flatMap((kind) =>
    [1, 3].map((bends) => ({
      kind,
      bends,
      ...Object.fromEntries(
        SIDES.map((side) => [`${side} × ${side}`, processorTime(following(kind, side, bends), 12)]),
      ),
    })),
  ),
);

/** Every kind 25 times, strokes of their own, bent. */
function garden(): Document {
  const forms = KINDS.flatMap((kind) => Array.from({ length: COPIES }, () => formOf(kind, read())));
  const parts = forms.map((form, i) => ({
    ...form,
    id: `part-${i + 1}`,
    name: `Part ${i + 1}`,
    bends: [bendOf(leaning(form.strokes[0]!, 0))],
  }));
  const { document } = parse(readFileSync('public/samples/pumpkin.rotund', 'utf8'), 'pumpkin');
  return { ...document, parts, nextId: parts.length + 1 };
}

const document = garden();
const fresh = processorTime(() => solids(garden()), 2);
solids(document);
let step = 0;

/** A frame of the pen: the command of one more sample, and all meshes. */
const frame = (command: (by: number) => Command) =>
  processorTime(() => solids(apply(document, command(0.01 * ++step))), 20);

console.log(`A frame with ${4 * COPIES} parts, ms: one follows the pen. All of them anew: ${fresh} ms`);
console.table(
  KINDS.map((kind, i) => {
    const id = `part-${i * COPIES + 3}`;
    const { strokes } = document.parts.filter(isSurface).find((part) => part.id === id)!;
    const bend = frame((by) => ({
      type: 'setBend',
      id,
      index: 0,
      change: { stroke: leaning(strokes[0]!, by) },
    }));
    const redrawn = frame((by) => ({
      type: 'redrawSection',
      part: id,
      u: 0.5,
      drawn: { stroke: { ...leaning(strokes[0]!, by), plane: strokes[0]!.plane }, half: 70 },
    }));
    return { kind, bend, 'of all anew': rounded(bend / fresh, 4), redrawn };
  }),
);
console.log(
  'Nothing changes, ms:',
  processorTime(() => solids(document), 20),
);
