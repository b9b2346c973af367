import { describe, expect, test } from 'vitest';
import { isSolid } from '../../src/document/document.ts';
import type { Group } from '../../src/document/solid.ts';
import { groupsOf } from '../../src/document/solid.ts';
import { project, toWorld } from '../../src/stroke/plane.ts';
import { selecting } from '../../src/tool/select.ts';
import {
  type Hold,
  holdAt,
  holdSkeleton,
  type NodeTap,
  shownNodes,
  skeletonAt,
} from '../../src/tool/skeleton.ts';
import { line } from '../document/strokes.ts';
import { Driver } from './driver.ts';
import { anyRotation } from './scene.ts';

/** A line 60 mm long, upright, in a solid that was moved. */
function hand(): Driver {
  const driver = new Driver();
  driver.commit([
    { type: 'addStroke', stroke: line(0), form: 'line' },
    { type: 'keep' },
    { type: 'moveParts', ids: ['part-1'], by: { rotation: [0, 0, 0, 1], translation: [10, 0, 0] } },
  ]);
  driver.selection = ['part-1'];
  return driver;
}

const at = (driver: Driver) => skeletonAt(driver.document, driver.selection)!;
const groupOf = (driver: Driver): Group => driver.document.parts.filter(isSolid).flatMap(groupsOf)[0]!;
const seen = (driver: Driver) => shownNodes(at(driver).graph, at(driver).plane, driver);

function take(driver: Driver, hold: Hold, before: NodeTap | null = null) {
  const taps: NodeTap[] = [];
  driver.state = holdSkeleton(hold, { before, choose: (tap) => taps.push(tap) }, selecting);
  return taps;
}

describe('what is under the pen', () => {
  test('nodes first, then rims, then links; further off nothing', () => {
    const driver = hand();
    const shown = seen(driver);
    const [top] = [...shown].sort((a, b) => a!.at[1] - b!.at[1]);
    const pen = (x: number, y: number) => ({ x, y, pointer: 'mouse' as const });
    const [x, y] = top!.at;
    const held = holdAt(shown, at(driver).graph, pen(x + 3, y));
    expect(held?.kind).toBe('node');
    expect(holdAt(shown, at(driver).graph, pen(x, y - top!.radius))).toMatchObject({ kind: 'rim' });
    expect(holdAt(shown, at(driver).graph, pen(x, y - top!.radius), () => false)).toBeNull();
    expect(holdAt(shown, at(driver).graph, pen(x, y + 90))).toEqual({ kind: 'link', link: 0 });
    expect(holdAt(shown, at(driver).graph, pen(x + 100, y))).toBeNull();
  });

  test.each([0, 1, 2])(
    'nodes are seen where they lie, as large as they are, however one looks, seed %d',
    (seed) => {
      const driver = hand();
      driver.view = { ...driver.view, rotation: anyRotation(seed) };
      const { graph, plane } = at(driver);
      seen(driver).forEach((node, i) => {
        expect(node!.at).toEqual(project(driver.view, driver.size, toWorld(plane, graph.nodes[i]!.at)));
        expect(node!.radius).toBeCloseTo((graph.nodes[i]!.radius * 600) / 200, 6);
      });
    },
  );

  test('one group alone has a skeleton', () => {
    const driver = hand();
    driver.selection = [];
    expect(skeletonAt(driver.document, driver.selection)).toBeNull();
    driver.commit([{ type: 'showParts', ids: ['part-1'], visible: false }]);
    expect(skeletonAt(driver.document, ['part-1'])).toBeNull();
  });
});

describe('skeletons in the hand', () => {
  test('a node goes with the pen, on its plane: shown at once, one undo step', () => {
    const driver = hand();
    const before = driver.document;
    const { graph } = at(driver);
    take(driver, { kind: 'node', node: 0 });
    const [x, y] = seen(driver)[0]!.at;
    driver.down(x, y);
    driver.move(x + 30, y);
    const shown = driver.state.preview!(driver)!;
    expect(driver.document).toBe(before);
    expect(skeletonAt(shown, driver.selection)!.graph.nodes[0]!.at[0]).toBeCloseTo(
      graph.nodes[0]!.at[0] + 10,
      6,
    );
    driver.up();
    expect(driver.state.name).toBe('select.idle');
    expect(groupOf(driver).skeleton!.nodes[0]!.at[0]).toBeCloseTo(graph.nodes[0]!.at[0] + 10, 6);
    driver.undo();
    expect(driver.document).toBe(before);
  });

  test('cancelled, nothing was', () => {
    const driver = hand();
    const before = driver.document;
    take(driver, { kind: 'node', node: 0 });
    driver.down(400, 300);
    driver.move(500, 300);
    driver.cancel();
    expect(driver.document).toBe(before);
    expect(driver.state).toBe(selecting);
  });

  test('a rim that goes 15 px out is 5 mm wider; by the middle it is to the right and up', () => {
    for (const kind of ['rim', 'radius'] as const) {
      const driver = hand();
      const { radius } = at(driver).graph.nodes[0]!;
      const { at: middle, radius: px } = seen(driver)[0]!;
      const x = middle[0] + (kind === 'rim' ? px : 0);
      take(driver, { kind, node: 0 });
      driver.down(x, middle[1]);
      driver.move(x + 15, middle[1]);
      driver.up();
      expect(groupOf(driver).skeleton!.nodes[0]!.radius).toBeCloseTo(radius + 5, 6);
    }
  });

  test('a tap splits a link where it is, a drag takes the new node along; it is chosen', () => {
    const driver = hand();
    const taps = take(driver, { kind: 'link', link: 0 });
    driver.down(430, 320);
    driver.up();
    const { nodes, links } = groupOf(driver).skeleton!;
    expect([nodes.length, links.length]).toEqual([3, 2]);
    expect(nodes[2]!.at[0]).toBeCloseTo(0, 6);
    expect(taps.at(-1)!.node).toBe(2);
    take(driver, { kind: 'link', link: 0 });
    driver.down(430, 350);
    driver.move(460, 350);
    driver.up();
    expect(groupOf(driver).skeleton!.nodes[3]!.at[0]).toBeCloseTo(10, 6);
  });

  test('a node grows out of another one', () => {
    const driver = hand();
    take(driver, { kind: 'branch', node: 0 });
    const [x, y] = seen(driver)[0]!.at;
    driver.down(x, y);
    driver.move(x + 60, y);
    driver.up();
    const { nodes, links } = groupOf(driver).skeleton!;
    expect(links).toContainEqual([0, 2]);
    expect(nodes[2]!.at[0]).toBeCloseTo(nodes[0]!.at[0] + 20, 6);
  });

  test('a tap chooses, a second one soon after makes it as the strokes say', () => {
    const driver = hand();
    driver.commit([{ type: 'editSkeleton', id: groupOf(driver).id, skeleton: at(driver).graph }]);
    const taps = take(driver, { kind: 'node', node: 1 });
    driver.down(400, 300);
    driver.up();
    expect(taps).toEqual([{ node: 1, time: 0 }]);
    expect(groupOf(driver).skeleton).not.toBeNull();
    take(driver, { kind: 'node', node: 1 }, taps[0]!);
    driver.down(400, 300);
    driver.up();
    expect(groupOf(driver).skeleton).toBeNull();
  });

  test('seen edge-on nothing goes anywhere', () => {
    const driver = hand();
    driver.view = { ...driver.view, rotation: [0, Math.SQRT1_2, 0, Math.SQRT1_2] };
    const { graph } = at(driver);
    take(driver, { kind: 'node', node: 0 });
    driver.down(400, 300);
    driver.move(460, 300);
    driver.up();
    expect(groupOf(driver).skeleton).toBeNull();
    expect(at(driver).graph).toBe(graph);
  });
});
