/** The records of a convolution body: its skels, their warps, and the terms that put them together. Twin of src/field/skelSum.ts. */
import { PLAIN } from '../field/bind.ts';
import type { SkelsNode, Term } from '../field/node.ts';
import { piecesOf } from '../field/pieces.ts';
import { type Frame, framed, type Warp } from '../field/warp.ts';
import { kernelNamed } from '../kernel/index.ts';
import type { Kernel } from '../kernel/kernel.ts';
import type { RecordValue } from '../math/record.ts';
import type { Skel } from '../skeleton/skels.ts';
import type { Heap } from './heap.ts';
import { numberOf } from './ingredients.ts';
import type { Writer } from './program.ts';
import { addSkel } from './records.ts';
import { PROFILE, SUM, TERM, WARP } from './structs.ts';

type TermRecord = RecordValue<(typeof TERM)['members']>;

/** Adds the record of a checked body and all it refers to; says where. */
export function addSum(writer: Writer, node: SkelsNode): number {
  const kernel = kernelNamed(node.kernel)!;
  const terms = piecesOf(node).map(({ skel, term }) => addTerm(writer, node, kernel, term, skel));
  const { heap } = writer;
  const first = heap.next;
  for (const term of terms) heap.add(TERM, term);
  return heap.add(SUM, { colour: terms[0]!.colour, threshold: node.threshold, first, end: heap.next });
}

function addTerm(
  { heap, used }: Writer,
  { params, colour }: SkelsNode,
  kernel: Kernel,
  term: Term,
  skel: Skel,
): TermRecord {
  const warp = shapingWarp(term);
  const { frame, local } = warp ? framed(skel, warp) : { frame: null, local: skel };
  used.kernels.add(kernel.name);
  used.primitives.add(skel.type);
  if (warp) used.sections.add(warp.section.type);
  return {
    colour: term.colour ?? colour ?? PLAIN,
    factor: term.factor ?? 1,
    skel: addSkel(heap, { skel: local, kernel, params: term.params ?? params }),
    warp: warp && frame ? addWarp(heap, frame, warp) : 0,
    kernel: numberOf('kernels', kernel.name),
    primitive: numberOf('primitives', skel.type),
  };
}

/** A round section as wide as it is high is none. */
function shapingWarp({ warp }: Term): Warp | null {
  const isPlain = warp?.section.type === 'round' && warp.scale[0] === 1 && warp.scale[1] === 1;
  return !warp || isPlain ? null : warp;
}

function addWarp(heap: Heap, { origin, x, y, z }: Frame, { section, scale }: Warp): number {
  const profile = section.type === 'polar' ? addProfile(heap, section.radii) : 0;
  return heap.add(WARP, {
    origin,
    axes: [...x, ...y, ...z],
    scale,
    exponent: 'exponent' in section ? section.exponent : 0,
    section: numberOf('sections', section.type),
    profile,
  });
}

function addProfile(heap: Heap, radii: readonly number[]): number {
  const four = (i: number) => radii.slice(4 * i, 4 * i + 4);
  return heap.add(PROFILE, { a: four(0), b: four(1), c: four(2), d: four(3), e: four(4), f: four(5) });
}
