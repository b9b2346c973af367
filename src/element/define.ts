/** Defines `<rotund-sketch>`, once, where custom elements exist. */
import { RotundSketch } from './rotundSketch.ts';

if (globalThis.customElements && !customElements.get('rotund-sketch'))
  customElements.define('rotund-sketch', RotundSketch);

declare global {
  interface HTMLElementTagNameMap {
    'rotund-sketch': RotundSketch;
  }
}
