/** The forms: one line each is the registry. */
import type { Form } from '../solid.ts';
import { curve } from './curve.ts';
import type { FormKind } from './form.ts';
import { line } from './line.ts';
import { plate } from './plate.ts';
import { point } from './point.ts';
import { ring } from './ring.ts';
import { soft } from './soft.ts';

export type { Figures, FormKind, Ink, Shaped, Sum } from './form.ts';

export const forms: Readonly<Record<Form, FormKind>> = {
  soft,
  plate,
  ring,
  line,
  curve,
  point,
};
