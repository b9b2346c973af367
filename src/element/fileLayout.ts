/** The file's tray, its panels, and the veil under which files are dropped. */
import { css } from 'lit';

export const fileLayout = css`
  .doc { position: absolute; left: var(--gap); top: var(--gap); z-index: 1; max-width: calc(50% - 14rem); }
  .doc .title { min-width: 0; flex: 0 1 auto; padding: 0 0.75rem 0 0.5rem; gap: 0.375rem; }
  .doc .title b { font-weight: 600; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; max-width: 14rem; }
  .doc .title small { font-size: 0.75rem; color: var(--ink-2); white-space: nowrap; flex: none; }
  .doc .title small.unsaved { color: var(--warn); font-weight: 600; }
  .doc .title[aria-expanded='true'] small { color: inherit; }
  .doc .tip { left: 0; transform: none; }
  .top .right { margin-left: auto; }
  .tray.name b { padding: 0 0.75rem; font-weight: 600; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; max-width: 14rem; }

  .panel:focus { outline: none; }
  .panel.file, .panel.drawings { left: var(--gap); right: auto; }
  .panel.drawings { width: 22rem; }
  .panel.drawings .cards { grid-template-columns: repeat(3, 1fr); gap: 0.5rem; padding: 0 0.5rem 0.375rem; --thumb: 4.25rem; }
  .panel.drawings .cards b { font-size: 0.8125rem; line-height: 1.125rem; }
  .panel.drawings .cards .card { box-shadow: none; }
  .panel .row:has(small) { padding-block: 0.375rem; }
  .panel .row > .grow > small { display: block; font-size: 0.75rem; line-height: 1rem; }
  .panel .row[aria-disabled='true'] { color: var(--ink-off); cursor: default; }
  .panel .row kbd { color: var(--ink-2); }
  .panel .note { padding: 0.25rem 0.5rem; font-size: 0.8125rem; line-height: 1.125rem; color: var(--ink-2); }
  .panel .fact { display: flex; gap: 0.75rem; align-items: center; padding: 0.25rem 0.5rem; font-size: 0.875rem; line-height: 1.25rem; color: var(--ink-2); }
  .panel .fact.so { color: var(--ink); }
  .panel .fact.so .icon { color: var(--good); }
  .field { display: block; padding: 0.25rem 0.5rem 0; }
  .field span { display: block; font: 600 0.8125rem/1.125rem var(--font); color: var(--ink-2); padding-bottom: 0.25rem; }
  .field input { width: 100%; height: 2.75rem; padding: 0 0.75rem; font: inherit; color: inherit; background: var(--sunken); border: 1.5px solid var(--edge); border-radius: 0.75rem; user-select: text; -webkit-user-select: text; }
  .field input::placeholder { color: var(--ink-2); opacity: 1; }

  .progress { position: relative; height: 4px; margin: 0.5rem; border-radius: 2px; background: var(--track); overflow: hidden; }
  .progress::after { content: ''; position: absolute; inset: 0; width: 40%; border-radius: 2px; background: var(--pencil); animation: to-and-fro 1.2s infinite alternate cubic-bezier(0.6, 0, 0.2, 1); }
  @keyframes to-and-fro { to { transform: translateX(150%); } }

  .veil { position: absolute; inset: 0; z-index: 4; padding: 1rem; background: color-mix(in srgb, var(--paper) 80%, transparent); }
  .veil div { height: 100%; display: grid; place-content: center; gap: 0.375rem; text-align: center; border: 3px dashed var(--pencil); border-radius: 1.25rem; background: color-mix(in srgb, var(--pencil-soft) 70%, transparent); color: var(--pencil); pointer-events: none; }
  .veil b { font: 600 1.625rem/2rem var(--font); }
  .veil span { color: var(--ink); }

  @container (max-width: 1099px) {
    .doc { max-width: calc(50% - 9rem); }
  }
  /* in the menu and beside the name, too */
  @container (max-width: 899px) {
    .right .share { display: none; }
  }
  /* a tap on the chosen style opens the settings, too */
  @container (min-width: 700px) and (max-width: 799px) {
    .styles .separator, .styles .b { display: none; }
  }
  @container (max-width: 699px) {
    .notice { left: 0.5rem; right: 0.5rem; top: 4rem; width: auto; max-width: none; transform: none; flex-wrap: wrap; justify-content: flex-end; padding: 0.5rem 0.5rem 0.5rem 1rem; }
    .notice > span { flex: 1 0 calc(100% - 3rem); }
    .doc { max-width: none; }
    .doc .separator, .doc .title, .doc .wordmark { display: none; }
    .doc ~ .top .styles { margin-left: 3.5rem; }
    .panel.file, .panel.drawings { left: 0.5rem; right: 0.5rem; width: auto; }
    .panel.drawings .cards { grid-template-columns: repeat(auto-fill, minmax(6.25rem, 1fr)); }
    .panel .row > kbd { display: none; }
  }
  @container (max-width: 359px) {
    .top .right .separator { display: none; }
  }
  /* the rail scrolls below the file's tray */
  @container (max-height: 560px) and (min-width: 700px) {
    .rail { top: auto; bottom: var(--gap); transform: none; max-height: calc(100% - 6.25rem); }
  }
  @media (prefers-reduced-motion: reduce) {
    .progress::after { animation: none; width: 100%; }
  }
  @media (hover: none) {
    .panel .row > kbd { display: none; }
  }
`;
