/**
 * WebGPU in Node: Dawn, from the optional package `webgpu`. Where it finds no adapter, Chromium's software one
 * (SwiftShader) takes its place, whose Vulkan loader lies beside the browser.
 */
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { findChromium } from './chromium.ts';
import { Problem } from './problem.ts';
import { WEBGPU } from './version.ts';

/** Dawn ends the process when this object is collected while a device lives, and never ends it while it is kept. */
let kept: GPU | null = null;

/** Lends WebGPU for the time of `use`; it may have no adapter. */
export async function withWebGpu<T>(use: (gpu: GPU) => Promise<T>): Promise<T> {
  const { create } = await dawn();
  // without a loader Dawn warns on standard error before it says that there is no adapter
  if (process.platform === 'linux' && !isLoaded('libvulkan.so.1')) loadSoftwareVulkan();
  kept = create([]) as GPU;
  if (!(await kept.requestAdapter()) && loadSoftwareVulkan()) kept = create([]) as GPU;
  try {
    return await use(kept);
  } finally {
    kept = null;
  }
}

async function dawn(): Promise<typeof import('webgpu')> {
  try {
    return await import('webgpu');
  } catch {
    const install = `npm install webgpu@${WEBGPU}`;
    throw new Problem(`--backend gpu needs the package webgpu, which is not installed: ${install}`);
  }
}

/** RTLD_NOW, and RTLD_NODELETE, which Node's constants lack: the library stays though it is no module of Node. */
const STAY = 0x2 | 0x1000;

/** Whether there is now a loader and a driver to be found: Dawn asks for the loader by its name alone. */
function loadSoftwareVulkan(): boolean {
  const chromium = findChromium();
  if (process.platform !== 'linux' || process.env.VK_ICD_FILENAMES || !chromium) return false;
  const folder = [dirname(chromium), '/usr/lib/chromium'].find((f) =>
    existsSync(join(f, 'vk_swiftshader_icd.json')),
  );
  if (!folder) return false;
  process.env.VK_ICD_FILENAMES = join(folder, 'vk_swiftshader_icd.json');
  isLoaded(join(folder, 'libvulkan.so.1'));
  return true;
}

/** Whether a library is there: it is no module of Node, which Node says, and stays. */
function isLoaded(library: string): boolean {
  try {
    process.dlopen({ exports: {} }, library, STAY);
    return true;
  } catch (error) {
    return !/cannot open shared object/.test(String(error));
  }
}
