/** The skeleton in the card of a form: shown or not, and as the strokes say again. */
import { html, nothing, type TemplateResult } from 'lit';
import type { Session } from './session.ts';
import { edit, hasSkeleton, selectedSkeleton, toggleSkeleton } from './skeletonEdit.ts';
import { SKELETON_WORDS } from './words.ts';

export function skeletonRow(session: Session): TemplateResult | typeof nothing {
  const at = selectedSkeleton(session);
  if (!at) return nothing;
  const on = hasSkeleton(session);
  return html`<div class="skeleton-row" role="group" aria-label=${SKELETON_WORDS.of(at.group.name)}>
    <button class="b" aria-pressed=${String(on)} @click=${() => toggleSkeleton(session)}>${SKELETON_WORDS.show}</button>
    ${at.group.skeleton ? html`<button class="b" @click=${() => edit(session, at, null)}>${SKELETON_WORDS.asDrawn}</button>` : nothing}
  </div>`;
}
