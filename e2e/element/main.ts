/** Somebody’s page: it decides when the element is defined, and notes what it hears from it. */
import type { RotundSketch } from '../../src/element/index.ts';

declare global {
  interface Window {
    define(): Promise<unknown>;
    /** `type detail`, in the order of arrival */
    heard: string[];
    listen(sketch: EventTarget): void;
    /** three strokes: a tube and a solid of revolution, 120 mm high */
    drawForm(sketch: RotundSketch): void;
  }
}

window.define = () => import('../../src/element/define.ts');
window.heard = [];

window.listen = (sketch) => {
  const note = (type: string, read: (event: CustomEvent) => unknown) =>
    sketch.addEventListener(type, (event) => window.heard.push(`${type} ${read(event as CustomEvent)}`));
  note('ready', () => '');
  note('change', ({ detail }) => `${detail.cause} ${detail.commands.map((c: { type: string }) => c.type)}`);
  note('select', ({ detail }) => detail.ids);
  note('error', ({ detail }) => detail.message);
};

window.drawForm = (sketch) => {
  const line = (x: number, bulge: number) =>
    Array.from({ length: 25 }, (_, i) => [x + bulge * Math.sin((Math.PI * i) / 24), 60 - 5 * i] as const);
  sketch.addStroke({ points: line(50, 8) });
  sketch.run({ type: 'keep' });
  sketch.addStroke({ points: line(-20, -20) });
  sketch.addStroke({ points: line(0, 20) });
  sketch.run({ type: 'keep' });
};
