/** What a pen points at on a body, from the triangles, against intervals and sums in float64 along the same ray; strokes that start there. */
import { expect, test } from 'vitest';
import type { BodyPart } from '../../src/document/document.ts';
import { pickedOn } from '../../src/element/exactPick.ts';
import { bindField } from '../../src/field/bind.ts';
import { polygonize } from '../../src/field/polygonize.ts';
import { place3 } from '../../src/math/placement.ts';
import { dot3, length3, rotate3, scale3, sub3 } from '../../src/math/tuple.ts';
import type { Vec3 } from '../../src/math/vec.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
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
