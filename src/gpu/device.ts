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

export type DeviceResult = OpenedDevice | Failure;

/** Wanted where the adapter has it; the default of the standard is the floor. Bytes, and buffers a stage. */
const WANTED_LIMITS = {
  maxBufferSize: 1 << 30,
  maxStorageBufferBindingSize: 1 << 30,
  maxStorageBuffersPerShaderStage: 10,
  maxComputeWorkgroupStorageSize: 32768,
  maxTextureDimension2D: 16384,
} as const;

/** ms: a device that has not answered by then is none; software adapters on busy machines take seconds. */
const PATIENCE = 20_000;
/** A device may be lost while it is tested, when the one before took the graphics process with it. */
const ATTEMPTS = 3;

interface Failure {
  readonly reason: string;
}

interface MadeDevice {
  readonly device: GPUDevice;
  readonly description: DeviceDescription;
  /** Resolves for every loss but our own giving back. */
  readonly lost: Promise<string>;
}

interface Shared {
  /** What each user wants to be told of the loss. A device outlives most of its users and must not hold on to them. */
  readonly users: Set<(reason: string) => void>;
  readonly made: Promise<MadeDevice | Failure>;
}

// One entry per GPU object: a page has one, tests have several.
const sharedDevices = new WeakMap<GPU, Shared>();

/** Opens the shared device, or says why there is none. Never throws. */
export async function openDevice(gpu: GPU | undefined, patience = PATIENCE): Promise<DeviceResult> {
  if (!gpu) return { reason: 'this browser has no WebGPU' };
  const shared = sharedDevices.get(gpu) ?? share(gpu, patience);
  let tell: (reason: string) => void = () => {};
  const lost = new Promise<string>((resolve) => {
    tell = resolve;
  });
  shared.users.add(tell);
  const made = await shared.made;
  if ('reason' in made) return made;
  const release = () => {
    if (shared.users.delete(tell) && shared.users.size === 0) {
      forget(gpu, shared);
      giveBack(made.device);
    }
  };
  return { device: made.device, description: made.description, lost, release };
}

function share(gpu: GPU, patience: number): Shared {
  const made = inTime(makeDevice(gpu), patience).catch((error) => ({ reason: message(error) }));
  const shared: Shared = { users: new Set(), made };
  sharedDevices.set(gpu, shared);
  void made.then(async (result) => {
    // What failed is forgotten, and so is what was lost: the next element asks anew.
    const reason = 'reason' in result ? result.reason : await result.lost;
    forget(gpu, shared);
    for (const tell of shared.users) tell(reason);
  });
  return shared;
}

function forget(gpu: GPU, shared: Shared): void {
  if (sharedDevices.get(gpu) === shared) sharedDevices.delete(gpu);
}

/** Some drivers never answer. What comes too late is given back. */
async function inTime(made: Promise<MadeDevice | Failure>, patience: number): Promise<MadeDevice | Failure> {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const tooLate = new Promise<null>((resolve) => {
    timer = setTimeout(() => resolve(null), patience);
  });
  const first = await Promise.race([made, tooLate]);
  clearTimeout(timer);
  if (first) return first;
  void made.then(
    (late) => 'device' in late && giveBack(late.device),
    () => {},
  );
  return { reason: `the graphics device did not answer within ${patience / 1000} s` };
}

async function makeDevice(gpu: GPU): Promise<MadeDevice | Failure> {
  let loss = '';
  for (let attempt = 0; attempt < ATTEMPTS; attempt++) {
    const adapter = await gpu.requestAdapter({ powerPreference: 'high-performance' });
    if (!adapter) return { reason: 'WebGPU found no graphics adapter' };
    const made = await fromAdapter(adapter);
    const failure = await Promise.race([test(made.device), made.lost.then((reason) => ({ loss: reason }))]);
    if (!failure) return made;
    giveBack(made.device);
    if ('reason' in failure) return failure;
    loss = failure.loss;
  }
  return { reason: `device lost ${ATTEMPTS} times: ${loss}` };
}

async function fromAdapter(adapter: GPUAdapter): Promise<MadeDevice> {
  const core = adapter.features.has('core-features-and-limits');
  const device = await adapter.requestDevice({
    label: 'rotund',
    requiredFeatures: core ? ['core-features-and-limits'] : [],
    requiredLimits: wantedLimits(adapter),
  });
  settleScopes(device);
  return { device, description: describe(adapter, device, core), lost: surfaceLoss(device) };
}

/**
 * A lost device has no errors to tell (WebGPU, popErrorScope). Chromium rejects instead when the graphics process dies,
 * and three.js, which asks after every pipeline, does not catch that.
 */
function settleScopes(device: GPUDevice): void {
  const pop = device.popErrorScope.bind(device);
  device.popErrorScope = () =>
    pop().catch((error: unknown) => {
      if (/instance dropped|external instance reference/i.test(message(error))) return null;
      throw error;
    });
}

async function test(device: GPUDevice): Promise<Failure | null> {
  const wrong = await selfTest(device).catch(message);
  return wrong === null ? null : { reason: `self-test failed: ${wrong}` };
}

/** Devices that are gone because nobody needs them any more. */
const givenBack = new WeakSet<GPUDevice>();

function giveBack(device: GPUDevice): void {
  givenBack.add(device);
  device.destroy();
}

/** Also when another script destroys the device. */
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
