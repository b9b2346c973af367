/** `rotund mesh`: replays a drawing or a script and writes its solids. */
import { hasSurface, type Resolution, type Solid, solidOf } from '../document/build.ts';
import type { Document, Part } from '../document/document.ts';
import { ExportError, modelOf, type OutFile } from '../export/index.ts';
import { type Args, inputOf } from './args.ts';
import { MESH } from './commands.ts';
import { readInput } from './input.ts';
import { measuresOf, type PartMeasures, total } from './measures.ts';
import { beside, checkOutput, outputOf, stemOf, writeOutputs } from './output.ts';
import { Problem } from './problem.ts';
import { leftOut, nothingBecause, withoutSurface } from './report.ts';
import { progress, result, say } from './say.ts';
import { backend, exporterOf, resolution, surfaceResolution } from './values.ts';

export async function mesh(args: Args): Promise<void> {
  const started = performance.now();
  const input = inputOf(MESH, args);
  const { values } = args;
  const out = outputOf(values.output, MESH.synopsis);
  const exporter = exporterOf(out);
  const quads = surfaceResolution(values['surface-resolution']);
  resolution(values.resolution);
  backend(values.backend);
  checkOutput(out, input);
  const { drawing, name } = await readInput(input);
  const { document } = drawing;
  const parts = measuredParts(document, quads, name);
  if (parts.length === 0) throw new Problem(`${name}: nothing to export: ${nothingBecause(document)}`);
  const files = await exporter.write(modelOf(document, stemOf(out), quads)).catch((error: unknown) => {
    throw error instanceof ExportError ? new Problem(`${name}: ${error.message}`) : error;
  });
  writeOutputs(placed(files, out, input));
  const milliseconds = Math.round(performance.now() - started);
  result({ ...total(parts), milliseconds, fieldEvaluations: 0, parts });
}

/** Builds part by part, so that it can be said how far it is; what is built is kept for the exporter. */
function measuredParts(document: Document, quads: Resolution, name: string): PartMeasures[] {
  for (const warning of leftOut(document)) say(`rotund: ${warning}`);
  const shown = document.parts.filter(({ hidden }) => !hidden);
  const done = progress('parts meshed', shown.length);
  const found: PartMeasures[] = [];
  const without: Part[] = [];
  shown.forEach((part, i) => {
    const solid = built(part, quads, name);
    if (hasSurface(solid)) found.push(measuresOf(solid));
    else without.push(part);
    done(i + 1);
  });
  for (const warning of withoutSurface(without)) say(`rotund: ${warning}`);
  return found;
}

function built(part: Part, quads: Resolution, name: string): Solid | null {
  try {
    return solidOf(part, quads);
  } catch (error) {
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
