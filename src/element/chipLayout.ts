/** How the chip lays out what the strokes may become: a row where there is room for it, icons only where there is less, rows of its own on phones. */
import { css } from 'lit';

export const chipLayout = css`
  .chip { flex-wrap: wrap; width: max-content; }
  .chip .forms, .chip .joins { display: flex; gap: 0.125rem; }
  .chip .forms .b, .chip .joins .b { color: var(--ink); font-weight: 600; padding: 0 0.75rem 0 0.5rem; gap: 0.375rem; }
  .chip .forms .b.on, .chip .joins .b.on { color: var(--pencil); background: var(--pencil-soft); }
  .chip .forms { padding-right: 0.375rem; margin-right: 0.25rem; border-right: 1px solid var(--hairline); }
  .chip .joins { flex-basis: 100%; justify-content: center; border-top: 1px solid var(--hairline); padding-top: 0.25rem; }
  .meter .short { display: none; }

  @container (max-width: 1099px) {
    .chip .forms .b { padding: 0; }
    .chip .forms .word { display: none; }
  }
  .chip.narrow { max-width: 19rem; }
  .chip.narrow .forms { border: 0; margin: 0; padding: 0; }
  .chip.narrow :is(.forms, .joins) .b { padding: 0; }
  .chip.narrow .forms .word { display: none; }
  .chip.narrow .joins .b { padding: 0 0.5rem; }
  .chip.narrow .joins .word { display: inline; }

  @container (max-width: 699px) {
    .chip, .chip.narrow { width: auto; max-width: none; }
    .chip .forms, .chip.narrow .forms { order: 1; flex-basis: 100%; justify-content: space-around; border: 0; border-top: 1px solid var(--hairline); margin: 0; padding: 0.25rem 0 0; }
    .chip .forms .b, .chip.narrow .forms .b { flex: 1; max-width: 4.5rem; }
    .chip .joins { order: 2; justify-content: space-around; }
    .chip .joins .b { flex: 1; padding: 0 0.5rem; }
    .chip .joins .word, .chip.narrow .joins .word { display: inline; }
    .meter .long { display: none; }
    .meter .short { display: inline; }
  }
`;
