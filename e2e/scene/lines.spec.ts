import { expect, type Page, test } from '@playwright/test';
import { type Quat, quat, type Vec3, vec3 } from '../../src/math/vec.ts';
import type { Picture } from './main.ts';
import { distanceToLine, draw, openScenePage } from './picture.ts';

// One page for all: starting the software device costs more than a picture.
let page: Page;

test.beforeAll(async ({ browser }) => {
  page = await browser.newPage();
  await openScenePage(page);
});

test.afterAll(() => page.close());

const LINES = { style: 'hbed-lines', background: 'white' } as const;
/** how dark a line is at least where it passes: a line of one CSS pixel between two device pixels is half covered */
const LINE = 0.3;
/** how dark bare paper is at most */
const BARE = 0.02;

const general = quat.fromEuler([0, 0, 0, 1], -25, 35, 0) as unknown as Quat;

test.describe('a cube in general view', () => {
  for (const pixelRatio of [1, 2, 3]) {
    for (const kernel of ['A', 'B', 'C', 'D'] as const) {
      test(`shows exactly its 9 visible edges, kernel ${kernel}, pixel ratio ${pixelRatio}`, async () => {
        const image = await draw(page, {
          things: [{ form: { kind: 'cube', side: 100 } }],
          look: { ...LINES, kernel },
          view: { rotation: general },
          pixelRatio,
          size: [256, 256],
        });
        const edges = visibleEdges(100, general).map(
          ([a, b]) => [image.project(a), image.project(b)] as const,
        );
        expect(edges).toHaveLength(9);
        for (const [[ax, ay], [bx, by]] of edges) {
          const along = Array.from({ length: 13 }, (_, i) => 0.08 + 0.07 * i);
          const faintest = along.map((t) => image.darkest(ax + t * (bx - ax), ay + t * (by - ay), 1.5));
          expect(Math.min(...faintest)).toBeGreaterThan(LINE);
        }
        const stray = [...image.places()].filter(
          (place) =>
            image.darkness(...place) > BARE && edges.every(([a, b]) => distanceToLine(place, a, b) > 3.5),
        );
        expect(stray).toEqual([]);
      });
    }
  }
});

test.describe('two equal discs, one a third of the scene behind the other', () => {
  for (const pixelRatio of [1, 2, 3]) {
    test(`show a line between them, pixel ratio ${pixelRatio}`, async () => {
      const image = await draw(page, {
        things: [
          { form: { kind: 'disc', radius: 40, centre: [-22, 0, 22] } },
          { form: { kind: 'disc', radius: 40, centre: [22, 0, -22] } },
        ],
        look: LINES,
        pixelRatio,
        size: [256, 256],
      });
      for (let angle = -50; angle <= 50; angle += 5) {
        const turn = (angle * Math.PI) / 180;
        const [x, y] = image.project([-22 + 40 * Math.cos(turn), 40 * Math.sin(turn), 22]);
        expect(image.darkest(x, y, 1.5), `at ${angle}°`).toBeGreaterThan(LINE);
      }
      // inside of the front disc, and what it hides of the one behind
      for (const [x, y] of [
        [-22, 0],
        [-50, 0],
        [-16, 0],
        [0, 20],
        [-22, -30],
      ] as const) {
        expect(image.darkest(...image.project([x, y, 22]), 1.5)).toBeLessThan(BARE);
      }
    });
  }
});

test.describe('a sphere', () => {
  for (const pixelRatio of [1, 2, 3]) {
    test(`shows only its outline, pixel ratio ${pixelRatio}`, async () => {
      const picture: Picture = {
        things: [{ form: { kind: 'sphere', radius: 60 } }],
        look: LINES,
        pixelRatio,
        size: [256, 256],
      };
      const image = await draw(page, picture);
      const [x0, y0] = image.project([0, 0, 0]);
      const radius = image.project([60, 0, 0])[0] - x0;
      for (let angle = 0; angle < 360; angle += 5) {
        const turn = (angle * Math.PI) / 180;
        let weight = 0;
        let middle = 0;
        for (let r = radius - 4; r <= radius + 4; r += 0.1) {
          const dark = image.darkness(x0 + r * Math.cos(turn), y0 + r * Math.sin(turn));
          weight += dark;
          middle += dark * r;
        }
        expect(weight, `a line at ${angle}°`).toBeGreaterThan(3);
        expect(Math.abs(middle / weight - radius), `its radius at ${angle}°`).toBeLessThan(0.75);
      }
      const stray = [...image.places()].filter(
        ([x, y]) => Math.abs(Math.hypot(x - x0, y - y0) - radius) > 2.5 && image.darkness(x, y) > BARE,
      );
      expect(stray).toEqual([]);
    });
  }

  test('keeps a thin line of even width as a contour of toon', async () => {
    for (const pixelRatio of [1, 2, 3]) {
      const image = await draw(page, {
        things: [{ form: { kind: 'sphere', radius: 60 }, colour: '#ffffff' }],
        look: { ...LINES, style: 'toon' },
        pixelRatio,
        size: [256, 256],
      });
      const [x0, y0] = image.project([0, 0, 0]);
      const radius = image.project([60, 0, 0])[0] - x0;
      // outside only: the inside is shaded; half of 2.4 CSS pixels
      for (let angle = 0; angle < 360; angle += 5) {
        const turn = (angle * Math.PI) / 180;
        let width = 0;
        for (let r = radius; r <= radius + 4; r += 0.05) {
          width += 0.05 * (image.darkness(x0 + r * Math.cos(turn), y0 + r * Math.sin(turn)) / 0.855);
        }
        expect(width, `pixel ratio ${pixelRatio}, ${angle}°`).toBeGreaterThan(0.6);
        expect(width, `pixel ratio ${pixelRatio}, ${angle}°`).toBeLessThan(1.8);
      }
    }
  });
});

/** Edges that border a face turned to the viewer. */
function visibleEdges(side: number, rotation: Quat): (readonly [Vec3, Vec3])[] {
  const towards = vec3.transformQuat([0, 0, 0], [0, 0, 1], rotation);
  const edges: (readonly [Vec3, Vec3])[] = [];
  for (let axis = 0; axis < 3; axis++) {
    const [b, c] = [(axis + 1) % 3, (axis + 2) % 3];
    for (const [sb, sc] of [
      [-1, -1],
      [-1, 1],
      [1, -1],
      [1, 1],
    ] as const) {
      const seen = sb * (towards[b] ?? 0) > 0 || sc * (towards[c] ?? 0) > 0;
      if (!seen) continue;
      const end = (sign: number): Vec3 => {
        const corner = [0, 0, 0];
        corner[axis] = (sign * side) / 2;
        corner[b] = (sb * side) / 2;
        corner[c] = (sc * side) / 2;
        return corner as unknown as Vec3;
      };
      edges.push([end(-1), end(1)]);
    }
  }
  return edges;
}
