/**
 * Our device, or a WebGL2 context → three's renderer. three falls back from the one to the other silently; here the
 * choice is made before three is asked, and that it uses the other one is an error.
 *
 * The renderer's output colour space is set to its working space: three then converts nothing, and a display value
 * written by a shader is the value on the screen.
 */
import { LinearSRGBColorSpace, NoToneMapping, WebGPURenderer } from 'three/webgpu';
import { type DeviceDescription, type OpenedDevice, openDevice } from '../gpu/device.ts';

export type Backend = 'WebGPU' | 'WebGL2';

export interface SceneRenderer {
  readonly renderer: WebGPURenderer;
  readonly backend: Backend;
  /** null on WebGL2 */
  readonly device: GPUDevice | null;
  readonly description: DeviceDescription | null;
  /** why there is no WebGPU; null when there is */
  readonly fallbackReason: string | null;
  /** the longest side of a texture, texels */
  readonly maxSide: number;
  /** Resolves, with the reason, when the device or the WebGL context is gone. */
  readonly lost: Promise<string>;
  /** the reason, once it is gone */
  readonly gone: string | null;
  /** Rejects where the device could not do what the work asked of it, or was lost before its end. */
  watched<T>(work: () => Promise<T>): Promise<T>;
  /** Resolves when everything drawn so far is done. */
  finished(): Promise<void>;
  dispose(): void;
}

/** There is neither back end: another try with WebGL2 is of no use. */
export class NoGraphicsError extends Error {
  override readonly name = 'NoGraphicsError';
}

const CONTEXT_LOST = 'the WebGL context was lost';

/** `because` is why WebGL2 is wanted. */
export async function createRenderer(
  canvas: HTMLCanvasElement,
  wanted: 'auto' | 'webgl2',
  because = 'WebGL2 was asked for',
): Promise<SceneRenderer> {
  const opened = wanted === 'auto' ? await openDevice(navigator.gpu) : { reason: because };
  if ('reason' in opened) return onWebGL(canvas, opened.reason);
  try {
    return await onDevice(canvas, opened);
  } catch (error) {
    opened.release();
    throw error;
  }
}

async function onDevice(canvas: HTMLCanvasElement, opened: OpenedDevice): Promise<SceneRenderer> {
  const { device } = opened;
  const renderer = newRenderer(canvas, { device });
  // three would listen for the loss as long as the device lives, which is longer than most renderers are needed.
  Object.defineProperty(device, 'lost', { value: new Promise(() => {}), configurable: true });
  try {
    await renderer.init();
  } finally {
    Reflect.deleteProperty(device, 'lost');
  }
  const { backend } = renderer as unknown as { readonly backend: { readonly isWebGPUBackend?: boolean } };
  if (!backend.isWebGPUBackend) throw new Error('three.js could not use the WebGPU device');
  // three's own answer would keep the renderer, and so would one that is made here.
  device.onuncapturederror = complain;
  quiet(renderer);
  let gone: string | null = null;
  void opened.lost.then((reason) => {
    gone = reason;
  });
  return {
    renderer,
    backend: 'WebGPU',
    device,
    description: opened.description,
    fallbackReason: null,
    maxSide: device.limits.maxTextureDimension2D,
    lost: opened.lost,
    get gone() {
      return gone;
    },
    watched: async (work) => {
      const result = await scoped(device, work);
      if (gone !== null) throw new Error(gone);
      return result;
    },
    finished: async () => void (await device.queue.onSubmittedWorkDone()),
    dispose: () =>
      afterDispose(renderer, () => {
        canvas.getContext('webgpu')?.unconfigure();
        opened.release();
      }),
  };
}

async function onWebGL(canvas: HTMLCanvasElement, reason: string): Promise<SceneRenderer> {
  // Asked for here, with three's own wishes, because three does not notice that there is none.
  const gl = canvas.getContext('webgl2', { alpha: true, antialias: false, depth: false, stencil: false });
  if (!gl) throw new NoGraphicsError(`The browser gives no WebGL2 context, and no WebGPU: ${reason}.`);
  const renderer = newRenderer(canvas, { forceWebGL: true });
  const lost = new Promise<string>((resolve) => {
    renderer.onDeviceLost = (info) => resolve(info.message);
  });
  await renderer.init();
  quiet(renderer);
  return {
    renderer,
    backend: 'WebGL2',
    device: null,
    description: null,
    fallbackReason: reason,
    maxSide: Math.min(gl.getParameter(gl.MAX_TEXTURE_SIZE), gl.getParameter(gl.MAX_RENDERBUFFER_SIZE)),
    lost,
    get gone() {
      return gl.isContextLost() ? CONTEXT_LOST : null;
    },
    watched: (work) => checked(gl, work),
    finished: () => fence(gl),
    dispose: () =>
      // A context otherwise lives until its canvas is collected, and a page has sixteen of them.
      afterDispose(renderer, () => gl.getExtension('WEBGL_lose_context')?.loseContext()),
  };
}

function complain({ error }: GPUUncapturedErrorEvent): void {
  console.error(`WebGPU: ${error.message}`);
}

function newRenderer(canvas: HTMLCanvasElement, how: { device: GPUDevice } | { forceWebGL: true }) {
  // The paper covers the canvas, and all depth and multisampling is in our own targets.
  const renderer = new WebGPURenderer({ canvas, alpha: false, antialias: false, depth: false, ...how });
  renderer.outputColorSpace = LinearSRGBColorSpace;
  renderer.toneMapping = NoToneMapping;
  // A frame is several renders; the counts of all of them are wanted.
  renderer.info.autoReset = false;
  return renderer;
}

/** three asks for a frame after every frame, for as long as it lives; where nothing moves, nothing has to run. */
function quiet(renderer: WebGPURenderer): void {
  const { _animation } = renderer as unknown as {
    readonly _animation?: { setContext(context: object): void };
  };
  _animation?.setContext({ requestAnimationFrame: () => null, cancelAnimationFrame: () => {} });
}

/** Two scopes, because a device says in one that there is no memory, and in the other what followed from it. */
async function scoped<T>(device: GPUDevice, work: () => Promise<T>): Promise<T> {
  device.pushErrorScope('validation');
  device.pushErrorScope('out-of-memory');
  const result = work();
  const failures = [device.popErrorScope(), device.popErrorScope()];
  const [value, ...failed] = await Promise.all([result, ...failures]);
  const failure = failed.find((error) => error);
  if (failure) throw new Error(failure.message);
  return value;
}

async function checked<T>(gl: WebGL2RenderingContext, work: () => Promise<T>): Promise<T> {
  // What went wrong before is not this work's.
  while (gl.getError() !== gl.NO_ERROR);
  const result = work();
  const error = gl.getError();
  const value = await result;
  if (gl.isContextLost()) throw new Error(CONTEXT_LOST);
  if (error === gl.OUT_OF_MEMORY) throw new Error('there is not enough graphics memory');
  if (error !== gl.NO_ERROR) throw new Error(`WebGL error ${error}`);
  return value;
}

function afterDispose(renderer: WebGPURenderer, then: () => void): void {
  void Promise.resolve(renderer.dispose()).catch(console.error).then(then);
}

/** ms between two looks at a fence, whose state changes only between tasks */
const LOOK_AGAIN = 2;

function fence(gl: WebGL2RenderingContext): Promise<void> {
  const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  return new Promise((resolve) => {
    const look = () => {
      const waiting = sync && !gl.isContextLost() && gl.clientWaitSync(sync, 0, 0) === gl.TIMEOUT_EXPIRED;
      if (waiting) {
        setTimeout(look, LOOK_AGAIN);
        return;
      }
      gl.deleteSync(sync);
      resolve();
    };
    look();
  });
}
