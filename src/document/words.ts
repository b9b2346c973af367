import type { Part } from './document.ts';
import type { Form } from './solid.ts';

/** What a kind of part, and what is in one, is called in names and messages. */
export const WORD: Readonly<Record<Part['kind'] | Form | 'component', string>> = {
  tube: 'Tube',
  rotational: 'Rotational',
  crossSection: 'Section',
  bspline: 'Patch',
  body: 'Body',
  solid: 'Solid',
  component: 'Component',
  soft: 'Soft',
  plate: 'Plate',
  ring: 'Ring',
  line: 'Line',
  curve: 'Curve',
  point: 'Point',
};
