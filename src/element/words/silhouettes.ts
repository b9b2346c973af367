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
} as const;
