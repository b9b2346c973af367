/** Values of options: what is written on the command line, checked. */
import { RESOLUTION, type Resolution } from '../document/build.ts';
import { type Mode, PICTURE_SIDE, STYLES, type Style } from '../document/look.ts';
import { type Exporter, exporters, type Format } from '../export/index.ts';
import { RESOLUTION as CELLS_RANGE } from '../field/lattice.ts';
import { Problem } from './problem.ts';

interface Range {
  readonly least: number;
  readonly most: number;
}

const SURFACE: Range = { least: 4, most: 1024 };
const CELL_RANGE: Range = { least: 8, most: CELLS_RANGE.max };

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** `64` or `64x32`. The default is the application's own, by reference: meshes are cached by it. */
export function surfaceResolution(text: string | undefined): Resolution | null {
  if (text === undefined) return null;
  const [u, v] = pair('--surface-resolution', text, text.includes('x') ? 2 : 1, SURFACE, '64 or 64x64');
  return u === RESOLUTION.u && v === RESOLUTION.v ? RESOLUTION : { u, v };
}

/** Cells along a document's longest side; null where it is not given. */
export function resolution(text: string | undefined): number | null {
  return text === undefined ? null : pair('--resolution', text, 1, CELL_RANGE, '128')[0];
}

export function size(text: string | undefined): Size {
  if (text === undefined) return { width: 1024, height: 768 };
  const [width, height] = pair('--size', text, 2, PICTURE_SIDE, '1024x768');
  return { width, height };
}

function pair(
  option: string,
  text: string,
  count: 1 | 2,
  { least, most }: Range,
  example: string,
): readonly [number, number] {
  const words = text.split('x');
  const numbers = words.map((word) => (/^\d{1,9}$/.test(word) ? Number(word) : Number.NaN));
  if (words.length !== count || !numbers.every((n) => n >= least && n <= most)) {
    const what = count === 2 ? 'two whole numbers' : 'a whole number';
    throw new Problem(
      `${option}: expected ${what} from ${least} to ${most}, as in ${example}; found '${text}'`,
    );
  }
  return [numbers[0]!, numbers.at(-1)!];
}

export function style(text: string | undefined): Style | undefined {
  if (text === undefined) return undefined;
  const known = STYLES.find((name) => name === text);
  if (!known) throw new Problem(`--style: expected one of ${STYLES.join(', ')}; found '${text}'`);
  return known;
}

/** Without the option as the drawing has it. */
export function mode(text: string | undefined): Mode | undefined {
  if (text === undefined || text === 'mesh') return text;
  // the application's own word
  if (text === 'raycast' || text === 'exact') return 'exact';
  throw new Problem(`--mode: expected mesh or raycast; found '${text}'`);
}

/** Whose rays: ours, or those that are compared with them, in the mode they are of. */
export function rays(text: string | undefined, of: Mode | undefined): 'bricks' | 'zhu' {
  if (text === undefined) return 'bricks';
  if (text !== 'bricks' && text !== 'zhu')
    throw new Problem(`--rays: expected bricks or zhu; found '${text}'`);
  if (of !== 'exact') throw new Problem(`--rays ${text} needs --mode raycast`);
  return text;
}

export type Backend = 'cpu' | 'gpu';

export function backend(text: string | undefined): Backend {
  if (text === undefined || text === 'cpu' || text === 'gpu') return text ?? 'cpu';
  throw new Problem(`--backend: expected cpu or gpu; found '${text}'`);
}

const FUTURE_FORMATS: readonly string[] = ['3mf'];

/** The exporter for a file's name. */
export function exporterOf(path: string): Exporter {
  const extension = extensionOf(path);
  if (Object.hasOwn(exporters, extension)) return exporters[extension as Format];
  const known = Object.keys(exporters)
    .map((id) => `.${id}`)
    .join(', ');
  if (FUTURE_FORMATS.includes(extension)) {
    throw new Problem(`${path}: the format ${extension} does not exist yet; expected ${known}`);
  }
  throw new Problem(`${path}: the extension names the format; expected ${known}, found ${found(extension)}`);
}

export function checkPicture(path: string): void {
  const extension = extensionOf(path);
  if (extension === 'png') return;
  throw new Problem(`${path}: pictures are written as .png, found ${found(extension)}`);
}

const found = (extension: string): string => (extension ? `.${extension}` : 'none');

function extensionOf(path: string): string {
  return /[^/\\]\.([^./\\]*)$/.exec(path)?.[1]?.toLowerCase() ?? '';
}
