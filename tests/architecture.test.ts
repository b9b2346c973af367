/** The house: a folder imports only from those above it; each outside world has one door. */
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { describe, expect, it } from 'vitest';

const SRC = resolve(import.meta.dirname, '../src');

/** Top to bottom. */
const HOUSE = [
  'math',
  'mesh',
  'stroke',
  'surface',
  'kernel',
  'skeleton',
  'shape',
  'field',
  'document',
  'export',
  'tool',
  'gpu',
  'scene',
  'element',
  'worker',
  'cli',
];
const PURE = HOUSE.slice(0, HOUSE.indexOf('gpu'));

/** Which folders may name a package. */
const DOORS: readonly { readonly what: RegExp; readonly folders: readonly string[] }[] = [
  { what: /^three|^camera-controls/, folders: ['scene'] },
  { what: /^lit|^lucide/, folders: ['element'] },
  { what: /^node:|^playwright|^webgpu$/, folders: ['cli'] },
  { what: /^gl-matrix|^delaunator|^@kninnug|^earcut/, folders: ['math'] },
  { what: /^@gltf-transform/, folders: ['export'] },
];

/** Names that pure code must not use: the DOM's, the GPU's, and functions whose last bit differs between engines. */
const OUTSIDE = /\b(window|navigator|HTMLElement|requestAnimationFrame|GPUDevice|localStorage|performance)\b/;
const ENGINE_MATH =
  /\bMath\.(sin|cos|tan|asin|acos|atan|atan2|exp|expm1|log|log1p|log2|log10|pow|cbrt|sinh|cosh|tanh|hypot)\b|\*\*/;

interface Source {
  readonly path: string;
  readonly folder: string;
  readonly code: string;
  readonly imports: readonly string[];
}

function sources(): Source[] {
  const paths = readdirSync(SRC, { recursive: true, encoding: 'utf8' }).filter((path) =>
    path.endsWith('.ts'),
  );
  return paths.map((path) => {
    const code = readFileSync(join(SRC, path), 'utf8').replace(/\/\*[\s\S]*?\*\/|\/\/.*$/gm, '');
    const imports = [...code.matchAll(/(?:from|import)\s*\(?\s*'([^']+)'/g)].map(([, name]) => name!);
    return { path, folder: path.includes('/') ? path.split('/')[0]! : '', code, imports };
  });
}

const all = sources();
const pure = all.filter(({ folder }) => PURE.includes(folder));

describe('architecture', () => {
  it('has only the folders of the house', () => {
    const folders = new Set(all.map(({ folder }) => folder).filter(Boolean));
    expect([...folders].filter((folder) => !HOUSE.includes(folder))).toEqual([]);
  });

  it('imports only upwards', () => {
    const wrong = all.flatMap(({ path, folder, imports }) =>
      imports
        .filter((name) => {
          if (!name.startsWith('.') || name.includes('shaders/') || folder === '') return false;
          const to = relative(SRC, resolve(SRC, dirname(path), name)).split('/')[0]!;
          return HOUSE.indexOf(to) > HOUSE.indexOf(folder) || HOUSE.indexOf(to) < 0;
        })
        .map((name) => `${path} → ${name}`),
    );
    expect(wrong).toEqual([]);
  });

  it('lets each package in by one door', () => {
    const wrong = all.flatMap(({ path, folder, imports }) =>
      imports
        .filter((name) => DOORS.some(({ what, folders }) => what.test(name) && !folders.includes(folder)))
        .map((name) => `${path} → ${name}`),
    );
    expect(wrong).toEqual([]);
  });

  it('keeps DOM and GPU out of the pure code', () => {
    expect(pure.filter(({ code }) => OUTSIDE.test(code)).map(({ path }) => path)).toEqual([]);
  });

  it('keeps the engine’s own trigonometry out of the pure code', () => {
    expect(pure.filter(({ code }) => ENGINE_MATH.test(code)).map(({ path }) => path)).toEqual([]);
  });

  it('has no cycle between files', () => {
    const edges = new Map(
      all.map(({ path, imports, code }) => [
        path,
        imports
          .filter(
            (name) =>
              name.startsWith('.') &&
              !new RegExp(`import type [^;]*'${name.replace(/[.]/g, '\\.')}'`).test(code),
          )
          .map((name) => relative(SRC, resolve(SRC, dirname(path), name))),
      ]),
    );
    const done = new Set<string>();
    const cycle = (path: string, trail: readonly string[]): readonly string[] | null => {
      if (trail.includes(path)) return [...trail.slice(trail.indexOf(path)), path];
      if (done.has(path)) return null;
      for (const next of edges.get(path) ?? []) {
        const found = cycle(next, [...trail, path]);
        if (found) return found;
      }
      done.add(path);
      return null;
    };
    expect([...edges.keys()].map((path) => cycle(path, [])).filter(Boolean)).toEqual([]);
  });
});
