/** Counts what lives on the graphics device, by what is made and what is explicitly given back. */

export interface Count {
  /** buffers and textures, and their bytes */
  readonly resources: number;
  readonly bytes: number;
  readonly devices: number;
  /** WebGL: textures, buffers, programs and so on of contexts that are still there, and those contexts */
  readonly objects: number;
  readonly contexts: number;
  readonly frames: number;
}

declare global {
  interface Window {
    count: Count;
  }
}

/** Runs in the page before anything else. */
export function countDevice(): void {
  const count = { resources: 0, bytes: 0, devices: 0, objects: 0, contexts: 0, frames: 0 };
  window.count = count;
  const ask = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (callback) => {
    count.frames++;
    return ask(callback);
  };
  countWebGPU(count);
  countWebGL(count);

  function countWebGPU(total: typeof count): void {
    if (!window.GPUDevice) return;
    const texels: Record<string, number> = { r8unorm: 1, rg8unorm: 2, rgba16float: 8 };
    const alive = new WeakMap<object, number>();
    const made = (thing: object, bytes: number) => {
      alive.set(thing, bytes);
      total.resources++;
      total.bytes += bytes;
    };
    const gone = (thing: object) => {
      const bytes = alive.get(thing);
      if (bytes === undefined) return;
      alive.delete(thing);
      total.resources--;
      total.bytes -= bytes;
    };
    const { createBuffer, createTexture, destroy } = GPUDevice.prototype;
    GPUDevice.prototype.createBuffer = function (descriptor) {
      const buffer = createBuffer.call(this, descriptor);
      made(buffer, descriptor.size);
      return buffer;
    };
    GPUDevice.prototype.createTexture = function (descriptor) {
      const texture = createTexture.call(this, descriptor);
      const { width, height, depthOrArrayLayers, sampleCount, format } = texture;
      made(texture, width * height * depthOrArrayLayers * sampleCount * (texels[format] ?? 4));
      return texture;
    };
    for (const kind of [GPUBuffer, GPUTexture]) {
      const end = kind.prototype.destroy;
      kind.prototype.destroy = function () {
        gone(this);
        end.call(this as never);
      };
    }
    const request = GPUAdapter.prototype.requestDevice;
    GPUAdapter.prototype.requestDevice = async function (descriptor) {
      const device = await request.call(this, descriptor);
      total.devices++;
      return device;
    };
    const ended = new WeakSet<object>();
    GPUDevice.prototype.destroy = function () {
      if (!ended.has(this)) total.devices--;
      ended.add(this);
      destroy.call(this);
    };
  }

  function countWebGL(total: typeof count): void {
    const contexts = new WeakMap<object, { alive: number; lost: boolean }>();
    const of = (context: object) => {
      const known = contexts.get(context);
      if (known) return known;
      const begun = { alive: 0, lost: false };
      contexts.set(context, begun);
      total.contexts++;
      return begun;
    };
    const wrap = (name: string, step: 1 | -1) => {
      const prototype = WebGL2RenderingContext.prototype as unknown as Record<
        string,
        (thing?: unknown) => unknown
      >;
      const real = prototype[name]!;
      prototype[name] = function (this: WebGL2RenderingContext, thing?: unknown) {
        const context = of(this);
        if (!context.lost && (step === 1 || thing)) {
          context.alive += step;
          total.objects += step;
        }
        return real.call(this, thing);
      };
    };
    for (const kind of ['Texture', 'Buffer', 'Framebuffer', 'Renderbuffer', 'Program', 'VertexArray']) {
      wrap(`create${kind}`, 1);
      wrap(`delete${kind}`, -1);
    }
    const extension = WebGL2RenderingContext.prototype.getExtension as (name: string) => unknown;
    WebGL2RenderingContext.prototype.getExtension = function (this: WebGL2RenderingContext, name: string) {
      const found = extension.call(this, name) as { loseContext(): void } | null;
      if (name !== 'WEBGL_lose_context' || !found) return found;
      const lose = () => {
        const context = of(this);
        if (!context.lost) {
          total.contexts--;
          total.objects -= context.alive;
        }
        context.lost = true;
        found.loseContext();
      };
      return { loseContext: lose };
    } as never;
  }
}
