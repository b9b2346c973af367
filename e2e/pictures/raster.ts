/** Pictures as pixels: shrink, cut out, put side by side. Nothing knows what they show. */
import { PNG } from 'pngjs';

/** A PNG's data address as pixels. */
export const decoded = (address: string): PNG =>
  PNG.sync.read(Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));

/** A picture a whole number of times smaller: every pixel the mean of those it stands for, transparent ones weightless. */
export function shrunk(from: PNG, times: number): PNG {
  const to = new PNG({ width: Math.floor(from.width / times), height: Math.floor(from.height / times) });
  for (let y = 0; y < to.height; y++) {
    for (let x = 0; x < to.width; x++) {
      const sum = [0, 0, 0, 0];
      for (let k = 0; k < times * times; k++) {
        const i = 4 * ((y * times + Math.floor(k / times)) * from.width + x * times + (k % times));
        const alpha = from.data[i + 3]!;
        for (let c = 0; c < 3; c++) sum[c]! += alpha * from.data[i + c]!;
        sum[3]! += alpha;
      }
      const weight = sum[3] || 1;
      const pixel = [sum[0]! / weight, sum[1]! / weight, sum[2]! / weight, sum[3]! / times ** 2];
      to.data.set(pixel.map(Math.round), 4 * (y * to.width + x));
    }
  }
  return to;
}

/** Rows of pictures of one size. */
export function sheet(rows: readonly (readonly PNG[])[]): PNG {
  const { width, height } = rows[0]![0]!;
  const to = new PNG({ width: width * rows[0]!.length, height: height * rows.length });
  for (const [j, row] of rows.entries()) {
    for (const [i, picture] of row.entries())
      PNG.bitblt(picture, to, 0, 0, width, height, i * width, j * height);
  }
  return to;
}

/** The picture between x and x + width, whole height. */
export function column(from: PNG, x: number, width: number): PNG {
  const to = new PNG({ width, height: from.height });
  PNG.bitblt(from, to, x, 0, width, from.height, 0, 0);
  return to;
}

/**
 * What was drawn, without its paper, from pictures of it on two papers a and b. A pixel covered by α of colour F is
 * αF + (1 − α)a on one and αF + (1 − α)b on the other: the difference gives α, and that F.
 */
export function cutOut(onA: PNG, onB: PNG): PNG {
  const { width, height } = onA;
  const to = new PNG({ width, height });
  const paper = [0, 1, 2].map((c) => onA.data[c]! - onB.data[c]!);
  const apart = paper.reduce((sum, difference) => sum + difference, 0);
  for (let i = 0; i < to.data.length; i += 4) {
    const seen = [0, 1, 2].reduce((sum, c) => sum + onA.data[i + c]! - onB.data[i + c]!, 0);
    const alpha = Math.min(Math.max(1 - seen / apart, 0), 1);
    for (let c = 0; c < 3; c++) {
      const colour = (onA.data[i + c]! - (1 - alpha) * onA.data[c]!) / (alpha || 1);
      to.data[i + c] = Math.round(Math.min(Math.max(colour, 0), 255));
    }
    to.data[i + 3] = Math.round(255 * alpha);
  }
  return to;
}

/** The box of what is not transparent, pixels. */
export function boxOf({ width, height, data }: PNG): {
  left: number;
  top: number;
  right: number;
  bottom: number;
} {
  const box = { left: width, top: height, right: 0, bottom: 0 };
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      if (data[4 * (y * width + x) + 3]! < 128) continue;
      box.left = Math.min(box.left, x);
      box.right = Math.max(box.right, x + 1);
      box.top = Math.min(box.top, y);
      box.bottom = Math.max(box.bottom, y + 1);
    }
  }
  return box;
}
