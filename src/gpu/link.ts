/**
 * WGSL is files that meet a contract; this joins them. One directive, `#import name` on a line of its own: the named
 * module stands before the importer, once. Nothing else is done to the text, so that a line of the result is a line of
 * a file and compiler messages can name it (after vello's and fidget's loaders).
 */

/** WGSL by name: `kernel/cauchy` is shaders/kernel/cauchy.wgsl, or text that was generated under that name. */
export type Modules = Readonly<Record<string, string>>;

export interface Linked {
  readonly code: string;
  /** `kernel/cauchy.wgsl:12` for a line of `code`, counted from 1 */
  locate(line: number): string;
}

const IMPORT = /^\s*#import\s+(\S+)\s*$/;

/** Joins `entry` and all that it imports. Throws for a name that is not there and for a circle, naming the importers. */
export function link(modules: Modules, entry: string): Linked {
  const lines: string[] = [];
  const places: string[] = [];
  const done = new Set<string>();
  const visit = (name: string, trail: readonly string[]): void => {
    if (done.has(name)) return;
    const path = [...trail, name];
    if (trail.includes(name)) throw new Error(`WGSL imports run in a circle: ${path.join(' → ')}`);
    const text = modules[name];
    if (text === undefined) throw new Error(missing(name, trail));
    const own = text.split('\n');
    for (const line of own) {
      const imported = IMPORT.exec(line)?.[1];
      if (imported) visit(imported, path);
    }
    done.add(name);
    own.forEach((line, i) => {
      if (IMPORT.test(line)) return;
      lines.push(line);
      places.push(`${name}.wgsl:${i + 1}`);
    });
  };
  visit(entry, []);
  return { code: lines.join('\n'), locate: (line) => places[line - 1] ?? `${entry}.wgsl` };
}

function missing(name: string, trail: readonly string[]): string {
  const importer = trail.at(-1);
  return importer
    ? `${importer}.wgsl imports ${name}, which does not exist`
    : `there is no WGSL module ${name}`;
}

/** What a compiler says of a shader, with the file and line it means. */
export class ShaderError extends Error {
  override readonly name = 'ShaderError';
}

/** Compiles; throws a ShaderError with one line a mistake: `kernel/cauchy.wgsl:12: unresolved value`. */
export async function compile(device: GPUDevice, label: string, linked: Linked): Promise<GPUShaderModule> {
  device.pushErrorScope('validation');
  const module = device.createShaderModule({ label, code: linked.code });
  const [{ messages }, refused] = await Promise.all([module.getCompilationInfo(), device.popErrorScope()]);
  const mistakes = messages.filter(({ type }) => type === 'error');
  if (mistakes.length > 0) {
    const told = mistakes.map(({ lineNum, message }) => `${linked.locate(lineNum)}: ${message}`);
    throw new ShaderError(told.join('\n'));
  }
  if (refused) throw new ShaderError(`${label}: ${refused.message}`);
  return module;
}
