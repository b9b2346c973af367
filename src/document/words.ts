import type { SurfaceKind } from '../surface/index.ts';

/** What a surface is called in names and messages. */
export const WORD: Readonly<Record<SurfaceKind, string>> = { tube: 'Tube', rotational: 'Rotational' };
