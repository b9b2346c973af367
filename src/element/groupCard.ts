/**
 * What can be set of the forms of solids: what their strokes become, how thick, how they count and blend, and what they belong to. What is set of a
 * solid or of several is set of all that is in them.
 */
import { html, nothing, type TemplateResult } from 'lit';
import { type GroupAt, groupsChosen } from '../document/chosen.ts';
import { nameOf } from '../document/command/changeParts.ts';
import type { Document } from '../document/document.ts';
import { isSolid, type Joins, RADIUS_RANGE } from '../document/document.ts';
import { boxOfGroup } from '../document/extent.ts';
import {
  EXTRUSION,
  type Form,
  type Group,
  type GroupShape,
  mostStrokes,
  SECTIONS,
} from '../document/solid.ts';
import { shapedOf } from '../document/solidNode.ts';
import { kernels } from '../kernel/index.ts';
import type { Kernel } from '../kernel/kernel.ts';
import { radiusToSlider, roving, sliderToRadius } from './controls.ts';
import { icon } from './icons.ts';
import { toggle } from './panelFrame.ts';
import { joinSelection } from './partDeeds.ts';
import { iconOf } from './partRows.ts';
import { profileEditor } from './profileEditor.ts';
import type { Session } from './session.ts';
import { skeletonRow } from './skeletonRow.ts';
import { even, percent, ratios, sliderRow } from './sliderRow.ts';
import { PART_WORDS, SKELETON_WORDS, SOLID_WORDS } from './words.ts';

export function groupCard(session: Session): TemplateResult | typeof nothing {
  const chosen = groupsChosen(session.shown(), session.selection);
  if (chosen.length === 0) return nothing;
  const groups = chosen.map(({ group }) => group);
  const of = nameOf(session.document, session.selection);
  return html`${forms(session, groups, of)} ${radius(session, groups, of)} ${profileEditor(session, groups)} ${skeletonRow(session)}
    ${depths(session, groups, of)}
    ${sections(session, groups, of)} ${sums(session, chosen, of)} ${belongs(session, chosen)} ${fit(chosen)}`;
}

/** What all have; null where they differ. */
function same<T>(values: readonly T[]): T | null {
  const [first] = values;
  return first !== undefined && values.every((value) => value === first) ? first : null;
}

const CLOSED: readonly Form[] = ['soft', 'plate', 'ring', 'line'];
const OPEN: readonly Form[] = ['line', 'curve', 'soft'];

/** What its strokes can become: a tap a point only, as it has no length. */
export function formsOf({ strokes, form }: Group): readonly Form[] {
  const { samples, closed } = strokes[0]!;
  const usual = samples.length < 2 ? [] : closed ? CLOSED : OPEN;
  // holes are of outlines only
  const fitting = usual.filter((some) => strokes.length <= mostStrokes(some));
  return fitting.includes(form) ? fitting : [...fitting, form];
}

function forms(session: Session, groups: readonly Group[], of: string): TemplateResult | typeof nothing {
  const all = groups.map(formsOf);
  const offered = all[0]!.filter((form) => all.every((some) => some.includes(form)));
  if (offered.length < 2) return nothing;
  const now = same(groups.map(({ form }) => form));
  return html`<h3>${SOLID_WORDS.what}</h3>
    ${radios(
      `${SOLID_WORDS.what}: ${of}`,
      offered.map((form) => ({ value: form, name: SOLID_WORDS.form[form], image: iconOf({ form }) })),
      now,
      (form) => session.run({ type: 'setGroups', ids: session.selection, change: { form } }),
    )}`;
}

interface Choice<T> {
  readonly value: T;
  readonly name: string;
  readonly image?: ReturnType<typeof iconOf>;
}

function radios<T>(label: string, choices: readonly Choice<T>[], now: T | null, set: (value: T) => void) {
  return html`<div class="segment ${choices.some(({ image }) => image) ? 'forms' : ''}" role="radiogroup" aria-label=${label} @keydown=${roving}>
    ${choices.map(
      ({ value, name, image }, i) => html`<button role="radio" aria-checked=${value === now}
        tabindex=${value === now || (now === null && i === 0) ? 0 : -1} @click=${() => value !== now && set(value)}
      >${image ? icon(image, 20) : nothing}<span>${name}</span></button>`,
    )}
  </div>`;
}

/** Soft bodies have theirs from their outline. */
function radius(session: Session, groups: readonly Group[], of: string): TemplateResult | typeof nothing {
  if (groups.some(({ form }) => form === 'soft')) return nothing;
  const isPlate = groups.every(({ form }) => form === 'plate');
  const name = isPlate ? SOLID_WORDS.radius.plate : SOLID_WORDS.radius.other;
  if (groups.every(({ skeleton }) => skeleton))
    return html`<h3>${name}</h3><p class="quiet-words">${SKELETON_WORDS.profileByHand}</p>`;
  return sliderRow(session, {
    name,
    of,
    value: same(groups.map(({ brush }) => brush.radius)),
    text: (mm) => `${Math.round(10 * mm) / 10} mm`,
    scale: {
      place: (mm) => radiusToSlider(Math.min(RADIUS_RANGE.max, Math.max(RADIUS_RANGE.min, mm))),
      value: sliderToRadius,
    },
    command: (mm) => ({ type: 'setPartBrush', ids: session.selection, change: { radius: mm } }),
  });
}

function depths(session: Session, groups: readonly Group[], of: string): TemplateResult {
  const slider = (
    key: 'weight' | 'depth' | 'breadth',
    hint: string,
    scale: ReturnType<typeof even>,
    text: (value: number) => string,
  ) =>
    sliderRow(session, {
      name: SOLID_WORDS[key],
      hint,
      of,
      value: same(groups.map(({ shape }) => shape[key])),
      text,
      scale,
      command: (value) => ({ type: 'setGroups', ids: session.selection, change: { [key]: value } }),
    });
  return html`${slider('depth', SOLID_WORDS.depthHint, ratios(0.2, 5), percent)}
    ${slider('breadth', SOLID_WORDS.breadthHint, ratios(0.2, 5), percent)}
    ${carving(session, groups)} ${slider('weight', SOLID_WORDS.weightHint, even(-3, 3, 0.05), (weight) => String(weight))}`;
}

/** The sign of the weight, in a word. */
function carving(session: Session, groups: readonly Group[]): TemplateResult {
  const carves = groups.every(({ shape }) => shape.weight < 0);
  const weight = Math.abs(groups[0]!.shape.weight) || 1;
  return toggle(SOLID_WORDS.carving, carves, (on) =>
    session.run({ type: 'setGroups', ids: session.selection, change: { weight: on ? -weight : weight } }),
  );
}

function sections(session: Session, groups: readonly Group[], of: string): TemplateResult {
  const now = same(groups.map(({ shape }) => shape.section));
  const set = (change: Partial<GroupShape>) => ({
    type: 'setGroups' as const,
    ids: session.selection,
    change,
  });
  return html`<h3>${SOLID_WORDS.section}</h3>
    ${radios(
      `${SOLID_WORDS.section} of ${of}`,
      SECTIONS.map((value) => ({ value, name: SOLID_WORDS.sections[value] })),
      now,
      (section) => session.run(set({ section })),
    )}
    ${
      now === 'round'
        ? nothing
        : sliderRow(session, {
            name: SOLID_WORDS.exponent,
            hint: SOLID_WORDS.exponentHint,
            of,
            value: same(groups.map(({ shape }) => shape.exponent)),
            text: (alpha) => String(alpha),
            scale: ratios(now === 'extrusion' ? EXTRUSION : 0.5, 20),
            command: (exponent) => set({ exponent }),
          })
    }`;
}

/** Kernel and threshold are of components, for all that is in them. */
function sums(session: Session, chosen: readonly GroupAt[], of: string): TemplateResult {
  const components = chosen.map(({ component }) => component);
  const groups = components.flatMap((component) => component.groups);
  const able = kernels.filter((kernel) => groups.every(({ form }) => canDo(kernel, form)));
  const now = same(components.map(({ kernel }) => kernel));
  const ids = session.selection;
  const choose = (event: Event) => {
    const kernel = (event.target as HTMLSelectElement).value;
    session.run({ type: 'setComponents', ids, change: { kernel } });
  };
  return html`<label class="row" title=${SOLID_WORDS.kernelHint}><span>${SOLID_WORDS.kernel}</span>
      <select class="choice" aria-label="${SOLID_WORDS.kernel} of ${of}" @change=${choose} @keydown=${letBe}>
        ${now === null ? html`<option selected>${PART_WORDS.mixed}</option>` : nothing}
        ${kernels
          .filter((kernel) => able.includes(kernel) || kernel.name === now)
          .map(({ name, label }) => html`<option value=${name} .selected=${name === now}>${label}</option>`)}
      </select></label>
    ${sliderRow(session, {
      name: SOLID_WORDS.threshold,
      hint: SOLID_WORDS.thresholdHint,
      of,
      value: same(components.map(({ threshold }) => threshold)),
      text: (threshold) => String(threshold),
      scale: ratios(0.1, 2.5),
      command: (threshold) => ({ type: 'setComponents', ids, change: { threshold } }),
    })}`;
}

/** 1/r of an endless line and of a plane is infinite: outlines cannot be fitted with it. */
const canDo = (kernel: Kernel, form: Form): boolean => {
  if (form === 'plate') return kernel.edge !== null && kernel.wholeLine !== null;
  return form !== 'soft' || kernel.wholeLine !== null;
};

/** Keys that choose are no hot keys. */
function letBe(event: KeyboardEvent): void {
  if (event.key !== 'Escape') event.stopPropagation();
}

// ── what it belongs to ────────────────────────────────────────────────────────────────────────────────

interface Place {
  readonly words: string;
  readonly to: Joins | null;
}

/** Drags in the list, for those who do not drag. */
function belongs(session: Session, chosen: readonly GroupAt[]): TemplateResult {
  const { document, selection } = session;
  const places = placesFor(document, chosen);
  const now = same(chosen.map(({ component }) => component));
  const { solid, component } = chosen[0]!;
  const words =
    now && solid.components.length > 1
      ? SOLID_WORDS.joinNow(component.name, solid.name)
      : same(chosen.map((at) => at.solid))
        ? solid.name
        : PART_WORDS.mixed;
  const go = (event: Event) => {
    const select = event.target as HTMLSelectElement;
    const place = places[Number(select.value)];
    select.value = '';
    if (place) joinSelection(session, selection, place.to);
  };
  return html`<label class="row" title=${SOLID_WORDS.joinHint}><span>${SOLID_WORDS.join}</span>
    <select class="choice" aria-label=${SOLID_WORDS.join} @change=${go} @keydown=${letBe}>
      <option value="" selected>${words}</option>
      ${places.map((place, i) => html`<option value=${i}>${place.words}</option>`)}
    </select></label>`;
}

/** Where groups can go that are not there: components to blend with, solids to be attached to, nowhere. */
export function placesFor({ parts }: Document, chosen: readonly GroupAt[]): readonly Place[] {
  const taken = new Set(chosen.map(({ group }) => group));
  const solids = parts.filter(isSolid);
  const blends = solids.flatMap((solid) =>
    solid.components
      .filter(({ groups }) => !groups.every((group) => taken.has(group)))
      .filter((component) => chosen.some((at) => at.component !== component))
      .map((component) => ({
        words: SOLID_WORDS.dropOn.blend(
          solid.components.length > 1 ? SOLID_WORDS.joinNow(component.name, solid.name) : solid.name,
        ),
        to: { solid: solid.id, component: component.id },
      })),
  );
  const attached = solids
    .filter(
      (solid) =>
        !chosen.every((at) => at.solid === solid && at.component.groups.every((group) => taken.has(group))),
    )
    .map((solid) => ({
      words: SOLID_WORDS.dropOn.attach(solid.name),
      to: { solid: solid.id, component: null },
    }));
  const isWhole = solids.some((solid) => {
    const all = solid.components.flatMap(({ groups }) => groups);
    return all.length === taken.size && all.every((group) => taken.has(group));
  });
  return [...blends, ...attached, ...(isWhole ? [] : [{ words: SOLID_WORDS.dropOn.own, to: null }])];
}

// ── how well it fits ──────────────────────────────────────────────────────────────────────────────────

function fit(chosen: readonly GroupAt[]): TemplateResult | typeof nothing {
  const [only, ...others] = chosen;
  const figures = only && others.length === 0 ? shapedOf(only.group, only.component)?.figures : undefined;
  if (!figures || !only) return nothing;
  const { min, max } = boxOfGroup(only.group);
  const size = Math.max(max[0] - min[0], max[1] - min[1]);
  const off = (100 * figures.most) / size;
  const words = SOLID_WORDS.fit(
    off < 1 ? off.toFixed(1) : String(Math.round(off)),
    Math.round(100 * figures.atBound),
    figures.ratio.toFixed(1),
  );
  return html`<p class="quiet-words">${words}</p>`;
}
