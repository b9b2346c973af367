/** The document as shown: with the stroke under the pen, or as a slider would make it; made once for a state and a document. */
import type { Document } from '../document/document.ts';
import { roughly } from '../document/draftPart.ts';
import type { Bench, State } from '../tool/tool.ts';

export class Preview {
  #last: { readonly state: State; readonly document: Document; readonly shown: Document } | null = null;

  of(state: State, bench: Bench): Document {
    const { document } = bench;
    if (this.#last?.state === state && this.#last.document === document) return this.#last.shown;
    const preview = state.preview?.(bench) ?? document;
    const isOld = preview.draft === document.draft && preview.brush === document.brush;
    const shown = isOld ? preview : roughly(preview);
    this.#last = { state, document, shown };
    return shown;
  }
}
