/** What each number does, for its tooltip. */
import type { NumberKey } from './fieldState.ts';

const ORDINATE = 'Bézier ordinate of the weight along the line, in parts of the first';

export const HELP: Readonly<Record<NumberKey, string>> = {
  radius: 'Distance of the surface from the skeleton; radii of a preset keep their proportions',
  radiusEnd: 'Distance of the surface from the skeleton at its other end',
  weight: 'Factor of the kernel: the larger, the thicker the body',
  weight1: ORDINATE,
  weight2: ORDINATE,
  weight3: ORDINATE,
  s: 'How narrow the kernel is: the larger, the less pieces melt into each other',
  R: 'Where the kernel ends: beyond this distance a piece adds nothing',
  n: 'How fast the kernel falls off; 4 is the Cauchy kernel',
  T: 'The surface is where the field has this value; with radii it also says how steep the field is',
  carve: 'A point in front of the body takes away: 0 is off, further below is more',
  carveRadius: 'Radius that the point would have by itself, added',
  carveX: 'Where the point is, along x',
  carveY: 'Where the point is, along y',
  alpha: 'Of the cross section: 2 is round, more is squarer, 1 is a lozenge, less is a star',
  edge: 'How sharp the edges of the extrusion are',
  betaX: 'Scales the cross section along its x',
  betaY: 'Scales the cross section along its y',
  thickness: 'How far the body reaches from its middle, along y',
  a0: 'What is added where both meet: above 0 it bulges, below 0 it is cut in',
  a1: 'How far from the body the blend reaches, in values of its field',
  a2: 'How far from the shape the blend reaches, in values of its field',
  t: '0 is the body, 1 is the shape',
  example: 'Which of the examples of the shape',
  shapeSize: 'Scales the shape',
  shapeX: 'Moves the shape along x',
  shapeTurn: 'Turns the shape about z, after x',
  shapeTilt: 'Turns the shape about x',
  resolution: 'How fine the surface is: twice as many make four times the triangles',
};
