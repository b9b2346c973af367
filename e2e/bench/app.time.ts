/** Pen-up to the surface on the screen, and frame time per style, in the application on this machine's adapter. */
import { expect, test } from '@playwright/test';
import { TIMINGS } from '../../src/element/timing.ts';
import { BODY } from '../pear.ts';
import { PenDriver, type Point } from '../pen.ts';

const median = (values: number[]) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)]!;

test('pen-up and frames', async ({ page }) => {
  test.setTimeout(300_000);
  await page.goto('/');
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);
  const pen = await PenDriver.on(page);
  for (const stroke of BODY) await pen.draw(stroke);
  const measured = await page.evaluate(async () => {
    const { session } = document.querySelector('rotund-sketch')!;
    const scene = session.scene!;
    const strokes = session.document.draft!.strokes;
    const surface: number[] = [];
    const mesh: number[] = [];
    for (let i = 0; i < 12; i++) {
      session.undo();
      await scene.compile();
      // A stroke never seen before: nothing of it is cached.
      const stroke = { ...strokes[1]!, samples: strokes[1]!.samples.map((sample) => ({ ...sample })) };
      const start = performance.now();
      session.commit([{ type: 'addStroke', stroke }]);
      await new Promise(requestAnimationFrame);
      await scene.compile();
      surface.push(performance.now() - start);
      mesh.push(session.frames.buildTime);
    }
    session.keep();
    const frames: Record<string, number[]> = {};
    for (const style of ['toon', 'gouraud', 'hbed-lines', 'hbed-ink'] as const) {
      session.setLook({ style });
      await scene.compile();
      frames[style] = [];
      for (let i = 0; i < 12; i++) {
        const start = performance.now();
        await scene.compile();
        frames[style].push(performance.now() - start);
      }
    }
    return { backend: scene.backend, adapter: scene.description, surface, mesh, frames };
  });
  console.log(`\nback end: ${measured.backend}, 800 × 600, one part of 64 × 64 quads`);
  console.log(
    `pen-up → surface on screen: ${median(measured.surface).toFixed(0)} ms, of it filter and mesh ${median(measured.mesh).toFixed(1)} ms`,
  );
  const base = median(measured.frames.gouraud!);
  for (const [style, times] of Object.entries(measured.frames)) {
    const time = median(times);
    console.log(
      `frame, ${style.padEnd(11)} ${time.toFixed(0).padStart(5)} ms   ${(time / base).toFixed(2)} × shaded`,
    );
  }
});

test('pen-up to the mesh of a solid', async ({ page }) => {
  test.setTimeout(300_000);
  await page.goto('/');
  await expect(page.locator('rotund-sketch')).toHaveAttribute('data-backend', /WebG/);
  const pen = await PenDriver.on(page);
  // a figure of three bulges, drawn anew each time
  const outline = (turn: number): Point[] =>
    Array.from({ length: 120 }, (_, i) => {
      const angle = (i / 120) * 2 * Math.PI;
      const radius = 150 * (1 + 0.2 * Math.cos(3 * angle + turn));
      return [420 + radius * Math.cos(angle), 300 + radius * Math.sin(angle)];
    });
  for (let i = 0; i < 6; i++) {
    await pen.draw(outline(i));
    await page.evaluate(() => document.querySelector('rotund-sketch')!.session.bodies.settled());
    await page.keyboard.press('Escape');
  }
  const times = await page.evaluate(
    (names) => names.map((name) => performance.getEntriesByName(name).map(({ duration }) => duration)),
    Object.values(TIMINGS),
  );
  for (const [i, name] of Object.values(TIMINGS).entries())
    console.log(`${name}: ${median(times[i]!).toFixed(0)} ms, of ${times[i]!.length}`);
});
