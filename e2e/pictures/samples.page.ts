/** Files as pictures, without the application: a drawing's text in, a PNG's data address out. */
import { makeBody } from '../../src/document/bodies.ts';
import { solids } from '../../src/document/build.ts';
import type { Drawing } from '../../src/document/drawing.ts';
import { bodiesOf } from '../../src/document/fieldParts.ts';
import { parse } from '../../src/document/serialize.ts';
import { createScene, type Look, type Scene } from '../../src/scene/index.ts';
import type { View } from '../../src/stroke/stroke.ts';

export interface Wanted {
  /** what is in the file */
  readonly text: string;
  readonly look?: Partial<Look>;
  readonly view?: Partial<View>;
  /** CSS pixels */
  readonly size: readonly [width: number, height: number];
  readonly pixelRatio: number;
}

declare global {
  interface Window {
    drawFile(wanted: Wanted): Promise<string>;
  }
}

const canvas = document.body.appendChild(document.createElement('canvas'));
let opened: Promise<Scene> | undefined;
/** Forms are cached by reference: a file that is drawn again is not read again. */
let last: { readonly text: string; readonly drawing: Drawing } | undefined;

/** Lines at twice the resolution of a thumbnail before it is shrunk, on a software adapter too. */
const LINE_TEXELS = 7e6;

window.drawFile = async ({ text, look, view, size, pixelRatio }) => {
  opened ??= createScene(canvas, { lineTexels: LINE_TEXELS });
  const scene = await opened;
  if (last?.text !== text) last = { text, drawing: parse(text, 'sample') };
  const { drawing } = last;
  for (const { node } of bodiesOf(drawing.document)) makeBody(node);
  const [width, height] = size;
  scene.resize(width, height, pixelRatio);
  scene.sync(
    solids(drawing.document).map(({ id, mesh, colour, finish }) => ({
      id,
      mesh,
      colour,
      finish,
      preview: false,
    })),
  );
  scene.setLook({ ...drawing.look, ...look });
  scene.rig.setView({ ...drawing.view, ...view }, false);
  const copy = document.createElement('canvas');
  copy.width = canvas.width;
  copy.height = canvas.height;
  // In the task that drew it the canvas still holds its picture.
  scene.render();
  copy.getContext('2d')?.drawImage(canvas, 0, 0);
  return copy.toDataURL('image/png');
};
