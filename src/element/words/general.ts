/** Words of the status line, of notices and of the picture. */
import type { Reading } from '../../document/document.ts';
import { seconds, thousands } from './counts.ts';
import { SURFACE } from './kinds.ts';

export const WORDS = {
  title: 'Draw a line, get a form.',
  subtitle: 'Start anywhere, also right here. The hint steps aside.',
  steps: [
    { title: 'Draw one side', text: 'One stroke is a tube. A closed one swells.' },
    { title: 'Draw the other side', text: 'Two make it round.' },
    { title: 'Keep it, and go on', text: 'The next stroke may start on the form.' },
  ],
  ready: 'Ready to draw',
  loading: 'Preparing the picture',
  preview: (kind: Reading) => `${SURFACE[kind].long}, preview`,
  kept: (long: string, parts: number) => `${long} added, part ${parts}`,
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
  /** said of commands whose own words are a sentence: "Stem hidden" */
  named: (name: string) => `Renamed to ${name}`,
  changed: (what: string) => `Changed: ${what}`,
  radius: (mm: number) => `Tube radius ${mm} mm`,
  mode: { mesh: 'Bodies as triangles', exact: 'The exact surface of bodies' },
  exactSurface: 'Exact surface',
  exactHint: 'Bodies by a ray a pixel where all rests; triangles while anything moves (X)',
  volumes: 'Bounding volumes',
  volumesHint: 'Around each skel all that it can be inside of, after Zhu et al. (M)',
  volumesSaid: (on: boolean) => (on ? 'Bounding volumes of the skels' : 'No bounding volumes'),
  noBodies: 'There is no implicit body in this drawing: all of it is triangles anyway.',
  /** at once, before anything of it is seen */
  onItsWay: 'The exact surface of bodies is on its way',
  casting: (percent: number) => `exact on its way · ${percent} %`,
  mesh: (triangles: number) => `mesh · ${thousands(triangles)} triangles`,
  exact: (evaluations: number, milliseconds: number) =>
    `exact · ${evaluations < 10 ? evaluations.toFixed(1) : Math.round(evaluations)} evaluations per pixel · ${seconds(milliseconds)}`,
  raysRefused: (why: string) => `Processors or triangles stand in for rays: ${why}`,
  inPart: (exact: string) => `${exact} · some rows triangles`,
  rowsLost: 'Some rows of the picture could not be cast: bodies are triangles there',
  picturePart: 'There is no exact picture: some rows could not be cast',
  notExact: 'no rays here, triangles',
  noExact: (why: string) => `There is no exact surface here, bodies stay triangles: ${why}`,
  style: (name: string) => `Style: ${name.toLowerCase()}`,
  tooShort: 'A dot is too short for a tube. Draw a longer line.',
  orPoint: 'A dot is too short for a tube. Make it a point?',
  point: 'Point',
  edgeOn: 'The form’s drawing plane is seen from its edge.',
  turnBack: 'Turn back',
  turn: 'Turn the view',
  /** what an unfinished form is that no part can be made of */
  encloses: 'encloses nothing',
  tooShortForTube: 'too short',
  notBuilt: 'could not be built',
  twoTubes: 'Two tubes',
  undoStroke: 'Undo',
  full: 'This drawing is full: a file holds no more strokes. Save it, and go on in a new one.',
  cannotKeep: 'There is nothing to keep yet. Draw it again, or drop it.',
  making: (name: string, percent: number) => `Making ${name}, ${percent} %`,
  noSurface:
    'Its field is nowhere above 0, or only where it is too thin to be seen. A lower threshold or larger radii help.',
  tooThin: 'All of it is thinner than the cells that it is made in. Larger radii help.',
  flawed: (name: string, words: string, more: number) =>
    `${name}: ${words.charAt(0).toLowerCase()}${words.slice(1)}${more > 0 ? ` And ${more === 1 ? 'another part' : `${more} other parts`}: see Parts.` : ''}`,
  notMade: (name: string, why: string) => `${name} could not be made: ${why}`,
  failed: 'This surface could not be built. The strokes are safe.',
  penFound: 'Pen found. Fingers now turn the view.',
  letFingersDraw: 'Let fingers draw',
  webgl2: 'Drawing with WebGL2. Everything works, large solids take longer.',
  lost: 'The graphics device was lost. Your drawing is safe; the picture comes back.',
  tryAgain: 'Try again',
  noPicture: 'No picture',
  drawnBy: (backend: string, about: string | null) => (about ? `${backend}: ${about}` : backend),
} as const;
