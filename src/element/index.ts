/** The element's class, without defining it: safe to import where there is no DOM. */
export { RotundSketch } from './rotundSketch.ts';
