/** Words of what is in the hand. */
import { thousands } from './counts.ts';

export const PART_WORDS = {
  select: 'Select',
  parts: (count: number) => (count === 1 ? 'Parts, 1' : `Parts, ${count}`),
  list: 'Parts of the drawing',
  none: 'No parts yet. Draw a line and keep it.',
  choose: 'Tap a part in the drawing or in the list to select it.',
  strokes: (count: number) => (count === 1 ? '1 stroke' : `${count} strokes`),
  skels: (count: number) => (count === 0 ? 'shapes only' : count === 1 ? '1 skel' : `${count} skels`),
  triangles: (count: number) => `${thousands(count)} triangles`,
  /** in a list, after what the part is */
  flaw: { none: 'nothing to see', thin: 'thin', gaps: 'narrow gaps', cut: 'cut off' },
  hidden: 'hidden',
  hide: (name: string) => `Hide ${name}`,
  show: (name: string) => `Show ${name}`,
  several: (count: number) => `${count} parts`,
  name: 'Name',
  colour: 'Colour',
  colourOf: (name: string) => `Colour of ${name}`,
  mixed: 'Several',
  radius: 'Radius',
  handles: (name: string) => `Move ${name}`,
  handleHint: 'Drag, or press the arrow keys: 1 mm, with Shift 10 mm.',
  handle: {
    view: 'Move in the view plane',
    x: 'Move along X',
    y: 'Move along Y',
    z: 'Move along Z',
    surface: 'Slide over the surface',
    turn: 'Turn about the line of sight',
    turnX: 'Tip forward and back',
    turnY: 'Turn to the left and right',
    scale: 'Make it larger or smaller',
  },
  action: {
    hide: 'Hide',
    show: 'Show',
    focus: 'Focus',
    duplicate: 'Duplicate',
    remove: 'Delete',
  },
} as const;
