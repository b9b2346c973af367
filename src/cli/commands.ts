/**
 * The commands and their options as data: arguments are read by it, and help is printed from it.
 */
import { PICTURE_SIDE, STYLES } from '../document/look.ts';

export interface Option {
  readonly name: string;
  readonly short?: string;
  /** what stands after it; without, it stands alone */
  readonly value?: string;
  readonly help: string;
}

export interface CommandSpec {
  readonly name: 'mesh' | 'render' | 'info' | 'field';
  readonly synopsis: string;
  /** one line */
  readonly summary: string;
  /** what its operands are, a sentence */
  readonly input: string;
  readonly options: readonly Option[];
  /** what a line of standard output says */
  readonly output: string;
  /** what there is a line for; one in all without */
  readonly linePer?: string;
}

const HELP: Option = { name: 'help', short: 'h', help: 'print this help' };

const BACKEND: Option = {
  name: 'backend',
  value: 'cpu|gpu',
  help: 'what computes the meshes of bodies: cpu in float64, gpu in float32 through the package webgpu (cpu)',
};

const DRAWING = 'IN is a drawing (.rotund) or a script of commands; - reads standard input.';

export const MESH: CommandSpec = {
  name: 'mesh',
  synopsis: 'rotund mesh IN -o OUT.{obj,glb,stl,ply}',
  summary: 'write the solids of a drawing as a mesh',
  input: DRAWING,
  options: [
    { name: 'output', short: 'o', value: 'FILE', help: 'the file to write; its extension names the format' },
    {
      name: 'surface-resolution',
      value: 'N|UxV',
      help: 'quads along and around a surface made from strokes, 4 to 1024 each (as the drawing says, else 64x64)',
    },
    {
      name: 'resolution',
      value: 'N',
      help: 'cells along the longest side of the whole drawing, 8 to 512; small bodies have as large ones, but 32 at least (128, and up to twice as many where a body is thin)',
    },
    BACKEND,
    HELP,
  ],
  output:
    '{vertices, triangles, watertight, genus, volume, area, bounds, backend, thin, milliseconds, fieldEvaluations, parts}',
};

export const RENDER: CommandSpec = {
  name: 'render',
  synopsis: 'rotund render IN -o OUT.png',
  summary: 'the picture that the application shows, through headless Chromium',
  input: DRAWING,
  options: [
    { name: 'output', short: 'o', value: 'FILE', help: 'the picture to write, a .png' },
    {
      name: 'size',
      value: 'WxH',
      help: `pixels, ${PICTURE_SIDE.least} to ${PICTURE_SIDE.most} each (1024x768)`,
    },
    {
      name: 'camera',
      value: 'VIEW',
      help: 'front, back, left, right, top, bottom, or yaw,pitch[,roll] in degrees; frames the whole model (the view stored in the drawing)',
    },
    { name: 'style', value: 'NAME', help: `${STYLES.join(', ')} (the style stored in the drawing)` },
    {
      name: 'mode',
      value: 'mesh|raycast',
      help: 'how bodies are drawn: triangles, or their exact surface by rays (as stored in the drawing)',
    },
    {
      name: 'rays',
      value: 'bricks|zhu',
      help: 'with --mode raycast: the application’s rays through bricks, or to compare those of Zhu et al. 2011 (bricks)',
    },
    HELP,
  ],
  output: '{width, height, backend, rays, milliseconds}',
};

export const INFO: CommandSpec = {
  name: 'info',
  synopsis: 'rotund info IN',
  summary: 'what is in a drawing, as counts',
  input: DRAWING,
  options: [HELP],
  output: '{parts, strokes, components, groups, skels, warnings}',
};

export const FIELD: CommandSpec = {
  name: 'field',
  synopsis: 'rotund field VECTORS.json…',
  summary: 'hold the fields of skels against reference vectors',
  input: 'VECTORS.json are files of reference vectors (docs/cli.md describes them); - reads standard input.',
  options: [
    {
      name: 'backend',
      value: 'cpu|gpu',
      help: 'what evaluates the fields: cpu in float64, gpu in float32 through the package webgpu (cpu)',
    },
    HELP,
  ],
  output: '{family, kernel, backend, count, valueError, gradientError, worst, pass}',
  linePer: 'family and kernel',
};

export const COMMANDS: readonly CommandSpec[] = [MESH, RENDER, INFO, FIELD];
