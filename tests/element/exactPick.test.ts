/** What a pen points at on a body, from the triangles, against intervals and sums in float64 along the same ray; strokes that start there. */
import { expect, test } from 'vitest';
import type { BodyPart } from '../../src/document/document.ts';
import { isCastable, pickedAmong, pickedOn } from '../../src/element/exactPick.ts';
import { bindField } from '../../src/field/bind.ts';
import { polygonize } from '../../src/field/polygonize.ts';
import type { RayCamera } from '../../src/field/rayImage.ts';
import { place3, UNMOVED } from '../../src/math/placement.ts';
import { dot3, length3, rotate3, scale3, sub3, unrotate3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { rayAt } from '../../src/stroke/plane.ts';
import { firstHit } from '../field/rays.ts';
import { BONE, body } from '../field/trees.ts';

const CELLS = 32;
const NODE = body(BONE, 1);
const PLACEMENT = { rotation: [0.5, 0.1, 0, Math.sqrt(0.74)], translation: [10, -5, 3] } as const;
const PART = { id: 'bone', kind: 'body', node: NODE, placement: PLACEMENT } as unknown as BodyPart;
const field = bindField(NODE);
const { mesh } = polygonize(field, CELLS);

/** mm along the ray to the nearest triangle. */
function ontoTriangles({ positions, indices }: Mesh, from: Vec3, along: Vec3): number {
  const corner = (i: number): Vec3 =>
    [0, 1, 2].map((axis) => positions[3 * indices[i]! + axis]!) as unknown as Vec3;
  let nearest = Infinity;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
    const [u, v, to] = [sub3(b, a), sub3(c, a), sub3(a, from)];
    const cross = (p: Vec3, q: Vec3): Vec3 => [
      p[1] * q[2] - p[2] * q[1],
      p[2] * q[0] - p[0] * q[2],
      p[0] * q[1] - p[1] * q[0],
    ];
    const normal = cross(u, v);
    const t = dot3(to, normal) / dot3(along, normal);
    const off = sub3(scale3(along, t), to);
    const [s, r] = [dot3(cross(off, v), normal), dot3(cross(u, off), normal)];
    const whole = dot3(normal, normal);
    if (s >= 0 && r >= 0 && s + r <= whole && t > 0) nearest = Math.min(nearest, t);
  }
  return nearest;
}

test('position, normal and skel are those of the surface itself', () => {
  const along: Vec3 = scale3([0.2, -0.1, -1], 1 / length3([0.2, -0.1, -1]));
  const skels = NODE.skels.map((term) => bindField({ ...NODE, skels: [term] }));
  const kinds = new Set<string>();
  let [hits, beside] = [0, 0];
  for (let i = 0; i < 400; i++) {
    const from: Vec3 = [(i % 20) - 9.6 - 4, Math.floor(i / 20) - 9.6 + 2, 20];
    const near = ontoTriangles(mesh, from, along);
    const truth = firstHit(field, { from, along, nearest: 0, pixel: 1, growth: 0 }, 0, 60, 1e-4).t;
    if (near === Infinity || truth === null || Math.abs(near - truth) > 0.4) continue;
    hits++;
    const local = [0, 1, 2].map((axis) => from[axis]! + near * along[axis]!) as unknown as Vec3;
    const ray = { origin: place3(PLACEMENT, from), direction: rotate3(PLACEMENT.rotation, along) };
    const hit = { id: 'bone', point: place3(PLACEMENT, local), normal: [0, 0, 1] as const };
    const picked = pickedOn(hit, PART, ray, { mesh, cells: CELLS });
    const exact = [0, 1, 2].map((axis) => from[axis]! + truth * along[axis]!) as unknown as Vec3;
    // the ray is in and out again within an eighth of a cell
    if (picked.normal === hit.normal) {
      beside++;
      continue;
    }
    expect(length3(sub3(picked.point, place3(PLACEMENT, exact)))).toBeLessThan(1e-6);
    const slope = new Float64Array(4);
    field.evaluate(...exact, slope);
    const outward = rotate3(PLACEMENT.rotation, [-slope[1]!, -slope[2]!, -slope[3]!]);
    expect(dot3(picked.normal, outward) / length3(outward)).toBeCloseTo(1, 9);
    const parts = skels.map((skel) => skel.value(...exact) + NODE.threshold);
    const most = parts.indexOf(Math.max(...parts));
    expect(picked.skel?.path).toBe(`skels[${most}]`);
    expect(picked.skel?.share).toBeCloseTo(parts[most]! / parts.reduce((sum, part) => sum + part), 6);
    kinds.add(picked.skel!.path);
  }
  expect(hits).toBeGreaterThan(40);
  expect(beside).toBeLessThan(0.05 * hits);
  expect(kinds.size).toBeGreaterThan(1);
});

test('beside an outline, where only triangles are, the place is theirs, and still of a skel', () => {
  const hit = { id: 'bone', point: place3(PLACEMENT, [0, 30, 0]), normal: [0, 1, 0] as const };
  const ray = { origin: [0, 0, 90], direction: [0, 0, -1] } as const;
  const picked = pickedOn(hit, PART, ray, { mesh, cells: CELLS });
  expect(picked).toMatchObject(hit);
  expect(picked.skel).not.toBeNull();
});

const VIEW = { pivot: [10, -5, 3], rotation: [0.1, 0.2, 0, Math.sqrt(0.95)], height: 40 } as const;
const looking = (fov: number): RayCamera => ({
  view: { ...VIEW, height: 14, fov },
  width: 60,
  height: 40,
  offset: [0, 0],
});

test.each([0, 40])('a ray of its own meets the surface, without any triangles, opening %d°', (fov) => {
  const camera = looking(fov);
  let hits = 0;
  for (let i = 0; i < 150; i++) {
    const at = [4 * (i % 15) + 2.3, 4 * Math.floor(i / 15) + 1.7] as const;
    const picked = pickedAmong([PART], null, camera, at);
    const { origin: eye, direction } = rayAt(camera.view, camera, ...at);
    // 50 mm before the body: without an eye rays start far away
    const origin = sub3(
      eye,
      scale3(direction, dot3(sub3(eye, VIEW.pivot), direction) + (fov === 0 ? 50 : 0)),
    );
    const from = unrotate3(PLACEMENT.rotation, sub3(origin, PLACEMENT.translation));
    const along = unrotate3(PLACEMENT.rotation, direction);
    const ray = { from, along, nearest: 0, pixel: 1, growth: 0 };
    const truth = firstHit(field, ray, fov === 0 ? 0 : -15, 100, 1e-4).t;
    // beside an outline what is within half a pixel is met
    const off = picked && sub3(picked.point, origin);
    const aside = off ? length3(sub3(off, scale3(direction, dot3(off, direction)))) : 0;
    expect(aside).toBeLessThan(0.5 * (14 / 40) * 1.2);
    if (truth === null) continue;
    hits++;
    const exact = [0, 1, 2].map((axis) => from[axis]! + truth * along[axis]!) as unknown as Vec3;
    expect(length3(sub3(picked!.point, place3(PLACEMENT, exact)))).toBeLessThan(1e-4);
    expect(dot3(picked!.normal, direction)).toBeLessThan(0.01);
    expect(picked!.skel).not.toBeNull();
  }
  expect(hits).toBeGreaterThan(10);
});

test('what triangles miss is picked: a needle of a tenth of a pixel, before another body', () => {
  const needle = {
    ...PART,
    id: 'needle',
    placement: { rotation: [0, 0, 0, 1], translation: [10, -5, 30] },
    node: { type: 'shape', shape: { type: 'capsule', radius: 0.05, half: 15 } },
  } as unknown as BodyPart;
  const camera: RayCamera = { ...looking(0), view: { ...VIEW, rotation: [0, 0, 0, 1], fov: 0 } };
  let on = 0;
  for (const x of [29.6, 29.8, 30, 30.2, 30.4])
    for (const bodies of [[PART, needle], [needle, PART], [needle]])
      if (pickedAmong(bodies, null, camera, [x, 20])?.id === 'needle') on++;
  expect(on).toBe(15);
  expect(pickedAmong([needle], null, camera, [32, 20])).toBeNull();
});

test('the nearest is picked, be it a body or something else', () => {
  const camera: RayCamera = { ...looking(0), view: { ...VIEW, rotation: [0, 0, 0, 1], fov: 0 } };
  const middle = [30, 20] as const;
  const ball = { ...PART, placement: { ...UNMOVED, translation: [10, -5, 3] }, id: 'ball' } as BodyPart;
  const round = { ...ball, node: { type: 'shape', shape: { type: 'sphere', radius: 5 } } } as BodyPart;
  const tube = (z: number) => ({ id: 'tube', point: [10, -5, z], normal: [0, 0, 1] }) as const;
  expect(pickedAmong([round], tube(9), camera, middle)).toEqual({ ...tube(9), skel: null });
  expect(pickedAmong([round], tube(7), camera, middle)?.id).toBe('ball');
  expect(pickedAmong([], tube(7), camera, middle)?.id).toBe('tube');
});

test('a tree without a field is left to its triangles', () => {
  const bad = { ...PART, node: { ...NODE, kernel: 'nobody' } } as unknown as BodyPart;
  expect(isCastable(bad)).toBe(false);
  expect(isCastable(PART)).toBe(true);
});
