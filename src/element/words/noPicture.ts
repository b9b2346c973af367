/** Words in place of a picture. */

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
