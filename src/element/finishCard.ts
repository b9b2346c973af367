/** How what is selected, or what is drawn next, answers light: a palette of lit spheres, and behind it the four numbers (thesis A.3). */
import { html, nothing, type TemplateResult } from 'lit';
import { CLAY } from '../document/build.ts';
import { groupsChosen } from '../document/chosen.ts';
import { nameOf } from '../document/command/changeParts.ts';
import type { Command } from '../document/command/index.ts';
import { finishOf, isBody } from '../document/document.ts';
import { type Finish, sameFinish } from '../document/finish.ts';
import { RANGES } from '../document/limits.ts';
import { chosenColour, chosenParts } from './chosenParts.ts';
import { roving } from './controls.ts';
import { FINISHES, finishBall, finishName } from './finishes.ts';
import type { Session } from './session.ts';
import { even, percent, ratios, type Scale, sliderRow } from './sliderRow.ts';
import { FINISH_WORDS, PART_WORDS } from './words.ts';

interface Of {
  /** of what, for those who do not see it */
  readonly name: string;
  readonly colour: string;
  readonly finishes: readonly Finish[];
  readonly command: (finish: Partial<Finish>) => Command;
  readonly isFolded?: boolean;
}

/** `isFolded`: the palette of finishes, too, in a card where more is to be seen. Of the selected parts; of a form within a solid that solid's. Bodies have none. */
export function partFinish(session: Session, isFolded = false): TemplateResult | typeof nothing {
  const shown = session.shown();
  const inside = groupsChosen(shown, session.selection).map(({ solid }) => solid);
  const parts = new Set([...chosenParts(session), ...inside]);
  const finishes = [...parts].filter((part) => !isBody(part)).map(finishOf);
  if (finishes.length === 0) return nothing;
  const ids = session.selection;
  return finishRows(session, {
    name: nameOf(session.document, ids),
    colour: chosenColour(session) ?? CLAY,
    finishes,
    command: (finish) => ({ type: 'setPartBrush', ids, change: { finish } }),
    isFolded,
  });
}

/** Of the unfinished form, and of those that follow. */
export function brushFinish(session: Session): TemplateResult {
  const { brush } = session.shown();
  return finishRows(session, {
    name: FINISH_WORDS.next,
    colour: brush.colour,
    finishes: [brush.finish],
    command: (finish) => ({ type: 'setBrush', change: { finish } }),
  });
}

/** who opened it finds it open with the next part */
const opened = new WeakSet<Session>();

function finishRows(session: Session, of: Of): TemplateResult {
  const [first, ...others] = of.finishes;
  const same = others.every((other) => sameFinish(other, first!)) ? first! : null;
  const more = (event: Event) => {
    if ((event.target as HTMLDetailsElement).open) opened.add(session);
    else opened.delete(session);
  };
  const palette = html`<h3>${FINISH_WORDS.finish} <span class="value">${same ? finishName(same) : PART_WORDS.mixed}</span></h3>
    ${balls(session, of, same)}`;
  return html`${of.isFolded ? nothing : palette} ${slider(session, of, 'specular')}
    <details class="more" ?open=${opened.has(session)} @toggle=${more}>
      <summary>${FINISH_WORDS.more}</summary>
      ${of.isFolded ? palette : nothing}
      ${slider(session, of, 'ambient')} ${slider(session, of, 'diffuse')} ${slider(session, of, 'shininess')}
    </details>`;
}

function balls(session: Session, { name, colour, command }: Of, now: Finish | null): TemplateResult {
  const isOne = FINISHES.some(([, finish]) => now && sameFinish(finish, now));
  return html`<div class="spheres" role="radiogroup" aria-label=${FINISH_WORDS.finishOf(name)} @keydown=${roving}>
    ${FINISHES.map(([word, finish], i) => {
      const isNow = now !== null && sameFinish(finish, now);
      return html`<button role="radio" aria-label=${word} title=${word} aria-checked=${isNow} tabindex=${isNow || (!isOne && i === 0) ? 0 : -1}
        @click=${() => session.run(command(finish))}>${finishBall(finish, colour, session.look.style)}</button>`;
    })}
  </div>`;
}

const { light, specular, shininess } = RANGES;
const SCALES: Readonly<Record<keyof Finish, Scale>> = {
  ambient: even(light.min, light.max, 0.01),
  diffuse: even(light.min, light.max, 0.01),
  specular: even(specular.min, specular.max, 0.01),
  shininess: ratios(shininess.min, shininess.max),
};

function slider(session: Session, { name, finishes, command }: Of, key: keyof Finish): TemplateResult {
  const [value, ...others] = finishes.map((finish) => finish[key]);
  return sliderRow(session, {
    name: FINISH_WORDS.name[key],
    hint: FINISH_WORDS.hint[key],
    of: name,
    value: others.every((other) => other === value) ? value! : null,
    inRow: true,
    text: key === 'shininess' ? String : percent,
    scale: SCALES[key],
    command: (changed) => command({ [key]: changed }),
  });
}
