/** The scene without the application: draws what a test asks for and hands back the pixels. */
import {
  createScene,
  DEFAULT_LOOK,
  FRONT_VIEW,
  type Hit,
  type Look,
  type Scene,
  type SceneItem,
  type Style,
} from '../../src/scene/index.ts';
import type { View } from '../../src/stroke/stroke.ts';
import { openDeviceStage } from './device.ts';
import { openExactStage } from './exact.ts';
import { type Form, makeMesh } from './meshes.ts';

export interface Thing {
  readonly form: Form;
  readonly colour?: string;
  readonly preview?: boolean;
}

export interface Picture {
  readonly things: readonly Thing[];
  readonly look?: Partial<Look>;
  readonly view?: Partial<View>;
  /** CSS pixels */
  readonly size?: readonly [width: number, height: number];
  readonly pixelRatio?: number;
  readonly backend?: 'auto' | 'webgl2';
}

export interface Timing {
  /** ms a frame, until the device is done with it */
  readonly median: number;
  readonly least: number;
  readonly backend: string;
  readonly drawCalls: number;
  readonly triangles: number;
}

declare global {
  interface Window {
    /** Data address of a PNG with one pixel a device pixel. */
    drawPicture(picture: Picture): Promise<string>;
    /** Pictures for files, all asked for in one task, while `shown` is on the screen: data addresses of PNGs. */
    takePictures(shown: Picture, wanted: readonly Picture[]): Promise<readonly string[]>;
    createScene: typeof createScene;
    backendOf(wanted: 'auto' | 'webgl2'): Promise<string>;
    pickIn(picture: Picture, x: number, y: number): Promise<Hit | null>;
    /** Frame times of the pear at 800 × 600 CSS pixels. */
    benchFrame(style: Style, frames: number, pixelRatio?: number): Promise<Timing>;
  }
}

// ?fine: lines at twice the resolution on a software adapter too, for pictures to look at
const FINE = location.search === '?fine' ? { lineTexels: 9e6 } : {};

const scenes = new Map<string, Promise<{ scene: Scene; canvas: HTMLCanvasElement }>>();

function open(backend: 'auto' | 'webgl2') {
  let opened = scenes.get(backend);
  if (!opened) {
    const canvas = document.body.appendChild(document.createElement('canvas'));
    opened = createScene(canvas, { backend, ...FINE }).then((scene) => ({ scene, canvas }));
    scenes.set(backend, opened);
  }
  return opened;
}

const items = (picture: Picture): SceneItem[] =>
  picture.things.map(({ form, colour, preview }, i) => ({
    id: String(i),
    mesh: makeMesh(form),
    colour: colour ?? '#d9cb4a',
    preview: preview ?? false,
  }));
const sizeOf = ({ size = [300, 300] }: Picture) => size;
const lookOf = ({ look }: Picture): Look => ({ ...DEFAULT_LOOK, ...look });
const viewOf = ({ view }: Picture): View => ({ ...FRONT_VIEW, ...view });

async function setUp(picture: Picture) {
  const { scene, canvas } = await open(picture.backend ?? 'auto');
  const [width, height] = sizeOf(picture);
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  scene.resize(width, height, picture.pixelRatio ?? 1);
  scene.sync(items(picture));
  scene.setLook(lookOf(picture));
  scene.rig.setView(viewOf(picture), false);
  return { scene, canvas };
}

function png(width: number, height: number, draw: (context: CanvasRenderingContext2D) => void): string {
  const copy = document.createElement('canvas');
  copy.width = width;
  copy.height = height;
  const context = copy.getContext('2d');
  if (!context) throw new Error('no 2D canvas');
  draw(context);
  return copy.toDataURL('image/png');
}

window.createScene = createScene;
window.openDeviceStage = openDeviceStage;
window.openExactStage = openExactStage;

window.drawPicture = async (picture) => {
  const { scene, canvas } = await setUp(picture);
  return png(canvas.width, canvas.height, (context) => {
    // In the task that drew it the canvas still holds its picture.
    scene.render();
    context.drawImage(canvas, 0, 0);
  });
};

window.takePictures = async (shown, wanted) => {
  const { scene } = await setUp(shown);
  const taken = wanted.map(async (picture) => {
    const [width, height] = sizeOf(picture);
    const options = { width, height, view: viewOf(picture), look: lookOf(picture), items: items(picture) };
    const image = await scene.picture(options);
    return png(width, height, (context) => context.putImageData(image, 0, 0));
  });
  return Promise.all(taken);
};

window.backendOf = async (wanted) => (await open(wanted)).scene.backend;

window.pickIn = async (picture, x, y) => {
  const { scene } = await setUp(picture);
  return scene.pick(x, y);
};

window.benchFrame = async (style, frames, pixelRatio = 1) => {
  const { scene } = await setUp({
    things: [{ form: { kind: 'pear' } }, { form: { kind: 'stem' } }, { form: { kind: 'leaf' } }],
    look: { style },
    size: [800, 600],
    pixelRatio,
  });
  await scene.compile();
  const times: number[] = [];
  for (let i = 0; i < frames; i++) {
    scene.rig.orbit(3, 0);
    const start = performance.now();
    await scene.compile();
    times.push(performance.now() - start);
  }
  times.sort((a, b) => a - b);
  return {
    median: times[times.length >> 1] ?? 0,
    least: times[0] ?? 0,
    backend: scene.backend,
    drawCalls: scene.drawCalls,
    triangles: scene.triangles,
  };
};
