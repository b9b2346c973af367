/** How finely surfaces are cut (thesis A.4): finer and coarser by a step, and behind it spans of the control mesh and how often they are halved. */
import { html, nothing, type TemplateResult } from 'lit';
import { solidOf } from '../document/build.ts';
import { nameOf } from '../document/command/changeParts.ts';
import type { SurfacePart } from '../document/document.ts';
import { RANGES } from '../document/limits.ts';
import { sheetOf } from '../document/sheets.ts';
import { DEFAULT_DETAIL, type Detail } from '../document/surfacePart.ts';
import { iconButton } from './controls.ts';
import { toggle } from './panelFrame.ts';
import type { Session } from './session.ts';
import { even, ratios, type Scale, sliderRow } from './sliderRow.ts';
import { PART_WORDS, SURFACE_WORDS } from './words.ts';

/** who opened the editor finds it open with the next part */
const opened = new WeakSet<Session>();
/** spans one begins with who sets their number */
const ROWS = 16;

/** `mesh`: what shows the control mesh that is set here. */
export function detailRows(
  session: Session,
  parts: readonly SurfacePart[],
  mesh: TemplateResult | typeof nothing,
): TemplateResult {
  const details = parts.map(({ detail }) => detail);
  const of = nameOf(session.document, session.selection);
  const more = (event: Event) => {
    if ((event.target as HTMLDetailsElement).open) opened.add(session);
    else opened.delete(session);
  };
  const { subdivisions } = RANGES;
  const off = (by: 1 | -1) =>
    details.every(({ u, v }) =>
      by > 0 ? Math.min(u, v) >= subdivisions.max : Math.max(u, v) <= subdivisions.min,
    );
  return html`<div class="detail">
      <div><h3>${SURFACE_WORDS.detail}</h3><small>${counts(parts)}</small></div>
      ${iconButton('minus', SURFACE_WORDS.coarser, () => step(session, parts, -1), { off: off(-1) })}
      ${iconButton('plus', SURFACE_WORDS.finer, () => step(session, parts, 1), { off: off(1) })}
    </div>
    <details class="more" ?open=${opened.has(session)} @toggle=${more}>
      <summary>${SURFACE_WORDS.editDetail}</summary>
      ${editor(session, details, of)} ${mesh}
    </details>`;
}

/** "64 × 64, 8,192 triangles" */
function counts(parts: readonly SurfacePart[]): string {
  const triangles = parts.reduce((sum, part) => sum + (solidOf(part)?.mesh.indices.length ?? 0) / 3, 0);
  const [size, ...others] = parts.map(sizeOf);
  const isSame = size && others.every((other) => other === size);
  return `${isSame ? `${size}, ` : ''}${PART_WORDS.triangles(triangles)}`;
}

/** Quads along and across, without what shuts the ends. */
export function sizeOf(part: SurfacePart): string {
  const sheet = sheetOf(part.kind, part, part.brush);
  const rows = sheet?.rows.filter(({ at }) => !at.rigid) ?? [];
  const along = rows.filter(({ joined, at }, i) => i > 0 && joined && at.u > rows[i - 1]!.at.u).length;
  const across = sheet?.columns.joined.filter(Boolean).length ?? 0;
  return `${along} × ${across}`;
}

/** Every part by a step from where it is, as one undo step. */
function step(session: Session, parts: readonly SurfacePart[], finer: 1 | -1): void {
  const ids = parts.map(({ id }) => id);
  session.run({ type: 'setSurface', ids, change: { detail: { finer } } });
}

const { rows, columns, subdivisions } = RANGES;
const whole = (scale: Scale): Scale => ({ ...scale, value: (place) => Math.round(scale.value(place)) });
const SCALES: Readonly<Record<keyof Detail, Scale>> = {
  rows: whole(ratios(rows.min, rows.max)),
  columns: whole(ratios(columns.min, columns.max)),
  u: even(subdivisions.min, subdivisions.max, 1),
  v: even(subdivisions.min, subdivisions.max, 1),
};

function editor(session: Session, details: readonly Detail[], of: string): TemplateResult {
  const change = (detail: Partial<Detail>) =>
    ({ type: 'setSurface', ids: session.selection, change: { detail } }) as const;
  const isAuto = details.every((detail) => detail.rows === null);
  const slider = (key: keyof Detail) => {
    const [value, ...others] = details.map((detail) => detail[key]);
    return sliderRow(session, {
      name: SURFACE_WORDS.parts[key].name,
      hint: SURFACE_WORDS.parts[key].hint,
      of,
      value: value === null || others.some((other) => other !== value) ? null : value!,
      text: String,
      scale: SCALES[key],
      command: (wanted) => change({ [key]: wanted }),
    });
  };
  const auto = (on: boolean) => session.run(change({ rows: on ? DEFAULT_DETAIL.rows : ROWS }));
  return html`${toggle(SURFACE_WORDS.autoRows, isAuto, auto, { title: SURFACE_WORDS.autoRowsHint })}
    ${isAuto ? nothing : slider('rows')} ${slider('columns')} ${slider('u')} ${slider('v')}`;
}
