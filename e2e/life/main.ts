/** A page on which elements come and go, and what of them is left: scenes not yet collected, frames asked for. */
import '../../src/element/define.ts';
import type { RotundSketch } from '../../src/element/index.ts';

declare global {
  interface Window {
    /** Puts an element with a drawing on the page; resolves when its picture is there. */
    mount(backend: 'auto' | 'webgl2'): Promise<RotundSketch>;
    /** Takes it away; resolves when what it had is given back. */
    unmount(sketch: RotundSketch): Promise<void>;
    /** so many times, one after the other; calls back after each */
    comeAndGo(times: number, backend: 'auto' | 'webgl2', after: () => void): Promise<void>;
    /** scenes that were shown and are still in memory */
    scenesInMemory(): number;
    keeper: RotundSketch;
  }
}

const scenes: WeakRef<object>[] = [];

const line = (x: number, bulge: number) =>
  Array.from({ length: 25 }, (_, i) => [x + bulge * Math.sin((Math.PI * i) / 24), 60 - 5 * i] as const);

window.mount = async (backend) => {
  const sketch = document.createElement('rotund-sketch');
  sketch.controls = 'none';
  sketch.backend = backend;
  sketch.addStroke({ points: line(-30, -10) });
  sketch.addStroke({ points: line(0, 10) });
  sketch.run({ type: 'keep' });
  sketch.addStroke({ points: line(40, 5) });
  const ready = new Promise((resolve) => sketch.addEventListener('ready', resolve, { once: true }));
  document.body.append(sketch);
  await ready;
  scenes.push(new WeakRef(sketch.session.scene!));
  return sketch;
};

window.unmount = async (sketch) => {
  sketch.remove();
  // A task later everything that follows from it has happened.
  await new Promise((done) => setTimeout(done));
};

window.comeAndGo = async (times, backend, after) => {
  for (let i = 0; i < times; i++) {
    await window.unmount(await window.mount(backend));
    after();
  }
};

window.scenesInMemory = () => scenes.filter((scene) => scene.deref()).length;
