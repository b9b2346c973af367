/** The parts of a drawing as meshes with their measures, one after the other. */
import { CELLS } from '../document/bodies.ts';
import { hasSurface, RESOLUTION, type Resolution, type Solid, solidOf } from '../document/build.ts';
import { cellsOfBodies } from '../document/cells.ts';
import { type Document, isImplicit, type Part } from '../document/document.ts';
import { boxOfMesh } from '../document/extent.ts';
import { nodeOf } from '../document/solidNode.ts';
import { longest } from '../field/boxes.ts';
import type { FieldNode } from '../field/node.ts';
import { type BodyMaker, type MadeBody, shownWhole } from './bodyMaker.ts';
import { measuresOf, type PartMeasures } from './measures.ts';
import { Problem } from './problem.ts';
import { leftOut, withoutEnd, withoutSurface } from './report.ts';
import { progress, say } from './say.ts';
import { lostParts, type MadePart, thinBody, thinParts } from './thin.ts';

export interface Building {
  /** of the input */
  readonly name: string;
  /** null: as surfaces say themselves */
  readonly quads: Resolution | null;
  /** along the document; null: nobody asked for any */
  readonly cells: number | null;
  readonly make: BodyMaker;
}

interface Meshed {
  readonly parts: readonly MeshedPart[];
  readonly fieldEvaluations: number;
}

/** A part of the JSON. */
type MeshedPart = PartMeasures & MadePart;

/** Builds part by part, so that it can be said how far it is; what is built is kept for the exporter. */
export async function meshedParts(document: Document, building: Building): Promise<Meshed> {
  for (const warning of [...leftOut(document), ...withoutEnd(document)]) say(`rotund: ${warning}`);
  const shown = document.parts.filter(({ hidden }) => !hidden);
  const done = progress('parts meshed', shown.length);
  const bodies = bodiesOf(document, building);
  const found: MeshedPart[] = [];
  const without: Part[] = [];
  const lost: (MadePart & Pick<Part, 'name'>)[] = [];
  for (const [i, part] of shown.entries()) {
    const { solid, body } = await built(part, building, bodies);
    const own = thinBody(document, part, body);
    if (hasSurface(solid)) found.push({ ...measuresOf(solid), ...own });
    else if (own.thin) lost.push({ ...own, name: part.name });
    else without.push(part);
    done(i + 1);
  }
  const warnings = [...withoutSurface(without), ...lostParts(lost), ...thinParts(found)];
  for (const warning of warnings) say(`rotund: ${warning}`);
  const fieldEvaluations = bodies.made().reduce((sum, { evaluations }) => sum + evaluations, 0);
  return { parts: found, fieldEvaluations };
}

/** Makes each body once, however many parts have its tree. */
function bodiesOf(document: Document, { cells, make }: Building) {
  const made = new Map<FieldNode, MadeBody>();
  const cellsOf = cellsOfBodies(document, cells ?? CELLS);
  return {
    async of(node: FieldNode, name: string): Promise<MadeBody> {
      const wanted = cellsOf(node);
      const body = made.get(node) ?? (await (cells === null ? shownWhole(make) : make)(node, wanted, name));
      made.set(node, body);
      return body;
    },
    made: () => [...made.values()],
  };
}

type Bodies = ReturnType<typeof bodiesOf>;

/** of neighbouring float32 numbers, 2⁻²³ of their size apart: narrower cells are no shapes any more */
const FEWEST = 8;

/** Where a part was moved to its cells may be less than numbers of a mesh can tell. */
function checkPlaced({ mesh }: Solid, cells: number): void {
  const box = boxOfMesh(mesh);
  const far = Math.max(...[...box.min, ...box.max].map(Math.abs));
  if (longest(box) / cells > FEWEST * 1.1920929e-7 * far) return;
  throw new Error(
    `it lies ${Number(far.toPrecision(2))} mm from the origin, too far for a mesh of what is this small`,
  );
}

interface Built {
  readonly solid: Solid | null;
  readonly body: MadeBody | null;
}

async function built(part: Part, { name, quads }: Building, bodies: Bodies): Promise<Built> {
  try {
    const body = isImplicit(part) ? await bodies.of(nodeOf(part), part.name) : null;
    const solid = solidOf(part, quads);
    if (solid && hasSurface(solid)) checkPlaced(solid, body?.cells ?? (quads ?? RESOLUTION).u);
    return { solid, body };
  } catch (error) {
    if (error instanceof Problem) throw error;
    const reason = error instanceof Error ? error.message : String(error);
    throw new Problem(`${name}, part “${part.name}”: its surface cannot be built: ${reason}`);
  }
}
