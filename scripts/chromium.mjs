// Finds the system's Chromium, and how to start it so that WebGPU runs on any machine (SwiftShader).
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';

const PLACES = [
  '/usr/bin/chromium',
  '/usr/bin/chromium-browser',
  '/usr/bin/google-chrome',
  '/snap/bin/chromium',
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
];

export function findChromium() {
  const named = process.env.CHROMIUM;
  if (named) return existsSync(named) ? named : null;
  return PLACES.find((place) => existsSync(place)) ?? null;
}

const isRoot = process.getuid?.() === 0;

/** Fewer flags find an adapter too, but then the first presented frame kills the GPU process. */
export const SOFTWARE_WEBGPU = [
  '--enable-unsafe-webgpu',
  '--enable-features=Vulkan',
  '--use-vulkan=swiftshader',
  '--use-angle=swiftshader',
];

export const QUIET = [
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--disable-quic',
  '--no-first-run',
  ...(isRoot ? ['--no-sandbox'] : []),
];

/** Dawn in Node needs a Vulkan loader and driver: the ones that Chromium ships do, on every machine alike. */
export function dawnEnvironment(chromium = findChromium()) {
  if (process.env.VK_ICD_FILENAMES || !chromium) return {};
  const folder = [dirname(chromium), '/usr/lib/chromium'].find((f) =>
    existsSync(join(f, 'vk_swiftshader_icd.json')),
  );
  if (!folder) return {};
  const loaders = [folder, process.env.LD_LIBRARY_PATH].filter(Boolean).join(':');
  return { VK_ICD_FILENAMES: join(folder, 'vk_swiftshader_icd.json'), LD_LIBRARY_PATH: loaders };
}
