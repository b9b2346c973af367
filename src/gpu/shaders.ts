/** All of shaders/ as text, by name: `kernel/cauchy`. */
import type { Modules } from './link.ts';

const texts: Readonly<Record<string, string>> = import.meta.glob('../../shaders/**/*.wgsl', {
  query: '?raw',
  import: 'default',
  eager: true,
});

const PREFIX = '../../shaders/';
const SUFFIX = '.wgsl';

export const SHADERS: Modules = Object.fromEntries(
  Object.entries(texts).map(([path, text]) => [path.slice(PREFIX.length, -SUFFIX.length), text]),
);
