/** All words of the interface: plain verbs, no exclamation marks. */
import type { SurfaceKind } from '../surface/index.ts';

export const SURFACE: Readonly<Record<SurfaceKind, { readonly name: string; readonly long: string }>> = {
  tube: { name: 'Tube', long: 'Tube' },
  rotational: { name: 'Rotational', long: 'Rotational surface' },
};

export const WORDS = {
  title: 'Draw a line, get a form.',
  subtitle: 'Start anywhere, also right here. The hint steps aside.',
  steps: [
    { title: 'Draw one side', text: 'One stroke is a tube.' },
    { title: 'Draw the other side', text: 'Two make it round.' },
    { title: 'Keep it, and go on', text: 'The next stroke may start on the form.' },
  ],
  ready: 'Ready to draw',
  loading: 'Preparing the picture',
  preview: (kind: SurfaceKind) => `${SURFACE[kind].long}, preview`,
  kept: (kind: SurfaceKind, parts: number) => `${SURFACE[kind].long} added, part ${parts}`,
  dropped: 'Dropped. Undo brings it back',
  undone: (what: string) => `Undone: ${what}`,
  redone: (what: string) => `Redone: ${what}`,
  nothingToUndo: 'Nothing to undo',
  nothingToRedo: 'Nothing to redo',
  deleted: (names: readonly string[]) =>
    names.length === 1
      ? `${names[0]} deleted. Undo brings it back`
      : `${names.length} parts deleted. Undo brings them back`,
  opened: (name: string) => (name ? `${name} opened` : 'Opened'),
  selected: (names: readonly string[], of: number) =>
    names.length === 0
      ? 'Nothing selected'
      : names.length === 1
        ? `${names[0]} selected, 1 of ${of}`
        : `${names.length} parts selected`,
  nothingToDelete: 'Nothing to delete',
  changed: (what: string) => `Changed: ${what}`,
  radius: (mm: number) => `Tube radius ${mm} mm`,
  style: (name: string) => `Style: ${name.toLowerCase()}`,
  tooShort: 'A dot is too short for a tube. Draw a longer line.',
  edgeOn: 'The form’s drawing plane is seen from its edge.',
  turnBack: 'Turn back',
  noSurface: 'These strokes are too short for a surface.',
  failed: 'This surface could not be built. The strokes are safe.',
  penFound: 'Pen found. Fingers now turn the view.',
  letFingersDraw: 'Let fingers draw',
  webgl2: 'Drawing with WebGL2. Everything works, large solids take longer.',
  lost: 'The graphics device was lost. Your drawing is safe; the picture comes back.',
  noPicture: 'This browser shows neither WebGPU nor WebGL2, so there is no picture. Your strokes are kept.',
} as const;

export const STYLE_NAMES = {
  toon: 'Toon',
  'hbed-lines': 'Lines',
  'hbed-ink': 'Ink',
  gouraud: 'Shaded',
} as const;
export type ShownStyle = keyof typeof STYLE_NAMES;

/** Hot keys, for tooltips and the sheet. The thesis' own where it has one. */
export const KEYS: readonly { readonly keys: string; readonly does: string }[] = [
  { keys: 'D', does: 'Draw' },
  { keys: 'N or Enter', does: 'Keep the form' },
  { keys: 'Esc', does: 'Cancel the stroke, drop the form' },
  { keys: 'U or Ctrl Z', does: 'Undo' },
  { keys: 'Shift Z or Ctrl Shift Z', does: 'Redo' },
  { keys: 'Q, Shift Q', does: 'Thicker, thinner tube' },
  { keys: '1 2 3 4', does: 'Toon, lines, ink, shaded' },
  { keys: 'G', does: 'Grid' },
  { keys: 'P', does: 'Paper grain' },
  { keys: 'W', does: 'Wireframe' },
  { keys: 'F', does: 'Full screen' },
  { keys: 'C', does: 'Delete the last part' },
  { keys: 'E', does: 'Delete everything' },
  { keys: 'Arrows', does: 'Turn the view' },
  { keys: 'Home', does: 'Show everything' },
  { keys: '0', does: 'Reset the view' },
  { keys: '?', does: 'This sheet' },
];
