/** `rotund render`: the picture the application shows, drawn by the same element in headless Chromium. */
import { type Document, isImplicit } from '../document/document.ts';
import type { Drawing } from '../document/drawing.ts';
import { nodeOf } from '../document/solidNode.ts';
import type { Flaw } from '../element/flaws.ts';
import type { Shot } from '../element/shot.ts';
import { type Comparison, zhuSum } from '../field/zhuImage.ts';
import { type Args, inputOf } from './args.ts';
import { firstLine, type OpenPage, openPage, withBrowser } from './browser.ts';
import { camera } from './camera.ts';
import { RENDER } from './commands.ts';
import { readInput } from './input.ts';
import { checkOutput, outputOf, writeOutputs } from './output.ts';
import { Problem } from './problem.ts';
import { leftOut } from './report.ts';
import { result, say } from './say.ts';
import { checkPicture, mode, rays, size, style } from './values.ts';

export async function render(args: Args): Promise<void> {
  const started = performance.now();
  const input = inputOf(RENDER, args);
  const { values } = args;
  const out = outputOf(values.output, RENDER.synopsis);
  checkPicture(out);
  const shot = shotOf(values);
  const isCompared = rays(values.rays, shot.mode) === 'zhu';
  checkOutput(out, input);
  const { drawing } = await readInput(input);
  for (const warning of leftOut(drawing.document)) say(`rotund: ${warning}`);
  if (isCompared) checkSums(drawing.document, input);
  const { png, backend, flaws, ...counts } = await withBrowser(async (browser) =>
    drawn(await openPage(browser), { drawing, shot, isCompared }),
  );
  for (const { name, words } of flaws)
    say(`rotund: “${name}”: ${words.charAt(0).toLowerCase()}${words.slice(1)}`);
  writeOutputs([{ path: out, bytes: png }]);
  const milliseconds = Math.round(performance.now() - started);
  result({ width: shot.width, height: shot.height, backend, ...counts, milliseconds });
}

function shotOf(values: Args['values']) {
  const from = camera(values.camera);
  const look = style(values.style);
  const surfaces = mode(values.mode);
  return {
    ...size(values.size),
    ...(from && { camera: from }),
    ...(look && { style: look }),
    ...(surfaces && { mode: surfaces }),
  };
}

/** Zhu et al. have no others. */
function checkSums({ parts }: Document, input: string): void {
  const bodies = parts.filter(isImplicit).filter(({ hidden }) => !hidden);
  if (bodies.length === 0) throw new Problem(`${input}: there is no implicit body to cast rays at`);
  for (const part of bodies) {
    try {
      zhuSum(nodeOf(part));
    } catch (error) {
      throw new Problem(`${input}: ${part.name}: ${firstLine(error)}`);
    }
  }
}

interface Order {
  readonly drawing: Drawing;
  readonly shot: Shot;
  readonly isCompared: boolean;
}

interface Picture {
  readonly png: Uint8Array;
  readonly backend: string;
  /** of a comparison */
  readonly rays?: Comparison;
  /** what it does not show */
  readonly flaws: readonly Flaw[];
}

/** ms a picture may take: large ones take minutes on a software adapter. */
const PATIENCE = 600_000;

async function drawn({ page, broken }: OpenPage, wanted: Order): Promise<Picture> {
  // As one text: a drawing may hold a million numbers, and arguments are taken apart one by one.
  const order = JSON.stringify(wanted);
  let timer: NodeJS.Timeout | undefined;
  const tooLong = new Promise<never>((_, reject) => {
    timer = setTimeout(() => reject(new Error('it took longer than ten minutes')), PATIENCE);
  });
  try {
    const { base64, ...said } = await Promise.race([broken, page.evaluate(inPage, order), tooLong]);
    return { png: Buffer.from(base64, 'base64'), ...said };
  } catch (error) {
    const reason = firstLine(error).replace(/^page\.evaluate: (Error: )?/, '');
    throw new Problem(`the picture could not be drawn: ${reason}`, 1);
  } finally {
    clearTimeout(timer);
  }
}

interface InPage extends Omit<Picture, 'png'> {
  readonly base64: string;
}

/** Runs in the page. */
async function inPage(order: string): Promise<InPage> {
  const { drawing, shot, isCompared } = JSON.parse(order);
  await customElements.whenDefined('rotund-sketch');
  const sketch = document.querySelector('rotund-sketch')!;
  await sketch.load(drawing, { fit: false });
  const { picture, ...counts } = isCompared
    ? await sketch.compareRays(shot)
    : { picture: await sketch.picture(shot) };
  const reader = new FileReader();
  await new Promise((resolve) => {
    reader.onload = resolve;
    reader.readAsDataURL(picture);
  });
  const url = reader.result as string;
  const isExact = isCompared || (shot.mode ?? drawing.look?.mode) === 'exact';
  // rays see what is thin
  const flaws = sketch.flaws.filter(({ what }) => !isExact || what === 'cut' || what === 'none');
  const base64 = url.slice(url.indexOf(',') + 1);
  const said = { base64, backend: sketch.dataset.backend ?? 'none', flaws };
  return 'hits' in counts ? { ...said, rays: counts } : said;
}
