/**
 * A page with the element on it, in headless Chromium. The page's files come from the disk by interception: no server, no
 * port, and an https address, because WebGPU wants one. Everything that is not one of them is refused.
 */
import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Browser, Page, Route } from 'playwright-core';
import { findChromium, QUIET, SOFTWARE_WEBGPU } from './chromium.ts';
import { Problem } from './problem.ts';
import { PLAYWRIGHT } from './version.ts';

const FILES = new URL('./page/', import.meta.url);
const ORIGIN = 'https://rotund.invalid';

/** The element is not shown: only the picture that is asked for is drawn. */
const PAGE = `<!doctype html>
<meta charset="utf-8">
<title>Rotund</title>
<script type="module" src="/sketch.js"></script>
<rotund-sketch readonly controls="none" style="display: none"></rotund-sketch>`;

const TYPES: Readonly<Record<string, string>> = { js: 'text/javascript', css: 'text/css' };

/** Starts a browser for the time of `use`. */
export async function withBrowser<T>(use: (browser: Browser) => Promise<T>): Promise<T> {
  if (!existsSync(new URL('sketch.js', FILES))) {
    throw new Problem(`${fileURLToPath(FILES)}: the page that draws is missing; npm run rotund builds it`, 1);
  }
  const { chromium } = await playwright();
  const executablePath = findChromium();
  if (!executablePath) throw new Problem(missingChromium());
  const launched = chromium.launch({ executablePath, args: [...SOFTWARE_WEBGPU, ...QUIET] });
  const browser = await launched.catch((error: unknown) => {
    throw new Problem(`Chromium (${executablePath}) does not start: ${firstLine(error)}`, 1);
  });
  try {
    return await use(browser);
  } finally {
    await browser.close();
  }
}

export interface OpenPage {
  readonly page: Page;
  /** Rejects when something breaks in it, whenever that was. */
  readonly broken: Promise<never>;
}

export async function openPage(browser: Browser): Promise<OpenPage> {
  const page = await browser.newPage({ viewport: { width: 64, height: 64 } });
  const broken = new Promise<never>((_, reject) => {
    page.on('pageerror', reject);
    page.on('crash', () => reject(new Error('the page crashed, as it does when memory runs out')));
  });
  // Who does not listen yet hears it later.
  broken.catch(() => {});
  await page.route('**/*', (route) => answer(route));
  await page.goto(`${ORIGIN}/`);
  return { page, broken };
}

function answer(route: Route): Promise<void> {
  const url = new URL(route.request().url());
  if (url.origin !== ORIGIN) return route.abort();
  if (url.pathname === '/') return route.fulfill({ contentType: 'text/html', body: PAGE });
  // Addresses are normal already: they cannot lead out of the folder.
  const file = fileURLToPath(new URL(`.${url.pathname}`, FILES));
  try {
    const contentType = TYPES[file.split('.').at(-1)!] ?? 'application/octet-stream';
    return route.fulfill({ contentType, body: readFileSync(file) });
  } catch {
    return route.fulfill({ status: 404, body: '' });
  }
}

async function playwright(): Promise<typeof import('playwright-core')> {
  try {
    return await import('playwright-core');
  } catch {
    const install = `npm install playwright-core@${PLAYWRIGHT}`;
    throw new Problem(`render needs the package playwright-core, which is not installed: ${install}`);
  }
}

function missingChromium(): string {
  const named = process.env.CHROMIUM;
  if (named) return `render needs Chromium; CHROMIUM names ${named}, which does not exist`;
  return 'render needs Chromium, which was not found. Install it (Debian and Ubuntu: sudo apt-get install chromium) or set CHROMIUM to its path.';
}

export const firstLine = (error: unknown): string =>
  (error instanceof Error ? error.message : String(error)).split('\n')[0]!;
