/** Parts in the hand: their list, their handles, and what can be done with them. */
import { css } from 'lit';

export const partsLayout = css`
  .stage.selecting { cursor: default; }
  .count { font: 600 0.75rem/1.125rem var(--font); background: var(--sunken); color: var(--ink); border-radius: 0.5625rem; padding: 0 0.375rem; min-width: 1.125rem; text-align: center; }
  .b.parts-button { padding: 0 0.625rem; gap: 0.375rem; }
  .b.parts-button[aria-expanded='true'] .count { background: var(--surface); }

  /* handles: the buttons are 44 px, what one sees of them is less */
  .gizmo { position: absolute; left: 0; top: 0; width: 0; height: 0; }
  .gizmo > svg { position: absolute; left: 0; top: 0; width: 1px; height: 1px; overflow: visible; pointer-events: none; }
  .gizmo > svg path { fill: none; stroke-linecap: round; }
  .gizmo .halo { stroke: var(--surface); stroke-width: 7; }
  .gizmo .shaft { stroke: currentColor; stroke-width: 3; }
  .gizmo .shaft.surface { stroke: var(--edge); stroke-width: 2; stroke-dasharray: 1 6; }
  .gizmo .halo:has(+ .surface) { stroke: none; }
  .gizmo .ink-halo { stroke: var(--surface); stroke-width: 4; stroke-linejoin: round; opacity: 0.7; }
  .gizmo .ink { stroke: var(--pencil); stroke-width: 1.75; stroke-linejoin: round; stroke-dasharray: 5 4; }
  .gizmo .ring-halo { fill: none; stroke: var(--surface); stroke-width: 5; }
  .gizmo .ring { fill: none; stroke: var(--edge); stroke-width: 1.75; }
  .gizmo .x { color: var(--axis-x); }
  .gizmo .y { color: var(--axis-y); }
  .gizmo .z { color: var(--axis-z); }
  .handle { position: absolute; width: 2.875rem; height: 2.875rem; margin: -1.4375rem; display: grid; place-items: center; touch-action: none; cursor: grab; border-radius: 50%; }
  .handle:active { cursor: grabbing; }
  .handle[hidden] { display: none; }
  .handle > span { width: 2.375rem; height: 2.375rem; border-radius: 50%; display: grid; place-items: center; border: 3px solid var(--surface); box-shadow: var(--e2); background: currentColor; font: 700 1rem/1 var(--font); }
  .handle:is(.x, .y, .z) > span { -webkit-text-fill-color: var(--surface); }
  .handle.view { border-radius: 0.875rem; }
  .handle.view > span { width: 2.875rem; height: 2.875rem; border-radius: 0.875rem; background: var(--axis-view); color: var(--on-axis-view); }
  .handle:is(.surface, .turn, .scale) > span { width: 2.75rem; height: 2.75rem; background: var(--surface); color: var(--ink); border: 2px solid var(--edge); }
  .handle:is(.turnX, .turnY) > span { width: 2.125rem; height: 2.125rem; background: var(--surface); color: var(--ink); border: 2px solid var(--edge); }
  .handle:hover > span { filter: brightness(1.08); }

  /* actions */
  .acts { position: absolute; left: 50%; bottom: var(--gap); transform: translateX(-50%); display: flex; align-items: center; padding: 0.3125rem; gap: 0.125rem; border-radius: 1.25rem; }
  .acts .b { flex-direction: column; gap: 0.125rem; height: 3.75rem; min-width: 4.5rem; border-radius: 0.875rem; font-size: 0.75rem; line-height: 1rem; }
  .acts .b > .name { display: block; }
  .acts .tip { display: none; }
  .acts ~ .status { max-width: calc(50cqw - 24.5rem); }
  .acts.docked ~ .status .aside { display: none; }
  .acts .swatch, .acts .swatch .ball { width: 1.5rem; height: 1.5rem; }

  /* list and card */
  .panel.parts { display: flex; flex-direction: column; }
  .part-list { overflow-y: auto; overscroll-behavior: contain; flex: none; max-height: max(9.75rem, 42cqh); }
  .part { display: flex; align-items: center; height: 3rem; border-radius: 0.75rem; padding-left: 0.5rem; cursor: pointer; }
  .part:hover { background: var(--sunken); }
  .part-list:focus-visible { outline: none; }
  .part-list:focus-visible .active { outline: 3px solid var(--pencil); outline-offset: -3px; }
  .part .what.indented { padding-left: calc(1.25rem * var(--level) + 1.5rem); position: relative; }
  .part .twist { position: absolute; left: calc(1.25rem * var(--level) - 0.625rem); top: 50%; width: 2.75rem; height: 2.75rem; margin-top: -1.375rem; display: grid; place-items: center; border-radius: 0.75rem; }
  .part-list.dragging { cursor: grabbing; }
  .part-list.dragging .part { cursor: inherit; }
  .part[data-drop='on'] { box-shadow: inset 0 0 0 2px var(--pencil); background: var(--pencil-soft); }
  .part[data-drop='before'] { box-shadow: inset 0 3px 0 -1px var(--pencil); }
  .part[data-drop='after'] { box-shadow: inset 0 -3px 0 -1px var(--pencil); }
  .drag-tag, .value-tag { position: absolute; pointer-events: none; white-space: nowrap; padding: 0.25rem 0.625rem; border-radius: 1rem; background: var(--active); color: var(--on-active); font: 600 0.8125rem/1.125rem var(--font); box-shadow: var(--e2); z-index: 9; }
  .value-tag { transform: translate(1.75rem, -50%); font-variant-numeric: tabular-nums; }
  .part .what { flex: 1; min-width: 0; display: flex; align-items: center; gap: 0.625rem; }
  .part .what > span { min-width: 0; }
  .part b, .part small { display: block; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
  .part b { font-weight: 600; line-height: 1.1875rem; }
  .part small { font-size: 0.75rem; line-height: 1rem; color: var(--ink-2); }
  .part .icon { color: var(--ink-2); }
  .part .b { color: var(--ink-2); }
  .part.unseen b { color: var(--ink-2); font-weight: 500; }
  .part.unseen .what .icon { opacity: 0.55; }
  .part[aria-selected='true'] { background: var(--pencil-soft); }
  .part[aria-selected='true'] :is(b, .what .icon) { color: var(--pencil); }
  .panel input[type='color'] { width: 3rem; height: 2.75rem; padding: 0.5rem 0.375rem; border: 0; background: none; cursor: pointer; }
  .head { display: flex; align-items: center; }
  .head h3 { flex: 1; }
  .head .own { display: flex; align-items: center; font: 600 0.8125rem/1.125rem var(--font); color: var(--ink-2); cursor: pointer; padding-left: 0.5rem; border-left: 1px solid var(--hairline); height: 1.5rem; }
  .in-row { display: flex; align-items: center; }
  .in-row h3 { flex: none; min-width: 5.5rem; }
  .in-row :is(.slide, .segment) { flex: 1; min-width: 0; }
  .in-row .segment { margin-left: 0; }
  .segment + .in-row { margin-top: 0.5rem; }
  .in-row > .value { min-width: 3.25rem; padding-right: 0.5rem; text-align: right; font: 600 0.8125rem/1.125rem var(--font); }
  .panel h3 .value { color: var(--ink); }
  .more summary { display: flex; align-items: center; min-height: 2.75rem; padding: 0 0.5rem; border-radius: 0.75rem; font: 600 0.8125rem/1.125rem var(--font); color: var(--ink-2); cursor: pointer; }
  .more summary::after { content: ''; width: 0.4375rem; height: 0.4375rem; margin: -0.25rem 0.25rem 0 auto; border: solid currentColor; border-width: 0 2px 2px 0; rotate: 45deg; }
  .more[open] summary::after { rotate: 225deg; margin-top: 0.25rem; }
  .more summary:hover { background: var(--sunken); }
  .panel button.row[aria-pressed='true'] { background: var(--pencil-soft); color: var(--pencil); }
  .tiles { display: grid; grid-template-columns: repeat(3, 1fr); gap: 0.5rem; padding: 0 0.5rem 0.25rem; }
  .tile { position: relative; display: grid; min-height: 4.25rem; border-radius: 0.75rem; font-size: 0.8125rem; line-height: 1.125rem; }
  .tile .pick, .tile.add { display: flex; flex-direction: column; align-items: center; justify-content: center; gap: 0.25rem; border-radius: 0.75rem; box-shadow: inset 0 0 0 1.5px var(--hairline); }
  .tile .pick[aria-pressed='true'] { box-shadow: inset 0 0 0 2px var(--pencil); background: var(--pencil-soft); }
  .tile.add { border: 1.5px dashed var(--edge); box-shadow: none; }
  .tile :is(.pick:hover), .tile.add:hover { background: var(--sunken); }
  .tile .off { position: absolute; right: -0.625rem; top: -0.625rem; background: none; }
  .tile .off .icon { width: 1.25rem; height: 1.25rem; padding: 0.1875rem; border-radius: 50%; background: var(--surface); box-shadow: 0 0 0 1.5px var(--edge); color: var(--ink-2); }
  .outline { width: 3.5rem; height: 2.125rem; fill: none; stroke: currentColor; stroke-linecap: round; stroke-linejoin: round; }
  .outline .front { stroke-width: 2; }
  .outline .back { stroke-width: 1.25; opacity: 0.6; }
  .outline .chord { stroke-width: 1.5; stroke-dasharray: 2 4; }
  .segment.pictured button { display: flex; align-items: center; justify-content: center; gap: 0.375rem; white-space: nowrap; flex: 1 1 auto; }
  .bends { list-style: none; margin: 0.25rem 0 0; padding: 0; }
  .bends li { display: flex; align-items: center; min-height: 2.75rem; padding-left: 0.5rem; }
  .bends li > b { flex: 1; font-weight: 600; white-space: nowrap; }
  .bends li .b { color: var(--ink-2); }
  .bends li.unseen > b { color: var(--ink-2); font-weight: 500; }
  .bends li + li { margin-top: 0.25rem; }
  .bends .length { width: auto; padding: 0 0.75rem; height: 2.75rem; font: 600 0.75rem/1rem var(--font); white-space: nowrap; }
  .detail { display: flex; align-items: center; border-top: 1px solid var(--hairline); margin-top: 0.5rem; padding-top: 0.25rem; }
  .detail > div { flex: 1; }
  .panel .detail h3 { color: var(--ink); font-size: 0.9375rem; min-height: 1.5rem; }
  .detail small { display: block; padding: 0 0.5rem; font-size: 0.8125rem; line-height: 1.125rem; color: var(--ink-2); }
  .quiet-words { padding: 0.5rem; color: var(--ink-2); font-size: 0.8125rem; line-height: 1.125rem; }
  .name-field { display: flex; align-items: center; gap: 0.75rem; padding: 0 0.5rem; font: 600 0.8125rem/1.125rem var(--font); color: var(--ink-2); }
  .name-field input { flex: 1; min-width: 0; height: 2.75rem; padding: 0 0.75rem; border: 1.5px solid var(--edge); border-radius: 0.75rem; background: var(--surface); color: var(--ink); font: 600 0.9375rem/1.3125rem var(--font); user-select: text; -webkit-user-select: text; }
  .choice { min-width: 0; max-width: 11rem; height: 2.75rem; padding: 0 0.5rem; border: 1.5px solid var(--edge); border-radius: 0.75rem; background: var(--surface); color: var(--ink); font: 600 0.875rem/1.25rem var(--font); text-overflow: ellipsis; }
  .panel label.row:has(.choice) { margin-top: 0.5rem; }
  .panel label.row:has(.choice) > span { font: 600 0.8125rem/1.125rem var(--font); color: var(--ink-2); }
  .segment.forms button { display: flex; flex-direction: column; align-items: center; justify-content: center; gap: 0.125rem; min-height: 3.25rem; font-size: 0.75rem; line-height: 1rem; }

  .chip { width: max-content; }
  .chip .what.problem { display: flex; gap: 0.5rem; align-items: center; }
  .chip .problem .icon { color: var(--warn); }

  @container (min-width: 1100px) {
    .acts.docked { left: calc(50% - 10.5rem); }
    .acts.docked ~ .status { max-width: calc(50cqw - 31.5rem); }
  }
  @container (min-width: 700px) and (max-width: 1099px) {
    .acts.docked { left: calc(50% - 10.5rem); }
    .acts.docked .b { min-width: 3rem; padding: 0 0.25rem; }
    .acts.docked .elsewhere { display: none; }
    .acts ~ .status { bottom: calc(var(--gap) + 5rem); max-width: 50%; }
    .acts ~ .view { bottom: calc(var(--gap) + 5rem); }
  }
  @container (min-width: 700px) and (max-width: 899px) {
    .acts:not(.edit, .docked) { left: calc(50% + 2.375rem); width: max-content; }
    .acts:not(.edit, .docked) .b { min-width: 3.25rem; padding: 0 0.25rem; }
  }
  @container (min-width: 1100px) and (max-width: 1399px) {
    .acts.docked ~ .status { bottom: calc(var(--gap) + 5rem); max-width: 40%; }
  }
  @container (max-width: 699px) {
    .chip { width: auto; }
    .rail.selecting { justify-content: flex-start; }
    .rail.selecting .toggle { margin-left: auto; }
    .acts { left: 0.5rem; right: 0.5rem; transform: none; bottom: calc(5.25rem + env(safe-area-inset-bottom, 0px)); justify-content: space-between; }
    .acts .b { min-width: 2.75rem; flex: 1 1 auto; padding: 0 0.125rem; }
    .acts :is(.elsewhere:not(.least), .railed) { display: none; }
    .acts .separator { display: none; }
    .acts ~ .status { max-width: 60%; bottom: calc(10rem + env(safe-area-inset-bottom, 0px)); }
    .acts ~ .view { bottom: calc(10rem + env(safe-area-inset-bottom, 0px)); }
    .panel.parts { max-height: 50%; overflow-y: auto; }
    .part-list { max-height: 9.75rem; }
    .b.parts-button { padding: 0 0.25rem; }
  }
  @container (max-width: 359px) {
    .acts .elsewhere { display: none; }
  }
  @container (max-width: 400px) {
    .rail .caption, .tray.right .separator { display: none; }
    .rail .b, .rail.named .b { min-width: 2.75rem; }
  }
  :host([data-theme='contrast']) :is(.part[aria-selected='true']) { box-shadow: inset 0 0 0 3px var(--pencil); }
  @media (forced-colors: active) {
    .handle > span { border: 2px solid ButtonText; }
    .part[aria-selected='true'] { background: Highlight; forced-color-adjust: none; }
    .part[aria-selected='true'] :is(b, small, .icon, .what .icon, .b) { color: HighlightText; }
    .part[aria-selected='true'] .b:hover { background: none; }
    .tile .pick { border: 1px solid ButtonText; }
    .tile .off { border: 0; }
  }
`;
