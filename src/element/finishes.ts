/** The finishes to choose from, as lit spheres in the part's own colour (thesis fig. A.8), drawn by the numbers of the scene's light. */
import { html, svg, type TemplateResult } from 'lit';
import { DEFAULT_FINISH, type Finish, sameFinish } from '../document/finish.ts';
import type { Style } from '../document/look.ts';
import { displayBytes } from '../document/paint.ts';
import { AMBIENT_LIGHT, finishVectors, LAMP_LIGHT } from '../scene/finish.ts';
import { FINISH_WORDS } from './words.ts';

const { finishes } = FINISH_WORDS;

export const FINISHES: readonly (readonly [name: string, finish: Finish])[] = [
  [finishes.clay, DEFAULT_FINISH],
  [finishes.matt, { ambient: 1, diffuse: 1, specular: 0, shininess: 40 }],
  [finishes.satin, { ambient: 1, diffuse: 1, specular: 0.25, shininess: 10 }],
  [finishes.gloss, { ambient: 0.95, diffuse: 1.05, specular: 0.85, shininess: 80 }],
  [finishes.metal, { ambient: 0.55, diffuse: 1.25, specular: 1, shininess: 14 }],
  [finishes.glow, { ambient: 1.8, diffuse: 0.25, specular: 0, shininess: 40 }],
];

/** "Satin", or that it is an own one when it is none of them. */
export const finishName = (finish: Finish): string =>
  FINISHES.find(([, other]) => sameFinish(other, finish))?.[0] ?? FINISH_WORDS.own;

/** toon's bands, and the N·L below which each of them is seen (scene/toon.ts) */
const BANDS = [
  { band: 0.5, below: 0.7 },
  { band: 0.3, below: 0.2 },
  { band: 0.1, below: 0.1 },
] as const;
const LIT = 0.7;
const RADIUS = 9;
const MIDDLE = 12;

/** Display values of a colour in this much of the lamp's light, 0–1. */
function lit(colour: string, { ambient, diffuse }: Finish, lamp: number): string {
  const rgb = displayBytes(colour).map((value, k) =>
    Math.min(255, Math.round(value * (AMBIENT_LIGHT[k]! * ambient + LAMP_LIGHT[k]! * diffuse * lamp))),
  );
  return `rgb(${rgb.join(' ')})`;
}

export function finishBall(finish: Finish, colour: string, style: Style): TemplateResult {
  const isSmooth = style === 'gouraud' || style === 'phong';
  return html`<svg class="ball" viewBox="0 0 24 24" aria-hidden="true">
    ${isSmooth ? smooth(finish, colour) : banded(finish, colour)} ${highlight(finish, isSmooth)}
    <circle cx=${MIDDLE} cy=${MIDDLE} r=${RADIUS} fill="none" stroke="currentColor" stroke-width="1.25" />
  </svg>`;
}

function banded(finish: Finish, colour: string) {
  return svg`<circle cx=${MIDDLE} cy=${MIDDLE} r=${RADIUS} fill=${lit(colour, finish, LIT)} />
    ${BANDS.map(({ band, below }) => svg`<path d=${shade(below)} fill=${lit(colour, finish, band)} />`)}`;
}

/** of the light's direction, on the screen and towards the viewer */
const [ACROSS, NEAR] = [Math.sqrt(2 / 3), Math.sqrt(1 / 3)];
const STEPS = 24;

/** Where N·L is less than c: N·L = c is a circle about the light, of which the half that is seen goes from rim to rim. */
function shade(c: number): string {
  const rho = Math.sqrt(1 - c * c);
  const end = Math.acos(-(NEAR * c) / (ACROSS * rho));
  const points = Array.from({ length: STEPS + 1 }, (_, i) => {
    const phi = end * ((2 * i) / STEPS - 1);
    // away from the light, and across that
    const [s, t] = [NEAR * rho * Math.cos(phi) - ACROSS * c, rho * Math.sin(phi)];
    const place = [s - t, s + t].map((k) => (MIDDLE + RADIUS * Math.SQRT1_2 * k).toFixed(2));
    return place.join(' ');
  });
  return `M${points.join('L')}A${RADIUS} ${RADIUS} 0 1 0 ${points[0]}z`;
}

const STOPS = [0, 0.25, 0.5, 0.75, 1];

function smooth(finish: Finish, colour: string) {
  const id = `rotund-finish-${finishName(finish).toLowerCase()}`;
  return svg`<defs><radialGradient id=${id} cx=".3" cy=".3" r=".85">
      ${STOPS.map((t) => svg`<stop offset=${t} stop-color=${lit(colour, finish, 0.75 * Math.max(0, Math.cos(1.75 * t)))} />`)}
    </radialGradient></defs>
    <circle cx=${MIDDLE} cy=${MIDDLE} r=${RADIUS} fill="url(#${id})" />`;
}

/** sines of the halfway vector's angles: where the highlight lies on the ball */
const HALFWAY = 0.325;

function highlight(finish: Finish, isSmooth: boolean) {
  const { light, peak } = finishVectors(finish);
  const [, , white, gleam] = light;
  const radius = RADIUS * Math.sqrt(1 - peak[1] ** 2);
  const at = MIDDLE - RADIUS * HALFWAY;
  const opacity = isSmooth ? Math.min(1, 1.6 * gleam) : white;
  return svg`<circle cx=${at} cy=${at} r=${Math.max(0.7, isSmooth ? 1.3 * radius : radius)} fill="#fff" opacity=${opacity} />`;
}
