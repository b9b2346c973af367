/** The empty page: three steps, drawn with the program's own pear; it lets the pen through. */
import { html, svg, type TemplateResult } from 'lit';
import { WORDS } from './words.ts';

/** Left outline of the pear in a 160 × 200 square; the right one is its mirror image. */
const LEFT = 'M80 22C66 22 60 34 58 50C55 76 46 88 36 106C22 132 22 168 44 180C56 186 68 187 80 187';
const RIGHT =
  'M80 22C94 22 100 34 102 50C105 76 114 88 124 106C138 132 138 168 116 180C104 186 92 187 80 187';
const STEM = 'M80 25C78 14 82 6 92 0L99 5C92 10 89 16 89 25Z';

const outline = (d: string, width = 3) =>
  svg`<path d=${d} fill="none" stroke="var(--ink)" stroke-width=${width} stroke-linecap="round" stroke-linejoin="round"/>`;

const body = svg`<defs><clipPath id="rotund-pear"><path d="${LEFT}Z${RIGHT}Z"/></clipPath></defs>
  <g clip-path="url(#rotund-pear)">
    <rect width="160" height="200" fill="#b6ab41"/>
    <path d="M0 0H84C76 30 82 52 84 70C88 92 110 106 108 134C106 166 70 176 40 168L0 150Z" fill="#dbcd4c"/>
    <path d="M160 200V40H99C100 70 118 92 127 118C134 142 122 172 80 178C60 181 46 178 36 172L40 200Z" fill="#736c2c"/>
    <ellipse cx="62" cy="120" rx="5" ry="9" transform="rotate(20 62 120)" fill="#f6f2cf"/>
    <ellipse cx="70" cy="62" rx="2.500" ry="7" fill="#f6f2cf"/>
  </g>`;

const pencil = svg`<g transform="translate(80 187)"><path d="M0 0l4-13 28-27 9 9-28 27z" fill="var(--surface)" stroke="var(--ink)" stroke-width="2.500" stroke-linejoin="round"/><path d="M0 0l2-6 4 4z" fill="var(--ink)"/></g>`;

const FIGURES = [
  svg`${outline(LEFT)}${pencil}`,
  svg`${body}${outline(LEFT)}${outline(RIGHT)}`,
  svg`${body}${outline(LEFT, 2.5)}${outline(RIGHT, 2.5)}<path d=${STEM} fill="#7d5238" stroke="var(--ink)" stroke-width="2.500" stroke-linejoin="round"/>`,
];

export const hint = (): TemplateResult => html`<section class="hint">
  <h2>${WORDS.title}</h2>
  <p>${WORDS.subtitle}</p>
  <ol>
    ${WORDS.steps.map(
      ({ title, text }, i) =>
        html`<li><svg viewBox="0 -6 160 208" aria-hidden="true">${FIGURES[i]}</svg><b>${title}</b><span>${text}</span></li>`,
    )}
  </ol>
</section>`;
