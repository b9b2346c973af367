/** How the chip lays out what the strokes may become: a row where there is room for it, icons only where there is less, rows of its own on phones. */
import { css } from 'lit';

export const chipLayout = css`
  .chip { flex-direction: column; align-items: stretch; width: max-content; }
  .chip .main { display: flex; align-items: center; gap: 0.25rem; }
  .chip .forms, .chip .joins { display: flex; gap: 0.125rem; }
  .chip :is(.forms, .joins) .b { color: var(--ink); font-weight: 600; padding: 0 0.75rem 0 0.5rem; gap: 0.375rem; }
  .chip :is(.forms, .joins) .b.on { color: var(--pencil); background: var(--pencil-soft); }
  .chip .forms { padding-right: 0.375rem; margin-right: 0.25rem; border-right: 1px solid var(--hairline); }
  .chip .strokes { flex-wrap: wrap; }
  .chip .joins { justify-content: center; border-top: 1px solid var(--hairline); padding-top: 0.25rem; }
  .meter .short { display: none; }

  @container (max-width: 1099px) {
    .chip .forms .b { padding: 0; }
    .chip .forms .word { display: none; }
    .chip .backs .b { padding: 0 0.75rem 0 0.5rem; }
    .chip .backs .word { display: inline; }
    .chip.narrow .backs .b { padding: 0; }
  }
  .chip.narrow { max-width: 19rem; }
  .chip.narrow .main { flex-wrap: wrap; }
  .chip.narrow .main > .text { flex: 1 1 auto; }
  .chip.narrow .main > .text .word { display: inline; }
  /* a row of their own below drop and keep */
  .chip.narrow .forms { order: 1; flex: none; width: 100%; justify-content: space-around; border: 0; border-top: 1px solid var(--hairline); margin: 0; padding: 0.25rem 0 0; }
  .chip.narrow .forms .b { flex: 1; padding: 0; }
  .chip.narrow .forms .word { display: none; }
  .chip.narrow .joins .b { padding: 0 0.5rem; }
  .chip.narrow .joins .word { display: inline; }

  @container (max-width: 699px) {
    .chip, .chip.narrow { width: auto; max-width: none; }
    .chip .main { flex-wrap: wrap; }
    .chip.narrow .main > .text { flex: none; }
    .chip.narrow .main > .text .word { display: none; }
    .chip .forms { order: 1; flex: none; width: 100%; justify-content: space-around; border: 0; border-top: 1px solid var(--hairline); margin: 0; padding: 0.25rem 0 0; }
    .chip .forms .b, .chip.narrow .forms .b { flex: 1; max-width: 4.5rem; }
    .chip .backs .b, .chip.narrow .backs .b { max-width: none; gap: 0.375rem; }
    .chip .backs .word, .chip.narrow .backs .word { display: inline; }
    .chip .joins .b { flex: 1; padding: 0 0.5rem; }
    .chip .joins .word { display: inline; }
    .meter .long { display: none; }
    .meter .short { display: inline; }
    .chip:is(:has(.forms), :has(.joins)) ~ .view { bottom: calc(12.75rem + env(safe-area-inset-bottom, 0px)); }
    .chip:has(.forms):has(.joins) ~ .view { bottom: calc(16rem + env(safe-area-inset-bottom, 0px)); }
  }
  @container (max-width: 359px) {
    .meter button { padding: 0 0.5rem; gap: 0.375rem; }
    /* its words wrap, not what is done with it */
    .chip .what, .chip.narrow .what { flex: 1 1 0; min-width: 0; padding-right: 0; white-space: normal; }
    .chip .what small { line-height: 0.9375rem; }
    .chip:is(:has(.forms), :has(.joins)) ~ .view { bottom: calc(13.75rem + env(safe-area-inset-bottom, 0px)); }
    .chip:has(.forms):has(.joins) ~ .view { bottom: calc(17rem + env(safe-area-inset-bottom, 0px)); }
    .chip .main > .text { padding: 0 0.75rem; }
    .chip .backs .b, .chip.narrow .backs .b { font-size: 0.875rem; white-space: nowrap; gap: 0.25rem; }
  }
`;
