/** All words of the interface: plain verbs, no exclamation marks. */

import type { Part, Reading } from '../document/document.ts';
import { PAGE } from '../field/polygonize.ts';
import type { SurfaceKind } from '../surface/index.ts';

/** What parts are called by what they are made of. */
export const SURFACE: Readonly<Record<Part['kind'], { readonly name: string; readonly long: string }>> = {
  tube: { name: 'Tube', long: 'Tube' },
  rotational: { name: 'Rotational', long: 'Rotational surface' },
  crossSection: { name: 'Section', long: 'Section surface' },
  bspline: { name: 'Patch', long: 'Patch' },
  body: { name: 'Body', long: 'Implicit body' },
  solid: { name: 'Solid', long: 'Soft solid' },
};

const thousands = (count: number): string => String(count).replace(/\B(?=(\d{3})+$)/g, ',');

const seconds = (milliseconds: number): string =>
  milliseconds < 995
    ? `${Math.max(1, Math.round(milliseconds))} ms`
    : `${(milliseconds / 1000).toFixed(1)} s`;

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

export const NO_PICTURE = {
  title: 'There is no picture here',
  missing: 'This browser gives neither WebGPU nor WebGL2. Perhaps its graphics acceleration is switched off.',
  still:
    'Your strokes are kept and shown as ink. Files can still be opened, saved and exported; solids and styles show up in another browser.',
  why: (reason: string) => `The reason given: ${reason}`,
  open: 'Open a file',
  export: 'Export',
  retry: 'Try again',
} as const;

/** A byte count as people read it. */
const bytes = (size: number) =>
  size < 1e6 ? `${Math.max(1, Math.round(size / 1e3))} kB` : `${(size / 1e6).toFixed(1)} MB`;

/** Files: saved is in a file; kept is in the browser. */
export const FILE_WORDS = {
  untitled: 'Untitled',
  file: 'the file',
  gallery: 'Or open one',
  galleryMore: 'and look how it was drawn',
  tray: { none: '', saved: 'Saved', kept: 'Kept', saving: 'Saving', unsaved: 'Not saved' },
  opening: (name: string) => `Opening ${name}`,
  opened: (name: string, covers: boolean) =>
    `${name || 'Drawing'} opened${covers ? '. Undo brings back your drawing' : ''}`,
  notOpened: (name: string) => `${name} was not opened`,
  openAnother: 'Open another',
  tooLarge: (name: string) => `${name} is larger than 256 MiB; no drawing is.`,
  firstOf: (count: number, name: string) => `${name} opened, the first of ${count} files`,
  drop: 'Drop a drawing to open it',
  dropHint: 'Undo brings back what is here.',
  fresh: (covers: boolean) => (covers ? 'New drawing. Undo brings back the one before' : 'New drawing'),
  restored: (name: string) => (name ? `${name}, as you left it` : 'As you left it'),
  saved: (file: string) => `Saved as ${file}`,
  notSaved: 'Not saved',
  notWritten: (why: string) => `The file could not be written: ${why}`,
  nothingToSave: 'Nothing is drawn yet, so there is nothing to save',
  saveAs: 'Save as',
  saveCopy: 'Save a copy',
  saveIt: 'Save it as a file',
  full: 'Not saved: storage is full.',
  blocked: 'Not saved: this browser does not let the page keep drawings.',
  noWriters: 'What writes these files could not be fetched.',
  unreadable:
    'The drawing kept here could not be read. It was put aside as it is, and nothing writes over it.',
  elsewhere: 'Open in another tab. Only one of the two is kept.',
  takeOver: 'Take over',
  openCopy: 'Open a copy',
  copyOf: (name: string) => `${name || 'Drawing'} copy`,
  isCopy: 'This is a copy. Save it as a file to keep it',
  tookOver: 'This tab keeps the drawing now',
  picture: 'Picture',
  exporting: (what: string) => `Writing ${what}`,
  exported: (files: readonly { readonly name: string; readonly size: number }[]) =>
    `${files.map(({ name, size }) => `${name}, ${bytes(size)}`).join('; ')}`,
  waitingFor: (percent: number) => `Making bodies as fine as files have them, ${percent} %`,
  cancel: 'Cancel',
  notExported: (what: string) => `${what} was not written`,
  noForms: 'Nothing to export yet: keep a form first.',
  draftOut: 'The unfinished form is left out until you keep it.',
  hiddenOut: (count: number) =>
    count === 1 ? '1 hidden part is left out.' : `${count} hidden parts are left out.`,
  allHidden: 'All parts are hidden: show one first.',
  keptHere: 'Kept in this browser, on this device',
  keptBut: 'Browsers may clear what they keep. A file is yours.',
  keepsNothing: 'Not kept in this browser',
  keptElsewhere: 'Another tab is kept in this browser, not this one',
  keeping: 'Being kept in this browser',
  inFile: (file: string) => `Saved in ${file}`,
  changedSince: (file: string) => `Changed since it was saved in ${file}`,
  noFile: 'Not in a file yet',
} as const;

const placesOf = (places: number): string => (places === 1 ? '1 place' : `${places} places`);

/** What the picture does not show of a body, and what helps. */
export const FLAWS = {
  thin: (places: number) =>
    `Hardly thicker than a cell or two in ${placesOf(places)}: pieces may be missing. Thicker, or seen exactly, it is whole.`,
  gaps: (gaps: number) =>
    `Nearer to itself than a cell in ${placesOf(gaps)}: gaps may have closed. Wider, or seen exactly, they are open.`,
  cut: `Without end: cut off about ${PAGE} mm from the origin. An intersection with a box ends it where you like.`,
} as const;

/** Words of what is in the hand. */
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

/** Words of surfaces in their card. */
export const SURFACE_WORDS = {
  sections: 'Sections',
  sectionsOf: (name: string) => `Sections of ${name}`,
  at: (percent: number) => `at ${percent} %`,
  light: (at: string) => `Section ${at}: show it on the form`,
  removeSection: (at: string) => `Remove the section ${at}`,
  remove: (what: string) => `Remove ${what}`,
  draw: 'Draw one',
  between: 'Between sections',
  shortBetween: 'Between',
  betweens: {
    cubic: { name: 'Smooth', hint: 'Sections flow over into each other' },
    linear: { name: 'Straight', hint: 'Sections go over into each other in a straight line' },
    plain: { name: 'Plain', hint: 'Points joined as they are, without a spline' },
  },
  bends: 'Bends',
  bend: (number: number) => `Bend ${number}`,
  bendOn: (bend: string) => `Put ${bend} in force`,
  bendOff: (bend: string) => `Leave out ${bend}`,
  redrawBend: (bend: string) => `Draw ${bend} anew`,
  lengthKept: 'Length kept',
  lengthHint: 'The part keeps its length; else it reaches as far as what was drawn',
  detail: 'Detail',
  coarser: 'Coarser',
  finer: 'Finer',
  editDetail: 'Edit detail',
  autoRows: 'As many rows as it needs',
  autoRowsHint: 'Rows of the control mesh follow the outline; refining never moves the strokes',
  parts: {
    rows: { name: 'Rows', hint: 'Spans of the control mesh along the form' },
    columns: { name: 'Columns', hint: 'Spans of the control mesh across' },
    u: { name: 'Subdivisions along', hint: 'How often each span along the form is halved' },
    v: { name: 'Subdivisions across', hint: 'How often each span across is halved' },
  },
  mesh: 'Show control mesh',
  meshHint: 'The control mesh of patches, and strokes with their control points',
} as const;

/** Words of radii that are drawn. */
export const SIZE_WORDS = {
  draw: 'Draw it',
  hint: 'Draw a line of that length, or a circle of that radius',
  brush: (mm: number) => `${mm} mm: draw the radius`,
} as const;

/** Words of what surfaces do with light. */
export const FINISH_WORDS = {
  finish: 'Finish',
  finishOf: (name: string) => `Finish of ${name}`,
  next: 'this and the next form',
  finishes: { clay: 'Clay', matt: 'Matt', satin: 'Satin', gloss: 'Gloss', metal: 'Metal', glow: 'Glow' },
  own: 'Own',
  more: 'More light',
  name: { ambient: 'Ambient', diffuse: 'Diffuse', specular: 'Shine', shininess: 'Shininess' },
  hint: {
    ambient: 'Light from everywhere: more of it lifts the shade',
    diffuse: 'Light from the lamp: more of it sets lit and shaded sides apart',
    specular: 'Specular: how strong the highlight is',
    shininess: 'The larger, the smaller and sharper the highlight is',
  },
} as const;

export const STYLE_NAMES = {
  toon: 'Toon',
  'hbed-lines': 'Lines',
  'hbed-ink': 'Ink',
  gouraud: 'Shaded',
} as const;
export type ShownStyle = keyof typeof STYLE_NAMES;

/** The stroke meter. */
export const METER_WORDS = {
  label: 'The number of strokes decides the surface',
  everyStroke: 'every stroke',
  steps: {
    tube: { number: '1', name: 'Tube' },
    rotational: { number: '2', name: 'Rotational' },
    crossSection: { number: '3', name: 'Section' },
    bspline: { number: '4+', name: 'Patch' },
  },
  hint: (step: SurfaceKind, state: 'pinned' | 'done' | 'current' | 'next') => {
    if (state === 'pinned') return 'Every stroke a tube. Tap to let the number decide again';
    if (state === 'done')
      return step === 'tube'
        ? 'Back to tubes; no stroke is lost. Hold: every stroke a tube'
        : 'Back to this; no stroke is lost';
    return {
      tube: 'A tube along the stroke. Hold: every stroke a tube',
      rotational: state === 'next' ? 'Draw the other side to make it round' : 'Round between the two strokes',
      crossSection:
        state === 'next'
          ? 'Draw across, from one side to the other (L)'
          : 'The section that was drawn, all along',
      bspline: state === 'next' ? 'Draw a second section (L)' : 'From section to section',
    }[step];
  },
} as const;

/** A part whose strokes are in hand again. */
export const RECREATE_WORDS = {
  inHand: 'its strokes in hand',
  said: (name: string) => `${name}, its strokes in hand`,
  kept: (name: string) => `${name}, as it is drawn now`,
  dropped: (name: string) => `${name} is as it was`,
} as const;

/** Sections across a form. */
export const SECTION_WORDS = {
  tool: 'Section',
  title: 'Draw across',
  text: 'From one side to the other, where the dots are. Both ends snap.',
  across: 'Draw across – From one side to the other',
  at: (percent: number, side: 'front' | 'back') =>
    side === 'back' ? `Draw the back at ${percent} %` : `Draw a section at ${percent} %`,
  nowBack: (places: string) => `Now draw the back ${places}, the dashed side`,
  backText: (places: string) =>
    `Near the section ${places} a stroke is its back, the dashed side; elsewhere it is a new section.`,
  places: (percents: readonly number[]) => `at ${percents.map((percent) => `${percent} %`).join(' or ')}`,
  notAcross: {
    'no-sides': 'Draw a tube or two sides first, then across',
    'edge-on': 'The form’s drawing plane is seen from its edge.',
    'off-sides': 'Start at one of the two sides',
    bent: 'This form is bent: recreate it to draw across its strokes',
  },
  looks: [
    { name: 'Full', hint: 'solid side' },
    { name: 'Flat', hint: 'on the line' },
    { name: 'Hollow', hint: 'dashed side' },
  ],
  back: 'Back',
  backs: {
    none: { name: 'None', hint: 'Open: what was drawn is all there is' },
    front: { name: 'As front', hint: 'The front mirrored: a closed form' },
    drawn: { name: 'Drawn', hint: 'A section of its own, drawn next' },
  },
  onTube: (count: number) => (count === 1 ? 'Tube with a section' : 'Tube with sections'),
  sections: (count: number) => (count === 1 ? '1 section' : `${count} sections`),
  sectionAt: (percent: number) => `section at ${percent} %`,
} as const;

/** What the marks of tools say. */
export const MARK_WORDS = {
  label: { full: 'full', flat: 'flat', hollow: 'hollow', front: 'front', back: 'back' },
  value: (value: number, unit: '%' | '°' | 'mm') => {
    if (unit === 'mm') return `${Number(value.toFixed(1))} mm`;
    return unit === '°' ? `${Math.round(value)}°` : `${Math.round(value)} %`;
  },
} as const;

/** Words of what is drawn over forms that are there. */
export const EDIT_WORDS = {
  bend: 'Bend',
  bendKey: 'B',
  drawLine: 'Draw the new centre line',
  bent: (name: string) => `${name} bent`,
  which: 'Tap the part to bend',
  noneToBend: 'Nothing to bend yet: draw a form first',
  left: (tool: string) => `${tool} put away`,
  bendFact: (index: number) => `bend ${index + 1}`,
  recreate: 'Recreate',
  recreateHint: 'Back to its strokes: draw on, redraw, remove',
  strokes: 'Strokes',
  stroke: (n: number) => `Stroke ${n}`,
  removeStroke: (n: number, what: 'side' | 'front' | 'back' | 'redraw') =>
    `Remove stroke ${n}, ${{ side: 'a side', front: 'a section', back: 'a back', redraw: 'a redrawing' }[what]}`,
  overNothing: (numbers: readonly number[]) =>
    `Stroke ${numbers.join(', ')}: the part of the section it was drawn over is gone`,
  redraw: 'Redraw',
  redrawKey: 'O',
  redrawLit: { section: 'Redraw part of the lit section', side: 'Redraw part of the lit side' },
  redrawHover: 'Draw over a section or a side',
  reach: 'How far it reaches',
  whole: 'Whole form',
  wholeHint: 'The surface follows all along',
  here: 'Only here',
  hereHint: 'It fades to what was there',
  length: 'Length',
  kept: 'Length kept',
  keptHint: 'It stays as long as it was',
  stretched: 'Stretched',
  stretchedHint: 'It reaches as far as the stroke',
  said: {
    bend: 'Draw the new centre line',
    'bend-what': 'Only surfaces of strokes can be bent',
    'redraw-what': 'Start on a surface of strokes, or on one of its sides',
    'section-edge-on': 'Turn the view a little to redraw a section',
    'end-on': 'The axis is seen from its end. Turn the view a little',
  },
} as const;

/** Hot keys, for tooltips and the sheet. The thesis' own where it has one. */
export const KEYS: readonly { readonly keys: string; readonly does: string }[] = [
  { keys: 'D', does: 'Draw' },
  { keys: 'L', does: 'Section: draw across a form' },
  { keys: 'V', does: 'Select' },
  { keys: 'O', does: 'Redraw part of a section or a side' },
  { keys: 'B', does: 'Bend what is selected, or was made last' },
  { keys: 'N or Enter', does: 'Keep the form' },
  { keys: 'Esc', does: 'Cancel the stroke, drop the form, let go' },
  { keys: 'U or Ctrl Z', does: 'Undo' },
  { keys: 'Shift Z or Ctrl Shift Z', does: 'Redo' },
  { keys: 'Q, Shift Q', does: 'Thicker, thinner tube' },
  { keys: '1 2 3 4', does: 'Toon, lines, ink, shaded' },
  { keys: 'G', does: 'Grid' },
  { keys: 'P', does: 'Paper grain' },
  { keys: 'W', does: 'Wireframe' },
  { keys: 'X', does: 'Exact surface of bodies, or triangles' },
  { keys: 'M', does: 'Bounding volumes of skels' },
  { keys: 'F', does: 'Full screen' },
  { keys: 'Delete', does: 'Delete what is selected' },
  { keys: 'H', does: 'Hide or show what is selected' },
  { keys: 'K', does: 'Skeleton of the form that is selected' },
  { keys: 'Ctrl A', does: 'Select everything' },
  { keys: 'Ctrl D', does: 'Duplicate what is selected' },
  { keys: 'Shift M', does: 'Mirror what is selected' },
  { keys: 'Ctrl C, Ctrl X, Ctrl V', does: 'Copy, cut, paste what is selected' },
  { keys: 'C', does: 'Delete the last part' },
  { keys: 'E', does: 'Delete everything' },
  { keys: 'Arrows', does: 'Turn the view' },
  { keys: 'Home', does: 'Show everything' },
  { keys: '0', does: 'Reset the view' },
  { keys: 'Ctrl S', does: 'Save' },
  { keys: 'Ctrl Shift S', does: 'Save as another file' },
  { keys: 'Ctrl O', does: 'Open a file' },
  { keys: '?', does: 'This sheet' },
];

/** Words of solids in the list, in their card and at their handles. */
export const SOLID_WORDS = {
  form: { soft: 'Soft', plate: 'Plate', ring: 'Ring', line: 'Line', curve: 'Curve', point: 'Point' },
  selectedIn: (name: string, solid: string) => `${name} of ${solid} selected`,
  component: (groups: number) => (groups === 1 ? '1 form blends here' : `${groups} forms blend`),
  inside: (components: number, groups: number) =>
    components > 1 ? `${components} components` : groups === 1 ? '1 form' : `${groups} forms`,
  open: (name: string) => `Show what ${name} is made of`,
  closed: (name: string) => `Hide what ${name} is made of`,
  carves: 'carves',
  carving: 'Carves what it blends with',
  byHand: 'edited skeleton',
  dropOn: {
    blend: (name: string) => `Blend with ${name}`,
    attach: (name: string) => `Attach to ${name}`,
    own: 'On its own',
  },
  nowhere: 'Drop on a form, a component or a solid',
  what: 'What it becomes',
  radius: { plate: 'Half thickness', other: 'Radius' },
  weight: 'Weight',
  weightHint: 'How much it counts in the sum; below 0 it carves.',
  depth: 'Depth',
  depthHint: 'Thickness off the plane it was drawn on (β of y)',
  breadth: 'Breadth',
  breadthHint: 'Width within the plane it was drawn on (β of x)',
  section: 'Cross section',
  sections: { round: 'Round', superQuadric: 'Super-quadric', extrusion: 'Extrusion' },
  exponent: 'Corners',
  exponentHint: '1 is a rhombus, 2 round, above it nears a box (α)',
  kernel: 'Kernel',
  kernelHint: 'How the influence of a skel fades; of all that blend in a component',
  threshold: 'Threshold',
  thresholdHint: 'Where the surface lies: lower is thicker, and blends from further off (T)',
  join: 'Belongs to',
  joinHint: 'Forms of one component blend; components of a solid touch without blending.',
  joinNow: (component: string, solid: string) => (component ? `${component} of ${solid}` : solid),
  newComponent: (solid: string) => `Attached to ${solid}`,
  fit: (percent: string, atBound: number, ratio: string) =>
    `Off its outline by ${percent} % at most · ${atBound} % of weights at a bound · neighbours 1 : ${ratio}`,
  mirror: 'Mirror',
  mirrorCopy: 'Mirror copy',
  mirrorHint: (about: string | null) =>
    about === null
      ? 'Flips it where it is: nothing else is there, or it lies in the middle'
      : `To the other side of the middle of ${about}, as you look at it`,
  copy: 'Copy',
  paste: 'Paste',
  copied: (name: string) => `${name} copied`,
  cut: (name: string) => `${name} cut. Undo brings it back`,
  pasted: (name: string) => `${name} pasted`,
  noPaste: 'There is nothing of a drawing to paste',
  handle: { turn: 'Turn', scale: 'Scale' },
  turnHint: 'Drag around, with Shift in steps of 15°; arrow keys 1°, with Shift 10°.',
  tiltHint: 'Drag up and down, or to the sides, with Shift in steps of 15°; arrow keys 1°, with Shift 10°.',
  scaleHint: 'Drag outward, with Shift in steps of 10 %; arrow keys 1 %, with Shift 10 %.',
} as const;

/** What strokes become in a solid: short on chips; in full; and what it is good for. */
export const FORMS = {
  soft: { name: 'Soft', long: 'Soft solid', hint: 'A soft body that follows the outline' },
  plate: { name: 'Plate', long: 'Plate', hint: 'Flat between its two sides, as thick as the radius says' },
  ring: { name: 'Ring', long: 'Ring', hint: 'Around along the outline, open in the middle' },
  carve: { name: 'Carve', long: 'Carving', hint: 'Takes away from what it starts on' },
  tube: { name: 'Tube', long: 'Tube', hint: 'A tube with a surface of its own' },
  line: { name: 'Line', long: 'Line', hint: 'A soft line that blends with its neighbours' },
  curve: { name: 'Curve', long: 'Curve', hint: 'A soft curve of few control points' },
  point: { name: 'Point', long: 'Point', hint: 'A ball of the radius' },
} as const;
export type FormWord = keyof typeof FORMS;

/** How a solid goes with the one it starts on. */
export const JOINS = {
  blend: { name: 'Blend', hint: (of: string) => `Melts with ${of}` },
  attach: { name: 'Attach', hint: (of: string) => `Sits on ${of}, with a crease between them` },
  apart: { name: 'Apart', hint: () => 'A part of its own' },
} as const;
export type JoinWord = keyof typeof JOINS;

/** Words of silhouettes in the hand. */
export const SILHOUETTE_WORDS = {
  forms: 'What the strokes become',
  joins: (name: string) => `How it goes with ${name}`,
  joinsFact: {
    blend: (name: string) => `joins ${name}`,
    attach: (name: string) => `sits on ${name}`,
    carve: (name: string) => `from ${name}`,
  },
  holes: (count: number) => (count === 1 ? '1 hole' : `${count} holes`),
  radius: (mm: number) => `${mm} mm radius`,
  thick: (mm: number) => `${mm} mm thick`,
  preview: (long: string) => `${long}, preview`,
  previewOf: {
    joins: (long: string, joined: string) => `${long}, preview. Joins ${joined}`,
    sitsOn: (long: string, joined: string) => `${long}, preview. Sits on ${joined}`,
  },
  carving: (joined: string) => `Carving, preview. Takes away from ${joined}`,
  added: (long: string, joined: string) => `${long} added to ${joined}`,
  carved: (joined: string) => `${joined} carved`,
  meter: 'Closed outline, or a tube',
  closed: 'Closed outline',
  open: 'Leave it open: tube',
  shortOpen: 'Open: tube',
  crosses: 'The outline crosses itself.',
  redraw: 'Redraw',
  join: 'Join the parts',
  nothing: 'nothing to fill',
  asTube: 'Tube',
} as const;

/** Words of skeletons in the hand, and of profiles. */
export const SKELETON_WORDS = {
  show: 'Skeleton',
  of: (name: string) => `Skeleton of ${name}`,
  shown: (name: string, nodes: number) => `Skeleton of ${name}, ${nodes === 1 ? '1 node' : `${nodes} nodes`}`,
  hidden: 'Skeleton hidden',
  none: 'Select one form of a solid to see its skeleton',
  node: (node: number, of: number, radius: number) =>
    `Node ${node} of ${of}, radius ${Math.round(10 * radius) / 10} mm`,
  hint: 'Arrow keys move it 1 mm, with Shift 10 mm; plus and minus change its radius; Page Up and Page Down go to the next; Enter splits a link; Delete removes it.',
  add: 'Add a node: drag to where it goes',
  remove: 'Delete the node',
  chooseNode: 'Choose a node to delete it; Escape leaves the skeleton',
  asDrawn: 'As the strokes say',
  profile: 'Profile',
  profileOf: (name: string) => `Profile of ${name}`,
  profilePoint: (point: number, of: number) => `Thickness at ${point} of ${of}`,
  profileEven: 'Even',
  profileByHand: 'The skeleton was edited: its own radii count.',
} as const;
