/** The panel: one section a decision, and only what applies. */
import { html, nothing, type TemplateResult } from 'lit';
import { kernelNamed } from '../../kernel/index.ts';
import type { Shape } from '../../shape/index.ts';
import { CHOICES, NUMBERS } from './fieldState.ts';
import { FIELD_WORDS } from './fieldWords.ts';
import { KERNEL_CAPTIONS, kernelPicture, skeletonPicture } from './pictograms.ts';
import { type Desk, segment, select, slider, tiles } from './rows.ts';
import { hasPlate } from './skeletons.ts';
import { examplesOf, firstWeight, hasTwoEnds, ordinatesOf, paramsOf } from './tree.ts';

const section = (title: string, body: unknown) =>
  html`<section aria-label=${title}><h3>${title}</h3>${body}</section>`;

const note = (words: string) => html`<p class="note">${words}</p>`;

/** `gpu`: there is a device to evaluate on. */
export function controls(desk: Desk, gpu: boolean): TemplateResult {
  return html`
    ${section('Skeleton', skeleton(desk))} ${section('Kernel', kernel(desk))} ${section('Cross section', crossSection(desk))}
    ${section('Carve', carve(desk))} ${section('With a shape', operation(desk))} ${section('Surface', surface(desk, gpu))}`;
}

function skeleton(desk: Desk): TemplateResult {
  const { state } = desk;
  const radii = hasTwoEnds(state) ? (['radius', 'radiusEnd'] as const) : (['radius'] as const);
  const ordinates = (['weight1', 'weight2', 'weight3'] as const).slice(0, ordinatesOf(state) ?? 0);
  const hasDegree = state.by === 'weight' && state.skeleton === 'segment';
  return html`${tiles(desk, 'skeleton', 3, skeletonPicture)}
    ${segment(byDesk(desk), 'by')}
    ${state.by === 'radius' ? radii.map((key) => slider(desk, key)) : slider(desk, 'weight')}
    ${state.by === 'radius' && state.kernel === 'inverse' ? note(FIELD_WORDS.inverse) : nothing}
    ${hasDegree ? segment(desk, 'degree') : nothing} ${ordinates.map((key) => slider(desk, key))}
    ${slider(desk, 'T')}`;
}

/** Going over to weights keeps the body: its first weight is taken along. */
function byDesk(desk: Desk): Desk {
  return {
    state: desk.state,
    set(change) {
      const weight = change.by === 'weight' ? weightNow(desk) : null;
      desk.set(weight === null ? change : { ...change, weight });
    },
  };
}

function weightNow({ state }: Desk): number | null {
  const { min, max } = NUMBERS.weight;
  try {
    return Math.min(Math.max(Number(firstWeight(state).toPrecision(3)), min), max);
  } catch {
    return null;
  }
}

function kernel(desk: Desk): TemplateResult {
  const { state } = desk;
  const params = kernelNamed(state.kernel)?.params ?? [];
  const hasWidth = params.some(({ name }) => name !== 'n');
  const shown = params.filter(({ name }) => name === 'n' || state.width === 'own');
  return html`${tiles(desk, 'kernel', 4, kernelPicture, (id, name) => KERNEL_CAPTIONS[id] ?? name)}
    ${hasWidth ? segment(widthDesk(desk), 'width') : note(FIELD_WORDS.noWidth)}
    ${shown.map(({ name }) => slider(desk, name))}`;
}

/** Setting the width by hand begins with the fitted one. */
function widthDesk(desk: Desk): Desk {
  return {
    state: desk.state,
    set: (change) => desk.set(change.width === 'own' ? { ...change, ...fittedWidth(desk) } : change),
  };
}

function fittedWidth({ state }: Desk): Partial<Desk['state']> {
  try {
    const entries = Object.entries(paramsOf({ ...state, width: 'fitted' }));
    return Object.fromEntries(entries.map(([name, value]) => [name, Number(value.toPrecision(3))]));
  } catch {
    return {};
  }
}

function crossSection(desk: Desk): TemplateResult {
  const { section: kind, skeleton } = desk.state;
  return html`${tiles(desk, 'section', 2, () => nothing)}
    ${kind === 'superQuadric' ? slider(desk, 'alpha') : nothing}
    ${kind === 'extrusion' ? slider(desk, 'edge') : nothing}
    ${kind === 'polar' ? segment(desk, 'profile', false) : nothing}
    ${kind !== 'round' && hasPlate(skeleton) ? note(FIELD_WORDS.plateSection) : nothing}
    ${slider(desk, 'betaX')} ${slider(desk, kind === 'extrusion' ? 'thickness' : 'betaY')}`;
}

function carve(desk: Desk): TemplateResult {
  const on = desk.state.carve !== 0;
  const where = ['carveRadius', 'carveX', 'carveY'] as const;
  return html`${slider(desk, 'carve')} ${on ? where.map((key) => slider(desk, key)) : nothing}`;
}

function operation(desk: Desk): TemplateResult {
  const { operation: kind } = desk.state;
  const isSet = kind === 'union' || kind === 'intersection' || kind === 'subtraction';
  return html`${tiles(desk, 'operation', 3, () => nothing)}
    ${isSet ? segment(desk, 'form', false) : nothing}
    ${kind === 'blend' ? (['a0', 'a1', 'a2'] as const).map((key) => slider(desk, key)) : nothing}
    ${kind === 'morph' ? slider(desk, 't') : nothing} ${kind === 'none' ? nothing : shape(desk)}`;
}

function shape(desk: Desk): TemplateResult {
  const { state } = desk;
  const examples = examplesOf(state).map((of, i) => [String(i), exampleName(of)] as const);
  const example = String(Math.min(state.example, examples.length - 1));
  const places = ['shapeSize', 'shapeX', 'shapeTurn', 'shapeTilt'] as const;
  return html`${select('Shape', 'shape', state.shape, CHOICES.shape.options, (id) => desk.set({ shape: id, example: 0 }))}
    ${select('Example', 'example', example, examples, (i) => desk.set({ example: Number(i) }))}
    ${places.map((key) => slider(desk, key))}`;
}

/** "ring 10, tube 3" */
function exampleName({ type: _, ...sizes }: Shape): string {
  return Object.entries(sizes)
    .map(([name, value]) => `${name} ${Array.isArray(value) ? value.join(' ') : value}`)
    .join(', ');
}

function surface(desk: Desk, gpu: boolean): TemplateResult {
  return html`${slider(desk, 'resolution')} ${gpu ? segment(desk, 'where') : nothing}
    ${segment(desk, 'surface')} ${desk.state.surface === 'exact' ? segment(desk, 'rays') : nothing}
    ${segment(desk, 'volumes')}`;
}
