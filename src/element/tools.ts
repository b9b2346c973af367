/** The tools by their names, each as the state it waits in. */
import { choosing } from '../tool/bend.ts';
import { idle } from '../tool/draw.ts';
import { redrawing } from '../tool/redraw.ts';
import { sectioning } from '../tool/section.ts';
import { selecting } from '../tool/select.ts';

export const TOOLS = {
  draw: idle,
  section: sectioning,
  redraw: redrawing(false),
  bend: choosing,
  select: selecting,
} as const;

export type ToolName = keyof typeof TOOLS;
