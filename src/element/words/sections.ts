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
    'off-sides': 'Start at one side of the form',
    'too-narrow': 'Zoom in: the form is too narrow here to draw across',
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
