/** The card of a tool that draws over a form: at the lower edge, where the actions are. */
import { css } from 'lit';

export const editLayout = css`
  .edit { gap: 0.5rem; padding: 0.375rem; box-shadow: var(--e2); z-index: 1; width: max-content; max-width: calc(100% - 2 * var(--gap)); }
  .edit .what { display: flex; align-items: center; gap: 0.625rem; padding: 0 0.75rem 0 0.625rem; white-space: nowrap; }
  .edit .what b { font-weight: 600; }
  .acts.edit .b { flex-direction: row; height: 2.75rem; min-width: 2.75rem; font-size: inherit; line-height: inherit; gap: 0.375rem; padding: 0 0.75rem; }
  .edit .segment { margin: 0; }
  .edit .segment button { padding: 0 0.875rem; white-space: nowrap; }
  @container (max-width: 699px) {
    .acts.edit { width: auto; flex-wrap: wrap; justify-content: flex-end; }
    .edit .what { flex: 1 1 0; min-width: 0; min-height: 2.75rem; white-space: normal; }
    .edit .what b { line-height: 1.1875rem; }
    .acts.edit .b { flex: 0 0 auto; padding: 0 0.75rem; }
    .acts.edit :is(.word, .b > .name) { display: none; }
    .edit .segment { order: 1; flex: 1 0 100%; }
    .edit .segment button { padding: 0 0.25rem; }
    .acts.edit ~ .view { bottom: calc(12.75rem + env(safe-area-inset-bottom, 0px)); }
  }
`;
