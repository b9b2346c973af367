/** `rotund mesh`: replays a drawing or a script and writes its solids. */
import { ExportError, modelOf, type OutFile } from '../export/index.ts';
import { type Args, inputOf } from './args.ts';
import { withBodyMaker } from './bodyMaker.ts';
import { MESH } from './commands.ts';
import { readInput } from './input.ts';
import { total } from './measures.ts';
import { meshedParts } from './meshedParts.ts';
import { beside, checkOutput, outputOf, stemOf, writeOutputs } from './output.ts';
import { Problem } from './problem.ts';
import { nothingBecause } from './report.ts';
import { result } from './say.ts';
import { allMade } from './thin.ts';
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
    meshedParts(document, { name, quads, cells, make }),
  );
  if (parts.length === 0) throw new Problem(`${name}: nothing to export: ${nothingBecause(document)}`);
  const files = await exporter.write(modelOf(document, stemOf(out), quads)).catch((error: unknown) => {
    throw error instanceof ExportError ? new Problem(`${name}: ${error.message}`) : error;
  });
  writeOutputs(placed(files, out, input));
  const milliseconds = Math.round(performance.now() - started);
  result({
    ...total(parts),
    ...allMade(parts),
    milliseconds,
    fieldEvaluations: Math.round(fieldEvaluations),
    parts,
  });
}

/** The file asked for goes where it was asked for, the others beside it. */
function placed(files: readonly OutFile[], out: string, input: string) {
  return files.map(({ name, bytes }, i) => {
    const path = i === 0 ? out : beside(out, name);
    if (i > 0) checkOutput(path, input);
    return { path, bytes };
  });
}
