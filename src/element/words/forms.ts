/** What strokes become in a solid, and how it goes with the one it starts on. */

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
