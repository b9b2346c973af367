/** Icons: lucide where it has one, ours for what only a sketch modeller has. 24 px grid, 1.75 px round line. */

import { html, svg, type TemplateResult } from 'lit';
import { unsafeSVG } from 'lit/directives/unsafe-svg.js';
import box from 'lucide-static/icons/box.svg?raw';
import check from 'lucide-static/icons/check.svg?raw';
import down from 'lucide-static/icons/chevron-down.svg?raw';
import next from 'lucide-static/icons/chevron-right.svg?raw';
import done from 'lucide-static/icons/circle-check.svg?raw';
import undone from 'lucide-static/icons/circle-dashed.svg?raw';
import help from 'lucide-static/icons/circle-question-mark.svg?raw';
import paste from 'lucide-static/icons/clipboard-paste.svg?raw';
import duplicate from 'lucide-static/icons/copy.svg?raw';
import more from 'lucide-static/icons/ellipsis.svg?raw';
import eye from 'lucide-static/icons/eye.svg?raw';
import eyeOff from 'lucide-static/icons/eye-off.svg?raw';
import fresh from 'lucide-static/icons/file-plus.svg?raw';
import focus from 'lucide-static/icons/focus.svg?raw';
import open from 'lucide-static/icons/folder.svg?raw';
import history from 'lucide-static/icons/history.svg?raw';
import image from 'lucide-static/icons/image.svg?raw';
import parts from 'lucide-static/icons/layers.svg?raw';
import drawings from 'lucide-static/icons/layout-grid.svg?raw';
import lock from 'lucide-static/icons/lock.svg?raw';
import full from 'lucide-static/icons/maximize.svg?raw';
import scale from 'lucide-static/icons/maximize-2.svg?raw';
import minus from 'lucide-static/icons/minus.svg?raw';
import select from 'lucide-static/icons/mouse-pointer-2.svg?raw';
import move from 'lucide-static/icons/move.svg?raw';
import draw from 'lucide-static/icons/pencil.svg?raw';
import plus from 'lucide-static/icons/plus.svg?raw';
import finger from 'lucide-static/icons/pointer.svg?raw';
import redo from 'lucide-static/icons/redo-2.svg?raw';
import home from 'lucide-static/icons/rotate-ccw.svg?raw';
import turn from 'lucide-static/icons/rotate-cw.svg?raw';
import save from 'lucide-static/icons/save.svg?raw';
import saveAs from 'lucide-static/icons/save-all.svg?raw';
import script from 'lucide-static/icons/scroll-text.svg?raw';
import share from 'lucide-static/icons/share.svg?raw';
import settings from 'lucide-static/icons/sliders-horizontal.svg?raw';
import trash from 'lucide-static/icons/trash-2.svg?raw';
import warn from 'lucide-static/icons/triangle-alert.svg?raw';
import undo from 'lucide-static/icons/undo-2.svg?raw';
import x from 'lucide-static/icons/x.svg?raw';

/** The inside of an svg file of the icon set. */
const inside = (text: string) => text.replace(/^[\s\S]*?<svg[^>]*>|<\/svg>\s*$/g, '');

const OURS = {
  skeleton:
    '<path d="M7.200 16.800L12 11.500l5.300-3.900M12 11.500l1.300 6.200"/><circle cx="6" cy="18" r="1.800"/><circle cx="12" cy="11.500" r="1.800"/><circle cx="18.600" cy="6.600" r="1.800"/><circle cx="13.700" cy="19.400" r="1.800"/>',
  component: '<circle cx="9.300" cy="10" r="4.300"/><circle cx="14.700" cy="14" r="4.300"/>',
  mirror: '<path d="M12 20v2M12 14v2M12 8v2M12 2v2"/><path d="M9 7L3 17h6z"/><path d="M15 7l6 10h-6z"/>',
  mirrorCopy:
    '<path d="M12 20v2M12 14v2M12 8v2M12 2v2"/><path d="M9 7L3 17h6z"/><path d="M15 7l6 10h-6z" style="fill:currentColor"/>',
  turnX:
    '<g transform="rotate(90 12 12)"><path d="M12 2.500v19" stroke-dasharray="2.200 2.600"/><path d="M9 9.600c-2.800.5-4.700 1.700-4.700 3.200 0 2.100 3.500 3.700 7.700 3.700s7.700-1.600 7.700-3.700c0-1.500-1.900-2.700-4.700-3.200"/><path d="M17.600 7.300L15 9.600l2.300 2.600"/></g>',
  turnY:
    '<path d="M12 2.500v19" stroke-dasharray="2.200 2.600"/><path d="M9 9.600c-2.800.5-4.700 1.700-4.700 3.200 0 2.100 3.500 3.700 7.700 3.700s7.700-1.600 7.700-3.700c0-1.500-1.900-2.700-4.700-3.200"/><path d="M17.600 7.300L15 9.600l2.300 2.600"/>',
  attach:
    '<circle cx="8" cy="14" r="4.800"/><circle cx="16.800" cy="7.800" r="3.300"/><path d="M11.800 11.200l2.200-1.500"/>',
  tube: '<path d="M4 20.2a3 3 0 0 1-.9-5.2C8.4 10 11 15.300 15.900 6.300"/><path d="M21 9c-5.900 10.400-10.600 5.600-15.700 10.700"/><ellipse cx="18.450" cy="7.650" rx="2.900" ry="1.700" transform="rotate(28 18.450 7.650)"/>',
  rotational:
    '<path d="M9.100 4.400c0 4.100-5 5.300-5 10.100C4.100 18.200 7.400 20.900 12 20.900s7.900-2.700 7.900-6.400c0-4.800-5-6-5-10.100"/><ellipse cx="12" cy="4.400" rx="2.900" ry="1.300"/><path d="M4.500 13c2.500 3 12.500 3 15 0"/>',
  crossSection:
    '<path d="M12 2.700C5.200 8.100 5.200 15.900 12 21.300 18.800 15.900 18.800 8.100 12 2.700z"/><path d="M6.900 11.600c1.800 3 8.400 3 10.200 0M6.900 11.600h10.200"/>',
  bspline:
    '<path d="M3.600 7.100c3.700-3.400 5.600 1.500 8.400 0s4.900-3.400 8.400-1.500v11.100c-3.500-1.900-5.600 0-8.400 1.700s-4.700-3.200-8.400 0z"/><path d="M3.600 12.700c3.700-3.400 5.600 1.600 8.400.1s4.900-3.400 8.400-1.500M9.100 7.400v9.600M15.400 5.600v11.100"/>',
  section:
    '<path d="M5.600 3.100C3.900 9 3.900 15 5.600 20.900M18.400 3.100c1.700 5.900 1.700 11.900 0 17.800"/><path d="M4.500 11.500c2.600 4.900 12.400 4.900 15 0"/><path d="M4.500 11.500c2.600-3.900 12.400-3.900 15 0" stroke-dasharray="2 2.6"/>',
  redraw:
    '<path d="M3.100 18.900c3.500 0 3.900-3.500 4.900-6.400M16 12.500c1 2.900 1.400 6.400 4.900 6.400"/><path d="M8 12.500c1.200-2.700 6.800-2.700 8 0" stroke-dasharray="2 2.6"/><path d="M8 12.500C7.500 2.200 16.500 2.200 16 12.500"/>',
  bend: '<path d="M7 20.900V14a8 8 0 0 1 8-8h4.900"/><path d="M16.600 2.600L20 6l-3.400 3.400"/><path d="M7 10V3.100" stroke-dasharray="2 2.6"/>',
  recreate:
    '<path d="M7.500 3.600L4.100 7l3.400 3.400"/><path d="M4.100 7h9.400a6 6 0 0 1 6 6"/><path d="M4.100 19.400c2.900-6.400 5.900 1.500 9.400-2.500s4.900 1 6.400 1.500"/>',
  backNone:
    '<path d="M4.100 9.100c2.500 8.400 13.300 8.400 15.800 0"/><path d="M4.100 9.100h15.800" stroke-dasharray="2 2.6"/>',
  backFront:
    '<path d="M4.100 12c2.500 7.400 13.300 7.400 15.800 0M4.100 12c2.500-7.400 13.300-7.400 15.800 0"/>',
  backDrawn:
    '<path d="M4.100 13c2.500 7.400 13.300 7.400 15.800 0"/><path d="M4.100 13c1.500-1 2-6.400 4.900-5.500s3.500 3.500 5.500 2.500 3.800-2.700 5.400 3"/>',
  body: '<path d="M7.500 4.100c3.700-1.700 6.200.9 6.300 3.500.1 1.900 1.300 2.500 3.200 2.900 3.600.8 5.200 4.100 3.700 7-1.600 3.100-5.600 3.600-8.900 2.600-4.400-1.300-8.100-3.500-8.500-8.600-.3-3.300 1.400-6.200 4.200-7.400z"/><path d="M7.200 9.100c.3-1.300 1.100-2.100 2.300-2.500"/>',
  solid:
    '<path d="M12.600 4.100c5.500-.5 8.300 2.900 8.300 7.500 0 5-3.500 8.400-8.500 8.400S3.100 17.500 3.100 12.600s4-8 9.500-8.500z"/><path d="M7.500 10.600c.7-1.700 2-2.600 3.700-2.900"/>',
  plate:
    '<path d="M3.100 11l8.900-4.900 8.900 4.900-8.900 4.900z"/><path d="M3.100 11v3.100l8.900 4.900 8.900-4.900V11"/>',
  ring: '<ellipse cx="12" cy="12" rx="8.900" ry="6.900"/><ellipse cx="12" cy="11.100" rx="3.800" ry="2.300"/>',
  carve:
    '<path d="M13.900 4.300C8 3.100 3.100 6.600 3.100 12.300c0 4.600 3.500 7.600 8.400 7.600 4 0 6.900-1.800 8.300-4.500"/><path d="M19.800 15.400c-5.900.5-8.400-5.400-5.900-11.100" stroke-dasharray="2 2.6"/>',
  line: '<path d="M4.500 17.500l5-9 4.500 6 5.500-8"/><circle cx="4.500" cy="17.500" r="1.600"/><circle cx="9.500" cy="8.500" r="1.600"/><circle cx="14" cy="14.500" r="1.600"/><circle cx="19.500" cy="6.500" r="1.600"/>',
  curve:
    '<path d="M4 18.500C8 3.500 14 21 20 5.500"/><path d="M4 18.500l4.500-12M20 5.500l-4.500 12" stroke-dasharray="2 2.6"/>',
  point: '<circle cx="12" cy="12" r="7.500"/><circle cx="12" cy="12" r="1.100"/>',
  blend: '<circle cx="9.100" cy="12" r="5.400"/><circle cx="14.900" cy="12" r="5.400"/>',
  group:
    '<path d="M4.100 8V5.600A1.500 1.500 0 0 1 5.600 4.100H8M16 4.100h2.400a1.500 1.500 0 0 1 1.500 1.500V8M19.900 16v2.400a1.500 1.500 0 0 1-1.500 1.500H16M8 19.900H5.600a1.500 1.500 0 0 1-1.500-1.500V16"/><circle cx="9.500" cy="10" r="2.600"/><circle cx="14.500" cy="14.400" r="2.600"/>',
  pressure: '<path d="M3 15.700c4.200-1.200 6.300-7.600 18-8.700-7.900 4.200-9.900 10.900-18 8.700z"/>',
} as const;

const LUCIDE = {
  duplicate,
  paste,
  turn,
  scale,
  next,
  eye,
  eyeOff,
  move,
  parts,
  select,
  box,
  check,
  done,
  down,
  draw,
  drawings,
  finger,
  focus,
  fresh,
  full,
  help,
  history,
  home,
  image,
  lock,
  more,
  open,
  minus,
  plus,
  redo,
  save,
  saveAs,
  script,
  settings,
  share,
  trash,
  undo,
  undone,
  warn,
  x,
} as const;

export type IconName = keyof typeof OURS | keyof typeof LUCIDE;

const BODY = new Map<string, string>([
  ...Object.entries(LUCIDE).map(([name, text]) => [name, inside(text)] as const),
  ...Object.entries(OURS),
]);

/** Decoration only: the control around it carries the name. The markup comes from files of ours, never from a person. */
export function icon(name: IconName, size: 20 | 24 = 24): TemplateResult {
  const body = svg`${unsafeSVG(BODY.get(name) ?? '')}`;
  return html`<svg class="icon ${size === 20 ? 'small' : ''}" viewBox="0 0 24 24" aria-hidden="true">${body}</svg>`;
}

/** The name, drawn with the same round pen as the icons. */
export const wordmark = html`<svg class="wordmark" viewBox="0 0 92 28" role="img" aria-label="rotund">
  <path
    d="M4 22v-10.500M4 15c.3-2.500 2.200-3.900 5-3.700M18.500 11.200a5.500 5.500 0 1 0 .01 0zM30.500 6.500v12c0 2.400 1.400 3.600 3.700 3.400M27.500 11.500h6.800M40.500 11.500v6c0 6 9 6 9 0v-6M49.500 11.500V22M57 22v-10.500M57 16c0-6.400 9-6.400 9 0v6M83 5v17M77.800 11.200a5.300 5.300 0 1 0 .01 0z"
  />
</svg>`;

/** A small lit ball in one of the styles, for the style switch. */
export function ball(style: 'toon' | 'hbed-lines' | 'hbed-ink' | 'gouraud', colour: string): TemplateResult {
  const shade = 'M4.600 17A9 9 0 0 0 18.500 5.800C20 13 12 19 4.600 17z';
  const dark = 'M7.700 20A9 9 0 0 0 20.600 9.300C20 16 13.500 20.300 7.700 20z';
  const rim = svg`<circle cx="12" cy="12" r="9" fill="none" stroke="currentColor" stroke-width="1.500"/>`;
  const bands = svg`<path d=${shade} fill="#000" opacity=".22"/><path d=${dark} fill="#000" opacity=".34"/>`;
  const inner = {
    toon: svg`<circle cx="12" cy="12" r="9" fill=${colour}/>${bands}${rim}`,
    'hbed-lines': svg`${rim}<path d="M17.300 8c1.500 4.500-1 8.300-5 10" fill="none" stroke="currentColor" stroke-width="1.500" stroke-linecap="round"/>`,
    'hbed-ink': svg`<circle cx="12" cy="12" r="9" fill="#fbf8f0"/>${bands}<path d="M12 3a9 9 0 1 0 0 18 9.300 9.300 0 0 0 0-18zm0 1.200a8 7.700 0 1 1-.3 15.300A7.800 7.600 0 0 1 12 4.200z" fill="#26211b"/>${rim}`,
    gouraud: svg`<circle cx="12" cy="12" r="9.500" fill=${colour}/><circle cx="12" cy="12" r="9.500" fill="url(#rotund-ball)"/>`,
  }[style];
  return html`<svg class="ball" viewBox="0 0 24 24" aria-hidden="true">
    <defs>
      <radialGradient id="rotund-ball" cx=".36" cy=".32" r=".75">
        <stop offset="0" stop-color="#fff" stop-opacity=".9" />
        <stop offset=".35" stop-color="#fff" stop-opacity="0" />
        <stop offset="1" stop-color="#000" stop-opacity=".6" />
      </radialGradient>
    </defs>
    ${inner}
  </svg>`;
}
