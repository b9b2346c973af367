/** A finer body comes gently, with a scene that only remembers what it is told. */
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { FieldStage } from '../../../src/element/field/fieldStage.ts';
import type { FieldMesh } from '../../../src/field/brickMesh.ts';
import type { Box } from '../../../src/mesh/mesh.ts';
import { DEFAULT_LOOK, type DeviceMesh, type Scene, type SceneItem } from '../../../src/scene/index.ts';
import { FRONT_VIEW } from '../../../src/scene/view.ts';

let now = 0;
let asked: FrameRequestCallback | null = null;
/** what each frame showed of the body before */
let shares: number[] = [];
let view = FRONT_VIEW;

/** what the scene was given last */
let shown: readonly SceneItem[] = [];
let fitted: Box[] = [];

/** The next frame, if one is asked for, some ms later. */
function frame(later: number): boolean {
  const draw = asked;
  now += later;
  asked = null;
  draw?.(now);
  return draw !== null;
}

function body(): FieldMesh {
  const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  const rest = { normals: positions, colours: positions, uvs: new Float32Array(6) };
  return { positions, indices: new Uint32Array([0, 1, 2]), ...rest };
}

function sceneOf({ reducedMotion = false, software = false } = {}): Scene {
  const fit = (box: Box) => fitted.push(box);
  const sync = (items: readonly SceneItem[]) => {
    shown = items;
  };
  const rig = { reducedMotion, view: () => view, setView() {}, fit, update: () => false };
  const calls = { setLook() {}, resize() {}, sync, render() {}, dispose() {}, keep: () => true };
  return {
    rig,
    ...calls,
    description: { software },
    fade: (share: number) => shares.push(share),
  } as unknown as Scene;
}

function staged(how: Parameters<typeof sceneOf>[0] = {}): FieldStage {
  const stage = new FieldStage(DEFAULT_LOOK, () => {});
  stage.attach(sceneOf(how), how.reducedMotion ?? false);
  stage.show(body(), 'never');
  while (frame(16));
  shares = [];
  return stage;
}

beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', (callback: FrameRequestCallback) => {
    asked = callback;
    return 1;
  });
  vi.stubGlobal('cancelAnimationFrame', () => {
    asked = null;
  });
  view = FRONT_VIEW;
  now = 1000;
});
afterEach(() => void vi.unstubAllGlobals());

test('the body before goes within 120 ms, and then nothing is drawn any more', () => {
  const stage = staged();
  now += 5000;
  stage.show(body(), 'never', true);
  let frames = 0;
  while (frame(20)) frames++;
  expect(frames).toBeLessThanOrEqual(7);
  expect(shares.at(-1)).toBe(0);
  expect(shares[0]).toBeGreaterThan(0.8);
  for (const [i, share] of shares.slice(1).entries()) expect(share).toBeLessThan(shares[i]!);
});

test.each([
  ['another body', {}, false],
  ['motion is unwelcome', { reducedMotion: true }, true],
  ['frames are slow', { software: true }, true],
] as const)('it is gone at once: %s', (_, how, refines) => {
  const stage = staged(how);
  stage.show(body(), 'never', refines);
  while (frame(20));
  expect(shares).toEqual([0]);
});

test('a hand on the camera ends it: the picture before is of another view', () => {
  const stage = staged();
  stage.show(body(), 'never', true);
  frame(20);
  view = { ...view, height: 100 };
  frame(20);
  expect(shares[0]).toBeGreaterThan(0);
  expect(shares[1]).toBe(0);
  expect(frame(20)).toBe(false);
});

test('what was not yet seen does not go gently', () => {
  const stage = staged();
  stage.show(body(), 'never');
  stage.show(body(), 'never', true);
  while (frame(20));
  expect(shares).toEqual([0]);
});

test('a body on the device is fitted by its box, and goes with the device', () => {
  const stage = staged();
  stage.resize(100, 100, 1);
  const mesh = { draw: {}, box: { min: [-10, -20, -30], max: [10, 20, 30] } } as unknown as DeviceMesh;
  fitted = [];
  stage.show(mesh, 'covered');
  expect(shown.map((item) => item.mesh)).toEqual([mesh]);
  expect(fitted).toEqual([mesh.box]);
  stage.detach();
  stage.attach(sceneOf(), false);
  expect(shown).toEqual([]);
  stage.show(mesh, 'never');
  expect(shown.map((item) => item.mesh)).toEqual([mesh]);
});

test('a body on the device is covered where a corner of its box is', () => {
  const stage = staged();
  stage.resize(100, 100, 1);
  const of = (x: number) =>
    ({ draw: {}, box: { min: [-20, -20, -20], max: [x, 20, 20] } }) as unknown as DeviceMesh;
  stage.show(of(20), 'always');
  fitted = [];
  // 200 mm are seen, a tenth at each side is for the controls
  stage.show(of(28), 'covered');
  expect(fitted).toEqual([]);
  view = { ...view, height: 60 };
  stage.show(of(20), 'never');
  stage.show(of(28), 'covered');
  expect(fitted.length).toBe(1);
});
