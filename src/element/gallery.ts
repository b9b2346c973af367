/** Drawings to open: on the empty page, where the pen may draw between them, and in the panel of all drawings. */
import { html, nothing, type TemplateResult } from 'lit';
import type { Actions } from './controls.ts';
import type { Files } from './files.ts';
import { icon } from './icons.ts';
import type { Sample } from './samples.ts';
import { FILE_WORDS, PART_WORDS } from './words.ts';

export function gallery(actions: Actions): TemplateResult | typeof nothing {
  const { files } = actions;
  if (files.samples.list.length === 0) return nothing;
  // The cards go, and the focus must not go with them.
  const leave = () => actions.dismiss();
  const choose = () => {
    leave();
    void files.opening.choose();
  };
  return html`<section class="gallery chrome" aria-label="Samples">
    <header>
      <h2>${FILE_WORDS.gallery}<span class="more"> ${FILE_WORDS.galleryMore}</span></h2>
      <button class="b quiet text" @click=${choose}>${icon('open', 20)}Open a file</button>
    </header>
    ${cards(files, leave)}
  </section>`;
}

/** What was drawn: "4 strokes"; of trees, "14 skels" */
const madeOf = ({ strokes, skels }: Sample): string =>
  strokes > 0 ? PART_WORDS.strokes(strokes) : PART_WORDS.skels(skels);

/** in a row where there is room for many */
const ROW = 9;

/** `chosen` is called at once; what is chosen may take a moment. */
export function cards({ samples, opening }: Files, chosen: () => void): TemplateResult {
  const card = (sample: Sample) => {
    const choose = () => {
      chosen();
      void opening.sample(sample);
    };
    return html`<li><button class="card" @click=${choose}>
      <img src=${sample.thumbnail} alt="" width="176" height="132" draggable="false" decoding="async" />
      <b>${sample.name}</b><small>${madeOf(sample)}</small>
    </button></li>`;
  };
  const count = samples.list.length;
  return html`<ul class="cards" role="list" style="--all:${count <= ROW ? count : Math.ceil(count / 2)}">${samples.list.map(card)}</ul>`;
}
