/** `rotund mesh`: replays a drawing or a script and writes its solids. */
import { hasSurface, type Resolution, type Solid, solidOf } from '../document/build.ts';
import { type Document, isBody, type Part } from '../document/document.ts';
import { ExportError, modelOf, type OutFile } from '../export/index.ts';
import { type Args, inputOf } from './args.ts';
import { type BodyMaker, withBodyMaker } from './bodyMaker.ts';
import { MESH } from './commands.ts';
import { readInput } from './input.ts';
import { measuresOf, type PartMeasures, total } from './measures.ts';
import { beside, checkOutput, outputOf, stemOf, writeOutputs } from './output.ts';
import { Problem } from './problem.ts';
import { leftOut, nothingBecause, withoutEnd, withoutSurface } from './report.ts';
import { progress, result, say } from './say.ts';
import { backend, exporterOf, resolution, surfaceResolution } from './values.ts';

export async function mesh(args: Args): Promise<void> {
  const started = performance.now();
  const input = inputOf(MESH, args);
  const { values } = args;
  const out = outputOf(values.output, MESH.synopsis);
  const exporter = exporterOf(out);
  const quads = surfaceResolution(values['surface-resolution']);
  const computing = backend(values.backend);
  const cells = resolution(values.resolution);
  checkOutput(out, input);
  const { drawing, name } = await readInput(input);
  const { document } = drawing;
  const { parts, fieldEvaluations } = await withBodyMaker(computing, (make) =>
    measuredParts(document, { name, quads, cells, make }),
  );
  if (parts.length === 0) throw new Problem(`${name}: nothing to export: ${nothingBecause(document)}`);
  const files = await exporter.write(modelOf(document, stemOf(out), quads)).catch((error: unknown) => {
    throw error instanceof ExportError ? new Problem(`${name}: ${error.message}`) : error;
  });
  writeOutputs(placed(files, out, input));
  const milliseconds = Math.round(performance.now() - started);
  result({ ...total(parts), milliseconds, fieldEvaluations: Math.round(fieldEvaluations), parts });
}

interface Building {
  /** of the input */
  readonly name: string;
  readonly quads: Resolution;
  readonly cells: number;
  readonly make: BodyMaker;
}

interface Measured {
  readonly parts: readonly PartMeasures[];
  readonly fieldEvaluations: number;
}

/** Builds part by part, so that it can be said how far it is; what is built is kept for the exporter. */
async function measuredParts(document: Document, building: Building): Promise<Measured> {
  for (const warning of [...leftOut(document), ...withoutEnd(document)]) say(`rotund: ${warning}`);
  const shown = document.parts.filter(({ hidden }) => !hidden);
  const done = progress('parts meshed', shown.length);
  const found: PartMeasures[] = [];
  const without: Part[] = [];
  let fieldEvaluations = 0;
  for (const [i, part] of shown.entries()) {
    const { solid, evaluations } = await built(part, building);
    fieldEvaluations += evaluations;
    if (hasSurface(solid)) found.push(measuresOf(solid));
    else without.push(part);
    done(i + 1);
  }
  for (const warning of withoutSurface(without)) say(`rotund: ${warning}`);
  return { parts: found, fieldEvaluations };
}

interface Built {
  readonly solid: Solid | null;
  readonly evaluations: number;
}

async function built(part: Part, { name, quads, cells, make }: Building): Promise<Built> {
  try {
    const evaluations = isBody(part) ? (await make(part.node, cells)).evaluations : 0;
    return { solid: solidOf(part, quads), evaluations };
  } catch (error) {
    if (error instanceof Problem) throw error;
    const reason = error instanceof Error ? error.message : String(error);
    throw new Problem(`${name}, part “${part.name}”: its surface cannot be built: ${reason}`);
  }
}

/** The file asked for goes where it was asked for, the others beside it. */
function placed(files: readonly OutFile[], out: string, input: string) {
  return files.map(({ name, bytes }, i) => {
    const path = i === 0 ? out : beside(out, name);
    if (i > 0) checkOutput(path, input);
    return { path, bytes };
  });
}
