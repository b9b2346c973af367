/** The panels that open on request: settings, colours, menu, keys. */
import { html, nothing, type TemplateResult } from 'lit';
import type { Brush } from '../document/document.ts';
import { type Background, PAPER_COLOUR } from '../scene/look.ts';
import { copySelection, pasteHere } from './clipboard.ts';
import { spheres } from './colours.ts';
import { type Actions, roving, styleRadios } from './controls.ts';
import { drawingsPanel } from './drawingsPanel.ts';
import { exportPanel } from './exportPanel.ts';
import { filePanel } from './filePanel.ts';
import { brushFinish, partFinish } from './finishCard.ts';
import { type IconName, icon } from './icons.ts';
import { frame, toggle } from './panelFrame.ts';
import { partColours } from './partCard.ts';
import { partsPanel } from './partsPanel.ts';
import type { Session } from './session.ts';
import { KEYS, SOLID_WORDS, WORDS } from './words.ts';

const BACKGROUNDS: readonly (readonly [id: Background, name: string])[] = [
  ['paper', 'Paper'],
  ['white', 'White'],
  ['blue', 'Dark blue'],
  ['black', 'Black'],
];

const FILTERS: readonly (readonly [id: Brush['filter'], name: string, title: string])[] = [
  ['least-squares', 'Smooth', 'Least squares: calms the hand the most'],
  ['chaikin', 'Chaikin', 'The thesis’ reverse Chaikin subdivision'],
  ['cubic', 'Cubic', 'The thesis’ reverse cubic subdivision'],
];

export function panel(session: Session, actions: Actions): TemplateResult | typeof nothing {
  if (actions.open === 'settings') return settings(session, actions);
  if (actions.open === 'palette') return palette(session, actions);
  if (actions.open === 'menu') return menu(session, actions);
  if (actions.open === 'help') return help(actions);
  if (actions.open === 'drawings') return drawingsPanel(session, actions);
  if (actions.open === 'file') return filePanel(session, actions);
  if (actions.open === 'export') return exportPanel(session, actions);
  if (actions.open === 'parts') return partsPanel(session, actions);
  return nothing;
}

function settings(session: Session, actions: Actions): TemplateResult {
  const { look } = session;
  const perspective = session.view.fov > 0;
  const dark = BACKGROUNDS.find(([id]) => id === look.background);
  const body = html`
    <div class="presets" role="radiogroup" aria-label="Style" @keydown=${roving}>
      ${styleRadios(session, () => {})}
    </div>
    <section>
      ${toggle('Outline', look.outline, (outline) => session.setLook({ outline }))}
      ${toggle('Perspective', perspective, (on) => session.camera.setPerspective(on))}
      ${toggle('Grid', look.grid, (grid) => session.setLook({ grid }))}
      ${toggle('Wireframe', look.wireframe, (wireframe) => session.setLook({ wireframe }))}
      ${toggle(WORDS.exactSurface, look.mode === 'exact', (on) => session.setMode(on ? 'exact' : 'mesh'), {
        title: WORDS.exactHint,
        off: session.looks.hasBodies ? null : WORDS.noBodies,
      })}
      ${toggle(WORDS.volumes, session.volumes, () => session.looks.toggleVolumes(), {
        title: WORDS.volumesHint,
        off: session.looks.hasBodies ? null : WORDS.noBodies,
      })}
    </section>
    <section>
      <h3>Background <span class="value">${dark?.[1]}</span></h3>
      <div class="dots" role="radiogroup" aria-label="Background" @keydown=${roving}>
        ${BACKGROUNDS.map(
          ([id, name]) =>
            html`<button role="radio" aria-label=${name} title=${name} aria-checked=${look.background === id} tabindex=${look.background === id ? 0 : -1}
              @click=${() => session.setBackground(id)}><i style="background:${PAPER_COLOUR[id]}"></i></button>`,
        )}
      </div>
      ${toggle('Grain', look.grain, (grain) => session.setLook({ grain }))}
    </section>
    ${actions.readOnly ? nothing : stroke(session)}`;
  return frame('Settings', '', actions, body);
}

function stroke(session: Session): TemplateResult {
  const { brush } = session.document;
  return html`<section>
      <h3>Stroke <span class="value">${brush.levels === 0 ? 'as drawn' : `smoothing ${brush.levels}`}</span></h3>
      <div class="segment" role="radiogroup" aria-label="Stroke filter" @keydown=${roving}>
        ${FILTERS.map(
          ([id, name, title]) =>
            html`<button role="radio" title=${title} aria-checked=${brush.filter === id} tabindex=${brush.filter === id ? 0 : -1} @click=${() => session.setBrush({ filter: id })}>${name}</button>`,
        )}
      </div>
      <div class="slide">
        <input type="range" min="0" max="6" step="1" aria-label="Smoothing" .value=${String(brush.levels)} style="--fill:${(brush.levels / 6) * 100}%"
          @change=${(event: Event) => session.setBrush({ levels: Number((event.target as HTMLInputElement).value) })} />
      </div>
      ${toggle('Pressure makes tubes thicker', brush.pressure, (pressure) => session.setBrush({ pressure }))}
      ${toggle('Every stroke a tube', session.document.tubesOnly, (on) => session.run({ type: 'setTubesOnly', on }))}
      ${toggle('Close open ends', brush.caps, (caps) => session.setBrush({ caps }))}
    </section>`;
}

/** Of the selected parts, or else of what is being drawn. */
function palette(session: Session, actions: Actions): TemplateResult {
  if (session.tool === 'select' && session.selection.length > 0)
    return frame(
      'Colour',
      'palette',
      actions,
      html`<section>${partColours(session)} ${partFinish(session)}</section>`,
    );
  const { colour } = session.document.brush;
  const set = (value: string) => session.setBrush({ colour: value });
  const body = html`<section>${spheres('Colour of this and the next form', colour, colour, set)} ${brushFinish(session)}</section>`;
  return frame('Colour', 'palette', actions, body);
}

function menu(session: Session, actions: Actions): TemplateResult {
  const { document } = session;
  const entry = (image: IconName, name: string, key: string, run: () => void) => {
    const choose = () => {
      actions.dismiss();
      run();
    };
    return html`<button class="row" @click=${choose}>${icon(image, 20)}<span class="grow">${name}</span>${key ? html`<kbd>${key}</kbd>` : nothing}</button>`;
  };
  const body = html`<section>
      ${entry('focus', 'Show everything', 'Home', () => session.camera.showAll())}
      ${entry('home', 'Reset the view', '0', () => session.camera.reset())}
      <div class="faces" role="group" aria-label="Look from">
        ${FACES.map((side) => html`<button class="b quiet" @click=${() => session.camera.face(side)}>${capital(side)}</button>`)}
      </div>
      ${entry('full', 'Full screen', 'F', () => session.onFullScreen())}
      ${actions.readOnly ? nothing : entry('share', 'Export', '', () => actions.toggle('export'))}
      ${entry('help', 'Keys and gestures', '?', () => actions.toggle('help'))}
    </section>
    ${
      actions.readOnly
        ? nothing
        : html`<section>
            ${session.selection.length ? entry('duplicate', SOLID_WORDS.copy, 'Ctrl C', () => copySelection(session)) : nothing}
            ${entry('paste', SOLID_WORDS.paste, 'Ctrl V', () => void pasteHere(session))}
          </section>`
    }
    ${
      !actions.readOnly && (document.parts.length || document.draft)
        ? html`<section>
            ${document.parts.length ? entry('trash', 'Delete the last part', 'C', () => session.run({ type: 'removeLast' })) : nothing}
            ${entry('trash', 'Delete everything', 'E', () => session.run({ type: 'removeAll' }))}
          </section>`
        : nothing
    }
    ${drawnBy(session)}`;
  return frame('More', 'menu', actions, body);
}

/** What draws the picture, and why it is not WebGPU. */
function drawnBy({ scene }: Session): TemplateResult | typeof nothing {
  if (!scene) return nothing;
  const about = scene.fallbackReason ?? scene.description?.adapter ?? null;
  return html`<section><p class="row"><small>${WORDS.drawnBy(scene.backend, about)}</small></p></section>`;
}

const FACES = ['front', 'right', 'top', 'back', 'left', 'bottom'] as const;
const capital = (word: string) => word[0]!.toUpperCase() + word.slice(1);

const GESTURES: readonly (readonly [who: string, does: string])[] = [
  ['Pen', 'draws; its side button turns the view'],
  ['One finger', 'draws, or turns the view once a pen was seen'],
  ['Two fingers', 'move, zoom and turn; a tap undoes'],
  ['Three fingers', 'turn the form; a tap redoes'],
  ['Mouse', 'left draws, right turns, Ctrl right moves, middle rolls, wheel zooms'],
];

function help(actions: Actions): TemplateResult {
  const body = html`<section>
      <dl>${GESTURES.map(([who, does]) => html`<dt>${who}</dt><dd>${does}</dd>`)}</dl>
    </section>
    <section>
      <dl>${KEYS.map(({ keys, does }) => html`<dt><kbd>${keys}</kbd></dt><dd>${does}</dd>`)}</dl>
    </section>`;
  return frame('Keys and gestures', '', actions, body);
}
