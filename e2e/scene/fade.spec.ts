/** One picture goes over into the next: at every moment the mean of both, weighted, and at the end nothing of the first. */
import { expect, test } from '@playwright/test';
import { PNG } from 'pngjs';

const read = (address: string) =>
  PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64')).data;

/** The largest difference of any channel of any pixel from a mean of two pictures. */
function off(seen: Buffer, before: Buffer, after: Buffer, share: number): number {
  let most = 0;
  for (let i = 0; i < seen.length; i++)
    most = Math.max(most, Math.abs(seen[i]! - (share * before[i]! + (1 - share) * after[i]!)));
  return most;
}

for (const backend of ['auto', 'webgl2'] as const) {
  for (const style of ['toon', 'hbed-ink'] as const) {
    test(`${style}, ${backend}`, async ({ page }) => {
      await page.goto('/e2e/scene/index.html');
      await page.waitForFunction(() => typeof window.openDeviceStage === 'function');
      const found = await page.evaluate(
        async ([choice, look]) => {
          const stage = await window.openDeviceStage(choice);
          stage.show('arrays');
          const early = stage.keep();
          const before = stage.picture({ style: look });
          const kept = stage.keep();
          stage.showHalf();
          const between = [1, 0.6, 0.25].map((share) => {
            stage.fade(share);
            return { share, seen: stage.picture() };
          });
          stage.fade(0);
          const after = stage.picture();
          stage.fade(0.5);
          const late = stage.picture();
          stage.keep();
          // another look: what was kept would be a stranger in it
          const other = stage.picture({ style: look, background: 'black' });
          stage.show('arrays');
          stage.showHalf();
          const same = stage.picture({ style: look, background: 'black' });
          stage.dispose();
          return { early, kept, before, between, after, late, other, same };
        },
        [backend, style] as const,
      );
      expect([found.early, found.kept]).toEqual([false, true]);
      const [before, after] = [read(found.before), read(found.after)];
      expect(off(after, before, before, 1)).toBeGreaterThan(50);
      // half a step for each of three roundings
      for (const { share, seen } of found.between)
        expect(off(read(seen), before, after, share), String(share)).toBeLessThanOrEqual(1.5);
      expect(found.late).toBe(found.after);
      expect(found.other).toBe(found.same);
    });
  }
}
