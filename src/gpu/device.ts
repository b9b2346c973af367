/**
 * The page's one GPUDevice. Theory: a WebGPU device costs a driver context and cannot share buffers with another
 * one, so every element on a page uses the same device; the last one to leave destroys it.
 *
 * Departures from what a renderer would ask for by itself: full WebGPU rather than the compatibility level, the
 * feature `core-features-and-limits` wherever the adapter knows it (three.js drops multisampling without it), and
 * a self-test before the device is trusted, because some drivers accept every call and compute nonsense.
 */
import { selfTest } from './selfTest.ts';

/** What the status line and bug reports say about the device. */
export interface DeviceDescription {
  /** e.g. "google swiftshader" */
  readonly adapter: string;
  readonly software: boolean;
  /** the adapter knows full WebGPU by name; false on browsers older than the name */
  readonly core: boolean;
  /** bytes */
  readonly maxBufferSize: number;
  readonly maxStorageBuffersPerStage: number;
  readonly maxTextureSize: number;
}

export interface OpenedDevice {
  readonly device: GPUDevice;
  readonly description: DeviceDescription;
  /** Resolves, with the reason, when the device is gone for another cause than `release`. */
  readonly lost: Promise<string>;
  /** Gives this share back; the last release destroys the device. A second call does nothing. */
  release(): void;
}

export type DeviceResult = OpenedDevice | { readonly reason: string };

/** Wanted where the adapter has it; the default of the standard is the floor. Bytes, and buffers a stage. */
const WANTED_LIMITS = {
  maxBufferSize: 1 << 30,
  maxStorageBufferBindingSize: 1 << 30,
  maxStorageBuffersPerShaderStage: 10,
  maxComputeWorkgroupStorageSize: 32768,
  maxTextureDimension2D: 16384,
} as const;

interface Shared {
  users: number;
  readonly made: Promise<MadeDevice | { readonly reason: string }>;
}

interface MadeDevice {
  readonly device: GPUDevice;
  readonly description: DeviceDescription;
  readonly lost: Promise<string>;
}

// One entry per GPU object: a page has one, tests have several.
const sharedDevices = new WeakMap<GPU, Shared>();

/** Opens the shared device, or says why there is none. Never throws. */
export async function openDevice(gpu: GPU | undefined): Promise<DeviceResult> {
  if (!gpu) return { reason: 'this browser has no WebGPU' };
  let shared = sharedDevices.get(gpu);
  if (!shared) {
    shared = { users: 0, made: makeDevice(gpu).catch((error) => ({ reason: message(error) })) };
    sharedDevices.set(gpu, shared);
  }
  shared.users++;
  const made = await shared.made;
  if ('reason' in made) {
    forget(gpu, shared);
    return made;
  }
  // A lost device is forgotten at once, so that the next element gets a fresh one.
  const current = shared;
  void made.lost.then(() => forget(gpu, current));
  return { ...made, release: releaseOnce(gpu, shared, made.device) };
}

function releaseOnce(gpu: GPU, shared: Shared, device: GPUDevice): () => void {
  let released = false;
  return () => {
    if (released) return;
    released = true;
    if (--shared.users > 0) return;
    forget(gpu, shared);
    giveBack(device);
  };
}

function forget(gpu: GPU, shared: Shared): void {
  if (sharedDevices.get(gpu) === shared) sharedDevices.delete(gpu);
}

async function makeDevice(gpu: GPU): Promise<MadeDevice | { readonly reason: string }> {
  const adapter = await gpu.requestAdapter({ powerPreference: 'high-performance' });
  if (!adapter) return { reason: 'WebGPU found no graphics adapter' };
  const core = adapter.features.has('core-features-and-limits');
  const device = await adapter.requestDevice({
    label: 'rotund',
    requiredFeatures: core ? ['core-features-and-limits'] : [],
    requiredLimits: wantedLimits(adapter),
  });
  const lost = surfaceLoss(device);
  const failure = await Promise.race([selfTest(device), lost.then((reason) => `device lost: ${reason}`)]);
  if (failure) {
    giveBack(device);
    return { reason: `self-test failed: ${failure}` };
  }
  return { device, description: describe(adapter, device, core), lost };
}

/** Devices that are gone because nobody needs them any more. */
const givenBack = new WeakSet<GPUDevice>();

function giveBack(device: GPUDevice): void {
  givenBack.add(device);
  device.destroy();
}

/** Resolves for every loss but our own giving back, also when another script destroys the device. */
function surfaceLoss(device: GPUDevice): Promise<string> {
  return new Promise((resolve) => {
    void device.lost.then((info) => {
      if (!givenBack.has(device)) resolve(info.message || info.reason || 'unknown reason');
    });
  });
}

function wantedLimits(adapter: GPUAdapter): Record<string, number> {
  const limits: Record<string, number> = {};
  for (const [name, wanted] of Object.entries(WANTED_LIMITS)) {
    limits[name] = Math.min(wanted, adapter.limits[name as keyof typeof WANTED_LIMITS]);
  }
  return limits;
}

function describe(adapter: GPUAdapter, device: GPUDevice, core: boolean): DeviceDescription {
  const { vendor, architecture, description } = adapter.info;
  const name = [vendor, architecture].filter(Boolean).join(' ') || description || 'unknown adapter';
  return {
    adapter: name,
    software: /swiftshader|lavapipe|llvmpipe|basic render/i.test(`${name} ${description}`),
    core,
    maxBufferSize: device.limits.maxBufferSize,
    maxStorageBuffersPerStage: device.limits.maxStorageBuffersPerShaderStage,
    maxTextureSize: device.limits.maxTextureDimension2D,
  };
}

function message(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
