/**
 * Our device → three's renderer. three falls back from WebGPU to WebGL2 silently; here the choice is made before
 * three is asked, and the backend it really uses is reported.
 *
 * The renderer's output colour space is set to its working space: three then converts nothing, and a display value
 * written by a shader is the value on the screen.
 */
import { LinearSRGBColorSpace, NoToneMapping, WebGPURenderer } from 'three/webgpu';
import { type DeviceDescription, type DeviceResult, openDevice } from '../gpu/device.ts';

export type Backend = 'WebGPU' | 'WebGL2';

export interface SceneRenderer {
  readonly renderer: WebGPURenderer;
  readonly backend: Backend;
  /** null on WebGL2 */
  readonly device: GPUDevice | null;
  readonly description: DeviceDescription | null;
  /** why there is no WebGPU; null when there is */
  readonly fallbackReason: string | null;
  /** Resolves, with the reason, when the device or the WebGL context is gone. */
  readonly lost: Promise<string>;
  dispose(): void;
}

export async function createRenderer(
  canvas: HTMLCanvasElement,
  wanted: 'auto' | 'webgl2',
): Promise<SceneRenderer> {
  const opened: DeviceResult =
    wanted === 'auto' ? await openDevice(navigator.gpu) : { reason: 'WebGL2 was asked for' };
  const device = 'device' in opened ? opened : null;
  const renderer = new WebGPURenderer({
    canvas,
    // The paper covers the canvas, and all depth and multisampling is in our own targets.
    alpha: false,
    antialias: false,
    depth: false,
    ...(device ? { device: device.device } : { forceWebGL: true }),
  });
  renderer.outputColorSpace = LinearSRGBColorSpace;
  renderer.toneMapping = NoToneMapping;
  // A frame is several renders; the counts of all of them are wanted.
  renderer.info.autoReset = false;
  const contextLost = new Promise<string>((resolve) => {
    renderer.onDeviceLost = (info) => resolve(info.message);
  });
  await renderer.init();
  const backend = reallyUsed(renderer);
  return {
    renderer,
    backend,
    device: backend === 'WebGPU' && device ? device.device : null,
    description: backend === 'WebGPU' && device ? device.description : null,
    fallbackReason: 'reason' in opened ? opened.reason : null,
    lost: device ? Promise.race([device.lost, contextLost]) : contextLost,
    dispose() {
      renderer.dispose();
      device?.release();
    },
  };
}

function reallyUsed(renderer: WebGPURenderer): Backend {
  return (renderer.backend as { isWebGPUBackend?: boolean }).isWebGPUBackend ? 'WebGPU' : 'WebGL2';
}
