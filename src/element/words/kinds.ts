/** What parts are called by what they are made of. */
import type { Part } from '../../document/document.ts';

export const SURFACE: Readonly<Record<Part['kind'], { readonly name: string; readonly long: string }>> = {
  tube: { name: 'Tube', long: 'Tube' },
  rotational: { name: 'Rotational', long: 'Rotational surface' },
  crossSection: { name: 'Section', long: 'Section surface' },
  bspline: { name: 'Patch', long: 'Patch' },
  body: { name: 'Body', long: 'Implicit body' },
  solid: { name: 'Solid', long: 'Soft solid' },
};
