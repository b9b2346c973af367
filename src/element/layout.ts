/** Where things are and what they look like; sizes in rem, targets 44 px (2.75rem) or more. */
import { css } from 'lit';

export const layout = css`
  :host {
    display: block;
    position: relative;
    overflow: hidden;
    contain: strict;
    container-type: size;
    width: 100%;
    height: 24rem;
    background: var(--paper);
    color: var(--ink);
    font: 0.9375rem/1.3125rem var(--font);
    font-variant-numeric: tabular-nums;
    -webkit-font-smoothing: antialiased;
    -webkit-tap-highlight-color: transparent;
    user-select: none;
    -webkit-user-select: none;
  }
  :host([hidden]) { display: none; }
  * { box-sizing: border-box; margin: 0; }
  .app { position: absolute; inset: 0; --gap: 1rem; }
  .stage, .stage canvas { position: absolute; inset: 0; width: 100%; height: 100%; display: block; }
  .stage { touch-action: none; cursor: crosshair; }
  .stage.looking { cursor: grab; }
  .stage:focus-visible { outline: 3px solid var(--pencil); outline-offset: -3px; }
  .stage canvas { pointer-events: none; }
  .instead { position: absolute; inset: 0; pointer-events: none; display: grid; place-items: center; }
  .instead ::slotted(*) { pointer-events: auto; max-width: 100%; max-height: 100%; }
  ::slotted([slot='toolbar']) { min-height: 2.75rem; }
  button { font: inherit; color: inherit; background: none; border: 0; padding: 0; cursor: pointer; }
  .icon { width: 1.5rem; height: 1.5rem; fill: none; stroke: currentColor; stroke-width: 1.75; stroke-linecap: round; stroke-linejoin: round; flex: none; display: block; }
  .icon.small { width: 1.25rem; height: 1.25rem; stroke-width: 2; }
  .ball { width: 1.5rem; height: 1.5rem; display: block; flex: none; }
  .hidden { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
  .card { background: var(--surface); border: 1px solid var(--hairline); border-radius: 1rem; box-shadow: var(--e1); }
  .away { opacity: 0.2; pointer-events: none; }
  .chrome { transition: opacity var(--appear) var(--out); }

  /* buttons */
  .b { min-width: 2.75rem; height: 2.75rem; border-radius: 0.75rem; display: inline-flex; align-items: center; justify-content: center; gap: 0.5rem; position: relative; transition: background var(--press) var(--out); flex: none; }
  .b:hover { background: var(--sunken); }
  .b:active { transform: scale(0.97); }
  .b[aria-disabled='true'] { color: var(--ink-off); cursor: default; }
  .b[aria-pressed='true'], .b.tool[aria-checked='true'] { background: var(--active); color: var(--on-active); }
  .b[aria-expanded='true'], .b.on, .b.toggle[aria-pressed='true'] { background: var(--pencil-soft); color: var(--pencil); }
  :focus-visible { outline: 3px solid var(--pencil); outline-offset: 2px; }
  .b.text { padding: 0 1rem; font-weight: 600; }
  .b.primary { background: var(--pencil); color: var(--on-pencil); }
  .b.primary:hover { background: var(--pencil-press); }
  .b.quiet { background: var(--sunken); }
  .b.danger { color: var(--danger); }
  /* a key's letter is no part of a button's name */
  kbd[data-key]::before { content: attr(data-key); }
  .b > .name, .b > kbd { display: none; }
  kbd { font: 600 0.75rem/1.125rem var(--font); border: 1px solid currentColor; border-radius: 0.3125rem; padding: 0 0.3125rem; min-width: 1.25rem; text-align: center; opacity: 0.85; white-space: nowrap; }
  .separator { width: 1px; height: 1.5rem; background: var(--hairline); margin: 0 0.3125rem; flex: none; }

  /* top */
  .top { position: absolute; inset: var(--gap) var(--gap) auto; height: 3.25rem; display: flex; align-items: center; justify-content: space-between; pointer-events: none; gap: 0.5rem; }
  .top > * { pointer-events: auto; }
  .tray { display: flex; align-items: center; gap: 0.125rem; padding: 0.1875rem; height: 3.25rem; }
  .wordmark { width: 5.25rem; height: 1.6rem; margin: 0 0.75rem; fill: none; stroke: currentColor; stroke-width: 2.2; stroke-linecap: round; stroke-linejoin: round; display: block; }
  .styles { position: absolute; left: 50%; transform: translateX(-50%); }
  .style { height: 2.75rem; min-width: 2.75rem; padding: 0 0.875rem 0 0.625rem; border-radius: 0.75rem; display: flex; align-items: center; justify-content: center; gap: 0.5rem; font-size: 0.875rem; color: var(--ink-2); }
  .style:hover { background: var(--sunken); }
  .style[aria-checked='true'] { background: var(--sunken); color: var(--ink); font-weight: 600; box-shadow: inset 0 0 0 1.5px var(--edge); }

  /* rail */
  .rail { position: absolute; left: var(--gap); top: 50%; transform: translateY(-50%); width: 3.75rem; padding: 0.4375rem; border-radius: 1.25rem; display: flex; flex-direction: column; gap: 0.25rem; align-items: center; }
  .rail hr { width: 1.75rem; border: 0; border-top: 1px solid var(--hairline); margin: 0.25rem 0; }
  .rail button.caption { min-width: 2.75rem; min-height: 2.75rem; border-radius: 0.75rem; }
  .rail button.caption:hover { background: var(--sunken); }
  .rail .caption { font-size: 0.75rem; line-height: 1rem; color: var(--ink-2); text-align: center; white-space: nowrap; }
  .rail.named { width: 11rem; align-items: stretch; }
  .rail.named .b { justify-content: flex-start; padding: 0 0.625rem; gap: 0.75rem; }
  .rail.named .name, .rail.named .b > kbd { display: block; }
  .rail.named kbd { margin-left: auto; }
  .rail.named hr { width: auto; margin: 0.25rem 0.5rem; }

  /* sliders: one native input, so that keys and screen readers work */
  input[type='range'] { appearance: none; background: none; width: 100%; height: 2.75rem; margin: 0; cursor: pointer; touch-action: none; --thumb: 1.625rem; }
  input[type='range']::-webkit-slider-runnable-track { height: 4px; border-radius: 2px; background: linear-gradient(to right, var(--ink-2) var(--fill, 50%), var(--track) var(--fill, 50%)); }
  input[type='range']::-moz-range-track { height: 4px; border-radius: 2px; background: var(--track); }
  input[type='range']::-moz-range-progress { height: 4px; border-radius: 2px; background: var(--ink-2); }
  input[type='range']::-webkit-slider-thumb { appearance: none; width: var(--thumb); height: var(--thumb); margin-top: calc(2px - var(--thumb) / 2); border-radius: 50%; background: var(--surface); border: 2px solid var(--ink-2); box-shadow: var(--e1); }
  input[type='range']::-moz-range-thumb { width: var(--thumb); height: var(--thumb); box-sizing: border-box; border-radius: 50%; background: var(--surface); border: 2px solid var(--ink-2); }
  .upright { width: 2.75rem; height: 8rem; position: relative; flex: none; }
  .upright input { position: absolute; width: 8rem; left: 50%; top: 50%; transform: translate(-50%, -50%) rotate(-90deg); }

  /* tooltip: after a moment of hovering, never on touch */
  .tip { position: absolute; z-index: 3; background: var(--ink); color: var(--paper); font-size: 0.8125rem; line-height: 1.125rem; padding: 0.375rem 0.625rem; border-radius: 0.5rem; white-space: nowrap; display: flex; gap: 0.5rem; align-items: center; pointer-events: none; opacity: 0; transition: opacity var(--appear) var(--out); }
  .rail .tip { left: calc(100% + 0.75rem); }
  .tray .tip { top: calc(100% + 0.75rem); left: 50%; transform: translateX(-50%); }
  .tray.right .tip { left: auto; right: 0; transform: none; }
  .tip kbd { opacity: 1; }
  :is(.panel, .chip, .notice) .tip { display: none; }
  @media (hover: hover) {
    .b:hover > .tip { opacity: 1; transition-delay: 500ms; }
  }
  .b:focus-visible > .tip { opacity: 1; }
  .rail.named .tip, .b[aria-expanded='true'] > .tip { display: none; }

  /* stroke meter */
  .meter { position: absolute; left: 50%; bottom: var(--gap); transform: translateX(-50%); display: flex; padding: 0.3125rem; gap: 0.125rem; border-radius: 1.25rem; }
  .meter ~ .status { max-width: calc(50cqw - 13.5rem); }
  .meter button { height: 3.25rem; padding: 0 1.125rem 0 0.75rem; border-radius: 0.875rem; display: flex; align-items: center; gap: 0.625rem; color: var(--ink-2); font-weight: 600; position: relative; white-space: nowrap; }
  .meter button:hover { background: var(--sunken); }
  .meter .done { color: var(--ink); }
  .meter [aria-current='step'] { background: var(--pencil-soft); color: var(--pencil); }
  .meter .tick { position: absolute; left: 1.6875rem; top: 1.6875rem; width: 1rem; height: 1rem; border-radius: 50%; background: var(--good); color: var(--surface); display: grid; place-items: center; }
  .meter .tick .icon { width: 0.6875rem; height: 0.6875rem; stroke-width: 3.2; }

  /* keep chip */
  .chip { position: absolute; display: flex; align-items: center; gap: 0.25rem; padding: 0.25rem; border-radius: 1.125rem; box-shadow: var(--e2); transform: translateX(max(5.25rem - var(--x), min(-50%, 100cqw - 1rem - var(--x) - 100%))); z-index: 1; }
  .chip .what { padding: 0 0.875rem 0 0.25rem; white-space: nowrap; }
  .chip .what b { display: block; font-weight: 600; line-height: 1.1875rem; }
  .chip .what small { display: block; font-size: 0.75rem; line-height: 1rem; color: var(--ink-2); }
  .chip .b { border-radius: 0.875rem; }
  .swatch, .swatch .ball { display: block; width: 1.875rem; height: 1.875rem; }
  .chip.narrow .what, .chip.narrow .word { display: none; }

  /* status and view ball */
  .status { position: absolute; left: 1.25rem; bottom: var(--gap); font-size: 0.8125rem; line-height: 1.125rem; color: var(--over-2); display: flex; flex-direction: column; gap: 0.125rem; max-width: 21rem; pointer-events: none; text-shadow: 0 0 2px var(--halo), 0 0 3px var(--halo), 0 0 4px var(--halo), 0 0 6px var(--halo); }
  .status b { color: var(--over); font-weight: 600; }
  .status .fact { white-space: nowrap; }
  .dot { display: inline-block; width: 0.5rem; height: 0.5rem; border-radius: 50%; background: var(--good); margin-right: 0.375rem; }
  .dot.slow { background: var(--warn); }
  .view { position: absolute; right: 1.25rem; bottom: var(--gap); width: 4.75rem; text-align: center; font-size: 0.75rem; line-height: 1rem; color: var(--over-2); touch-action: none; text-shadow: 0 0 2px var(--halo), 0 0 3px var(--halo), 0 0 4px var(--halo); }
  .view svg { text-shadow: none; }
  .view svg { width: 4.75rem; height: 4.75rem; display: block; cursor: grab; overflow: visible; }
  .view text { font: 700 11px var(--font); fill: var(--surface); text-anchor: middle; pointer-events: none; }

  /* notices */
  .notice { position: absolute; left: 50%; top: 5.25rem; width: max-content; transform: translateX(-50%); display: flex; align-items: center; gap: 0.5rem; padding: 0.25rem 0.25rem 0.25rem 1rem; border-radius: 1.125rem; box-shadow: var(--e2); max-width: calc(100% - 2rem); z-index: 2; }
  .notice > .icon { color: var(--warn); }

  /* panels */
  .panel { position: absolute; right: var(--gap); top: 5.25rem; width: 20rem; max-height: calc(100% - 6.25rem); overflow: auto; padding: 0.5rem 0.5rem 0.625rem; box-shadow: var(--e2); z-index: 2; }
  .panel header { display: flex; align-items: center; min-height: 2.75rem; padding-left: 0.5rem; }
  .panel h2 { font: 600 1.0625rem/1.375rem var(--font); flex: 1; }
  .panel section { border-top: 1px solid var(--hairline); margin-top: 0.5rem; padding-top: 0.5rem; }
  .panel h3 { font: 600 0.8125rem/1.125rem var(--font); color: var(--ink-2); display: flex; align-items: center; justify-content: space-between; padding: 0 0.5rem; min-height: 2rem; }
  .panel h3 .value { color: var(--ink); }
  .panel .row { display: flex; align-items: center; justify-content: space-between; width: 100%; min-height: 2.75rem; padding: 0 0.5rem; border-radius: 0.75rem; text-align: left; gap: 0.75rem; }
  .panel .row[aria-disabled='true'] { color: var(--ink-off); cursor: default; }
  .panel button.row:hover { background: var(--sunken); }
  .panel .slide { padding: 0 0.5rem; }
  .panel .slide input { display: block; }
  .panel dl { display: grid; grid-template-columns: auto 1fr; gap: 0.25rem 1rem; padding: 0 0.5rem 0.5rem; align-items: center; }
  .panel dd { margin: 0; color: var(--ink-2); }
  .presets { display: grid; grid-template-columns: repeat(4, 1fr); gap: 0.375rem; padding: 0 0.5rem; }
  .presets .style { flex-direction: column; height: 4.25rem; gap: 0.25rem; padding: 0; background: var(--sunken); }
  .presets .style .ball { width: 1.875rem; height: 1.875rem; }
  .presets .style[aria-checked='true'] { background: var(--surface); box-shadow: inset 0 0 0 2.5px var(--pencil); }
  .panel .style span { display: block; }
  .switch { width: 2.875rem; height: 1.75rem; border-radius: 0.875rem; background: var(--surface); box-shadow: inset 0 0 0 2px var(--edge); position: relative; flex: none; transition: background var(--press); }
  .switch::after { content: ''; position: absolute; left: 4px; top: 4px; width: 1.25rem; height: 1.25rem; border-radius: 50%; background: var(--edge); }
  [aria-checked='true'] > .switch { background: var(--pencil); box-shadow: none; }
  [aria-checked='true'] > .switch::after { left: auto; right: 4px; background: var(--on-pencil); }
  .segment { display: flex; background: var(--sunken); border-radius: 0.75rem; padding: 2px; margin: 0 0.5rem; }
  .segment button { flex: 1; min-height: 2.75rem; border-radius: 0.625rem; font-size: 0.8125rem; color: var(--ink-2); }
  .segment [aria-checked='true'] { background: var(--surface); color: var(--ink); font-weight: 600; box-shadow: 0 0 0 1.5px var(--edge); }
  .dots { display: flex; padding: 0 0.25rem; }
  .dots button { width: 2.75rem; height: 2.75rem; display: grid; place-items: center; border-radius: 50%; position: relative; }
  .dots i { width: 1.75rem; height: 1.75rem; border-radius: 50%; border: 1px solid var(--edge); }
  .dots [aria-checked='true']::after, .spheres [aria-checked='true']::after { content: ''; position: absolute; inset: 1px; border-radius: 50%; border: 3px solid var(--pencil); }
  .spheres { display: grid; grid-template-columns: repeat(6, 1fr); justify-items: center; }
  .spheres button { width: 2.875rem; height: 2.875rem; display: grid; place-items: center; border-radius: 50%; position: relative; }
  .spheres .ball { width: 2.75rem; height: 2.75rem; color: var(--active); }
  .faces { display: grid; grid-template-columns: repeat(3, 1fr); gap: 0.25rem; padding: 0.25rem 0.5rem; }
  .faces .b { font-size: 0.8125rem; }
  .menu { width: 16.5rem; right: var(--gap); }
  .palette { width: 19.5rem; }
  .row small { color: var(--ink-2); }
  .row .icon { color: var(--ink-2); }
  .row .grow { flex: 1; }

  @container (max-width: 1099px) {
    .style span { display: none; }
    .style { padding: 0 0.625rem; }
    .status :is(.facts, .aside.usual) { display: none; }
  }
  @container (max-width: 699px) {
    .app { --gap: 0.5rem; }
    .top { height: 3rem; inset: 0.5rem 0.5rem auto; }
    .tray { height: 3rem; padding: 1px; }
    .styles { position: static; transform: none; }
    .style { padding: 0 0.375rem; min-width: 2.75rem; }
    .top .style:not([aria-checked='true']), .styles .separator, .styles .b { display: none; }
    .rail, .rail.named { left: 0.5rem; right: 0.5rem; top: auto; bottom: calc(0.5rem + env(safe-area-inset-bottom, 0px)); transform: none; width: auto; flex-direction: row; align-items: center; justify-content: space-between; padding: 0.3125rem; }
    .rail hr, .rail .tip, .rail.named .b > kbd { display: none; }
    .rail .b, .rail.named .b { flex-direction: column; height: 3.5rem; gap: 0; padding: 0 0.25rem; font-size: 0.75rem; line-height: 1rem; justify-content: center; min-width: 3.25rem; }
    .rail .name { display: block; }
    .upright { width: auto; height: 2.75rem; flex: 1; min-width: 4rem; }
    .upright input { position: static; width: 100%; transform: none; }
    .rail .caption { min-width: 2.75rem; }
    .meter { bottom: auto; top: 4rem; }
    .meter ~ .status { max-width: 60%; }
    .meter button { height: 2.75rem; }
    .chip { left: 0.5rem !important; right: 0.5rem; transform: none; top: auto !important; bottom: calc(5.25rem + env(safe-area-inset-bottom, 0px)); }
    .chip .what, .chip.narrow .what { display: block; flex: 1; }
    .chip .word { display: none; }
    .status { left: 0.75rem; bottom: calc(5.25rem + env(safe-area-inset-bottom, 0px)); max-width: 60%; }
    /* the card says it; it is still heard */
    :is(.chip, .acts.edit) ~ .status { left: 0; bottom: 0; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
    .view { right: 0.75rem; bottom: calc(9.5rem + env(safe-area-inset-bottom, 0px)); }
    .panel { left: 0.5rem; right: 0.5rem; width: auto; top: auto; bottom: 0; max-height: 70%; border-radius: 1rem 1rem 0 0; }
  }
  @container (max-width: 359px) {
    .top { gap: 0.25rem; }
    .meter.steps button { padding: 0 0.375rem; gap: 0.125rem; min-width: 2.75rem; justify-content: center; }
    .meter.steps button[aria-current] { flex: none; }
    .rail .b, .rail.named .b { min-width: 2.75rem; padding: 0; }
    .rail .upright { min-width: 3rem; }
    .rail .b.toggle .name { width: min-content; line-height: 0.875rem; text-align: center; white-space: normal; }
    /* the colour and the radius take their room */
    .rail:not(.selecting) .b:is([aria-label='Redraw'], [aria-label='Bend']) { display: none; }
  }
  /* between the top bar and the status line */
  @container (max-height: 680px) and (min-width: 700px) {
    .rail { top: calc(50% + 0.5rem); gap: 0.125rem; }
    .rail .upright { height: 5rem; }
    .rail .upright input { width: 5rem; }
  }
  @container (max-height: 560px) and (min-width: 700px) {
    .rail { top: calc(50% + 2rem); max-height: calc(100% - 6rem); overflow-y: auto; scrollbar-width: none; }
    .rail.named { width: 3.75rem; align-items: center; }
    .rail.named .name, .rail.named .b > kbd { display: none; }
    .tray.name { visibility: hidden; }
    .status { left: 5.5rem; }
    .chip ~ .status { display: none; }
  }
  :host([data-theme='contrast']) :is(.b.on, .meter [aria-current], .style[aria-checked='true']) { box-shadow: inset 0 0 0 3px var(--pencil); }
  :host([data-theme='contrast']) :is(.b.quiet, .segment) { box-shadow: inset 0 0 0 1.5px #000; }
  @media (forced-colors: active) {
    .card, .b, .segment button { border: 1px solid ButtonText; }
    .b[aria-pressed='true'], .app [aria-checked='true'] { background: Highlight; color: HighlightText; box-shadow: none; forced-color-adjust: none; }
    .dot { forced-color-adjust: none; }
    /* its track is a gradient, which would be taken away */
    input[type='range'] { forced-color-adjust: none; --surface: Canvas; --ink-2: Highlight; --track: CanvasText; --pencil: Highlight; --e1: none; }
  }
`;
