/** Where things are on the field page: a dock beside the picture, a sheet below it where that is narrow. */
import { css } from 'lit';

export const fieldLayout = css`
  :host { height: 100%; }
  .app { --dock: 22rem; }
  .stage { cursor: grab; }
  .stage:active { cursor: grabbing; }
  .top { right: calc(var(--dock) + 2 * var(--gap)); }
  .radios { display: flex; gap: inherit; }
  .title { padding: 0 1rem 0 0; gap: 0; font-weight: 600; }
  .title .wordmark { margin-right: 0.5rem; }
  .dock { position: absolute; right: var(--gap); top: var(--gap); bottom: var(--gap); width: var(--dock); display: flex; flex-direction: column; overflow: hidden; box-shadow: var(--e2); z-index: 2; }
  .dock > header { display: flex; align-items: center; gap: 0.25rem; padding: 0.25rem 0.25rem 0.25rem 1rem; border-bottom: 1px solid var(--hairline); flex: none; }
  .dock h2 { font: 600 1.0625rem/1.375rem var(--font); flex: 1; }
  .dock .scroll { overflow-y: auto; overscroll-behavior: contain; padding: 0 0.5rem 1rem; flex: 1; scrollbar-width: thin; scrollbar-color: var(--track) transparent; }
  .dock .tip { top: calc(100% + 0.5rem); right: 0; }
  .fold { display: none; }
  .dock section { padding: 0.5rem 0 0.75rem; }
  .dock section + section { border-top: 1px solid var(--hairline); }
  .dock h3 { font: 600 0.9375rem/1.3125rem var(--font); padding: 0.375rem 0.5rem; }
  .dock h4, .number label, .pull label { font: 0.8125rem/1.125rem var(--font); color: var(--ink-2); }
  .dock h4 { padding: 0.75rem 0.5rem 0.375rem; }
  .note { padding: 0.5rem 0.5rem 0; font-size: 0.8125rem; line-height: 1.125rem; color: var(--ink-2); }

  .number { display: grid; grid-template-columns: 1fr auto; align-items: baseline; padding: 0.625rem 0.5rem 0; }
  .number .value { font: 600 0.8125rem/1.125rem var(--font); }
  .number input { grid-column: 1 / -1; }
  .pull { display: grid; gap: 0.25rem; padding: 0.75rem 0.5rem 0; }
  select { appearance: none; font: inherit; color: inherit; width: 100%; min-height: 2.75rem; padding: 0 2.5rem 0 0.75rem; border: 1.5px solid var(--edge); border-radius: 0.75rem; text-overflow: ellipsis; background: var(--surface); cursor: pointer; }
  .pull { position: relative; }
  .pull::after { content: ''; position: absolute; right: 1.5rem; bottom: 1.25rem; width: 0.5rem; height: 0.5rem; border: solid var(--ink-2); border-width: 0 2px 2px 0; transform: rotate(45deg); pointer-events: none; }
  .dock h4 + .segment { margin-top: 0.25rem; }
  .tiles + .segment { margin-top: 0.5rem; }

  .tiles { display: grid; grid-template-columns: repeat(var(--columns), 1fr); gap: 0.375rem; padding: 0 0.5rem; }
  .tiles button { min-height: 2.75rem; border-radius: 0.75rem; background: var(--sunken); display: flex; flex-direction: column; align-items: center; justify-content: center; font-size: 0.8125rem; line-height: 1.125rem; color: var(--ink-2); padding: 0.25rem; }
  .tiles button:has(svg) { min-height: 4rem; }
  .tiles [aria-checked='true'] { background: var(--surface); box-shadow: inset 0 0 0 2.5px var(--pencil); color: var(--ink); font-weight: 600; }
  .pictogram { width: 2.25rem; height: 2.25rem; fill: none; stroke: currentColor; stroke-width: 2; stroke-linecap: round; stroke-linejoin: round; display: block; }
  .pictogram.filled { fill: var(--track); fill-rule: evenodd; }
  .pictogram .faint { stroke: var(--edge); stroke-width: 1; }

  .status { max-width: calc(100% - var(--dock) - 9rem); }
  .view { right: calc(var(--dock) + 2 * var(--gap)); }
  .bar { width: 10rem; height: 3px; border-radius: 2px; background: var(--track); overflow: hidden; visibility: hidden; }
  .bar.on { visibility: visible; }
  .bar i { display: block; height: 100%; background: var(--pencil); }
  .notice { position: static; width: auto; max-width: none; max-height: 50%; overflow-y: auto; transform: none; flex: none; align-items: flex-start; gap: 0.75rem; padding: 0.25rem 0.25rem 0.25rem 1rem; border-radius: 0; border-top: 1px solid var(--hairline); box-shadow: none; font-size: 0.8125rem; line-height: 1.125rem; overflow-wrap: anywhere; user-select: text; -webkit-user-select: text; }
  .notice > :not(button) { margin: 0.625rem 0; }
  .notice > span { flex: 1; }

  @container (max-width: 1199px) {
    .app { --dock: 19rem; }
    .style span { display: none; }
    .style { padding: 0 0.625rem; }
  }
  @container (max-width: 799px) {
    .title { padding: 0; }
    .title b { display: none; }
  }
  @container (max-width: 699px) {
    .app { --dock: 0px; }
    .top { right: 0.5rem; }
    .title .wordmark { margin: 0 0.75rem; width: 4.25rem; }
    .top .style:not([aria-checked='true']) { display: flex; }
    .style { padding: 0 0.5rem; }
    .dock { left: 0; right: 0; bottom: 0; top: auto; width: auto; height: 46%; border-radius: 1.25rem 1.25rem 0 0; padding-bottom: env(safe-area-inset-bottom, 0px); border-width: 1px 0 0; }
    .dock.folded { height: calc(3.25rem + 1px + env(safe-area-inset-bottom, 0px)); }
    .dock.folded :is(.scroll, .notice) { display: none; }
    .fold { display: inline-flex; }
    .fold .icon { transition: transform var(--appear) var(--out); }
    .folded .fold .icon { transform: rotate(180deg); }
    .status { left: 0.75rem; bottom: calc(46% + 0.5rem); max-width: calc(100% - 7rem); font-size: 0.75rem; line-height: 1rem; }
    .view { right: 0.75rem; bottom: calc(46% + 0.5rem); }
    .folded ~ .status, .folded ~ .view { bottom: 4rem; }
  }
  @container (max-width: 359px) {
    .title, .work { display: none; }
    .top { justify-content: center; }
  }
  @container (max-height: 560px) and (min-width: 700px) {
    .status { left: 1.25rem; }
  }
  :host([data-theme='contrast']) .tiles button:not([aria-checked='true']) { box-shadow: inset 0 0 0 1.5px #000; }
  @media (forced-colors: active) {
    .tiles button, .bar.on { border: 1px solid ButtonText; }
    .tiles [aria-checked='true'] { background: Highlight; color: HighlightText; box-shadow: none; }
    .pictogram.filled { fill: none; }
    .bar i { background: Highlight; }
  }
`;
