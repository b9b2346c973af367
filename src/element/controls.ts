/** The floating controls around the drawing, as templates: what they show comes from the session, what they do goes to `Actions`. */
import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { isSurface, RADIUS_RANGE } from '../document/document.ts';
import { redoable, undoable } from '../document/history.ts';
import { startBend } from './bending.ts';
import type { Files } from './files.ts';
import { ball, type IconName, icon, wordmark } from './icons.ts';
import type { Place } from './place.ts';
import { drawRadius } from './radiusDrawing.ts';
import { startRedraw } from './redraws.ts';
import type { Session } from './session.ts';
import { EDIT_WORDS, PART_WORDS, SECTION_WORDS, type ShownStyle, SIZE_WORDS, STYLE_NAMES } from './words.ts';

export type PanelName = 'settings' | 'menu' | 'palette' | 'help' | 'drawings' | 'file' | 'export' | 'parts';

/** What the controls ask of the element. */
export interface Actions {
  readonly open: PanelName | null;
  readonly fingersDraw: boolean;
  /** looking only: nothing that edits is shown */
  readonly readOnly: boolean;
  readonly files: Files;
  /** null while there is no chip */
  readonly chipAt: Place | null;
  toggle(panel: PanelName): void;
  setFingersDraw(on: boolean): void;
  setRadius(mm: number, done: boolean): void;
  dismiss(): void;
}

interface ButtonOptions {
  readonly key?: string;
  readonly off?: boolean;
  readonly pressed?: boolean;
  readonly expanded?: boolean;
  readonly class?: string;
  readonly body?: TemplateResult;
  readonly shortcut?: string;
  /** more than its name says */
  readonly hint?: string;
}

/** An icon with a name and, after a moment of hovering, a tooltip with the key. */
export function iconButton(
  image: IconName | null,
  name: string,
  run: () => void,
  options: ButtonOptions = {},
) {
  const { key, off, pressed, expanded } = options;
  return html`<button
    class="b ${options.class ?? ''}"
    aria-label=${name}
    title=${options.hint ?? nothing}
    aria-disabled=${off ? 'true' : nothing}
    aria-pressed=${pressed === undefined ? nothing : String(pressed)}
    aria-expanded=${expanded === undefined ? nothing : String(expanded)}
    aria-keyshortcuts=${options.shortcut ?? key ?? nothing}
    @click=${run}
  >
    ${options.body ?? (image ? icon(image) : nothing)}<span class="name" aria-hidden="true">${name}</span>
    ${key ? html`<kbd data-key=${key}></kbd>` : nothing}
    <span class="tip" aria-hidden="true">${name}${key ? html`<kbd data-key=${key}></kbd>` : nothing}</span>
  </button>`;
}

export function topBar(session: Session, actions: Actions): TemplateResult {
  return html`<header class="top" part="toolbar">
    ${actions.readOnly ? html`<div class="tray chrome card name" part="tray">${session.name ? html`<b>${session.name}</b>` : wordmark}</div>` : nothing}
    <div class="tray chrome card styles" part="tray" role="radiogroup" aria-label="Style" @keydown=${roving}>
      ${styleRadios(session, () => actions.toggle('settings'))}
      <span class="separator"></span>
      ${iconButton('settings', 'Settings', () => actions.toggle('settings'), { expanded: actions.open === 'settings' })}
    </div>
    <div class="tray chrome card right" part="tray">
      <slot name="toolbar"></slot>
      ${actions.readOnly ? nothing : steps(session)} ${actions.readOnly ? nothing : partsButton(session, actions)}
      ${actions.readOnly ? nothing : iconButton('share', 'Export', () => actions.toggle('export'), { expanded: actions.open === 'export', class: 'share' })}
      ${iconButton('more', 'More', () => actions.toggle('menu'), { expanded: actions.open === 'menu' })}
    </div>
  </header>`;
}

function steps(session: Session): TemplateResult {
  const { history } = session;
  return html`
    ${iconButton('undo', 'Undo', () => session.undo(), { key: 'U', off: !undoable(history), shortcut: 'U Control+Z' })}
    ${iconButton('redo', 'Redo', () => session.redo(), { key: 'Shift Z', off: !redoable(history), shortcut: 'Shift+Z Control+Shift+Z' })}
    <span class="separator"></span>`;
}

function partsButton({ document }: Session, actions: Actions): TemplateResult {
  const count = document.parts.length;
  return iconButton(null, PART_WORDS.parts(count), () => actions.toggle('parts'), {
    expanded: actions.open === 'parts',
    class: 'parts-button',
    body: html`${icon('parts')}${count > 0 ? html`<span class="count">${count}</span>` : nothing}`,
  });
}

/** A lit ball a style; `again` answers a tap on the chosen one. */
export function styleRadios(session: Session, again: () => void): TemplateResult[] {
  const { look, document } = session;
  return (Object.entries(STYLE_NAMES) as [ShownStyle, string][]).map(([style, name]) => {
    const chosen = look.style === style || (style === 'gouraud' && look.style === 'phong');
    return html`<button
      class="style"
      role="radio"
      aria-label=${name}
      aria-checked=${chosen}
      tabindex=${chosen ? 0 : -1}
      @click=${() => (chosen ? again() : session.setStyle(style, name))}
    >
      ${ball(style, document.brush.colour)}<span>${name}</span>
    </button>`;
  });
}

/** Arrow keys move within a group of radios, as they do in a native one. */
export function roving(event: KeyboardEvent): void {
  const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
  if (!step) return;
  const radios = [...(event.currentTarget as HTMLElement).querySelectorAll<HTMLElement>('[role=radio]')];
  const from = radios.indexOf(event.target as HTMLElement);
  const next = radios[(from + step + radios.length) % radios.length];
  if (from < 0 || !next) return;
  event.preventDefault();
  event.stopPropagation();
  next.focus();
  next.click();
}

/** Tools and what belongs to them; named until the first part is kept. */
export function rail(session: Session, actions: Actions): TemplateResult {
  const { brush, parts } = session.document;
  const named = parts.length === 0 && !session.document.draft;
  const drawing = session.tool === 'draw';
  const hasSurface = parts.some(isSurface) || session.document.draft !== null;
  const draw = () => {
    session.setTool('draw');
    actions.dismiss();
  };
  const across = () => {
    session.setTool('section');
    actions.dismiss();
  };
  const { min, max } = RADIUS_RANGE;
  const { radius } = session;
  const position = radiusToSlider(radius);
  const moved = (done: boolean) => (event: Event) =>
    actions.setRadius(sliderToRadius(Number((event.target as HTMLInputElement).value)), done);
  return html`<div class="rail card chrome ${named ? 'named' : ''} ${drawing ? '' : 'selecting'}" part="tools" role="toolbar" aria-label="Tools" aria-orientation="vertical">
    ${iconButton('draw', 'Draw', draw, { key: 'D', pressed: drawing })}
    ${iconButton('section', SECTION_WORDS.tool, across, { key: 'L', pressed: session.tool === 'section' })}
    ${hasSurface ? iconButton('redraw', EDIT_WORDS.redraw, () => startRedraw(session), { key: EDIT_WORDS.redrawKey, pressed: session.tool === 'redraw' }) : nothing}
    ${hasSurface ? iconButton('bend', EDIT_WORDS.bend, () => startBend(session), { key: EDIT_WORDS.bendKey, pressed: session.tool === 'bend' }) : nothing}
    ${iconButton('select', PART_WORDS.select, () => session.setTool('select'), { key: 'V', pressed: session.tool === 'select' })}
    ${
      drawing
        ? html`<hr />${iconButton(null, 'Colour', () => actions.toggle('palette'), {
            expanded: actions.open === 'palette',
            body: html`<span class="swatch">${ball('toon', brush.colour)}</span>`,
          })}`
        : nothing
    }
    ${
      named || !drawing
        ? nothing
        : html`<div class="upright">
              <input
                type="range" min="0" max="100" step="1" aria-label="Tube radius"
                aria-valuetext="${radius} mm, from ${min} to ${max}" title="Tube radius (Q, Shift Q)"
                style="--fill: ${position}%" .value=${live(String(position))} @input=${moved(false)} @change=${moved(true)}
                @pointerdown=${() => session.holdSlider()} @blur=${() => session.holdSlider()}
              />
            </div>
            <button class="caption" title=${SIZE_WORDS.hint} aria-label=${SIZE_WORDS.brush(radius)} @click=${() => drawRadius(session, (mm) => ({ type: 'setBrush', change: { radius: mm } }))}>${radius} mm</button>`
    }
    ${navigator.maxTouchPoints > 0 ? fingerSwitch(actions) : nothing}
  </div>`;
}

/** Only where there are fingers. */
const fingerSwitch = (actions: Actions) =>
  html`<hr />${iconButton('finger', 'Finger draws', () => actions.setFingersDraw(!actions.fingersDraw), {
    pressed: actions.fingersDraw,
    class: 'toggle',
  })}`;

/** The slider is logarithmic: thin tubes need fine steps. */
const SPAN = Math.log(RADIUS_RANGE.max / RADIUS_RANGE.min);
export const radiusToSlider = (mm: number) => Math.round((100 * Math.log(mm / RADIUS_RANGE.min)) / SPAN);
export const sliderToRadius = (value: number) =>
  roundRadius(RADIUS_RANGE.min * Math.exp((SPAN * value) / 100));

/** Half millimetres below ten, whole ones above, within the range. */
export function roundRadius(mm: number): number {
  const step = mm < 10 ? 0.5 : 1;
  return Math.min(RADIUS_RANGE.max, Math.max(RADIUS_RANGE.min, Math.round(mm / step) * step));
}

export function notice(session: Session): TemplateResult | typeof nothing {
  const { notice: shown } = session;
  if (!shown) return nothing;
  const run = (action: () => void) => () => {
    session.notice = null;
    action();
    session.update();
  };
  return html`<div class="notice card" part="notice" role="alert">
    ${icon('warn')}<span>${shown.text}</span>
    ${shown.actions.map(({ label, run: action }) => html`<button class="b quiet text" @click=${run(action)}>${label}</button>`)}
    ${iconButton(
      'x',
      'Close',
      run(() => {}),
    )}
  </div>`;
}
