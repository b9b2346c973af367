/** Defines `<rotund-field>`. */
import { RotundField } from './rotundField.ts';

customElements.define('rotund-field', RotundField);

declare global {
  interface HTMLElementTagNameMap {
    'rotund-field': RotundField;
  }
}
