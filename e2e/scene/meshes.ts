/** Forms to test pictures with, whose outlines are known by formula. mm. */
import type { Vec3 } from '../../src/math/vec.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';

export type Form =
  | { readonly kind: 'cube'; readonly side: number }
  | { readonly kind: 'sphere'; readonly radius: number; readonly centre?: Vec3; readonly rings?: number }
  | { readonly kind: 'disc'; readonly radius: number; readonly centre: Vec3 }
  | { readonly kind: 'cone'; readonly radius: number; readonly height: number }
  | { readonly kind: 'pear' }
  | { readonly kind: 'stem' }
  | { readonly kind: 'leaf' };

export function makeMesh(form: Form): Mesh {
  switch (form.kind) {
    case 'cube':
      return cube(form.side);
    case 'sphere':
      return sphere(form.radius, form.centre ?? [0, 0, 0], form.rings ?? 48);
    case 'disc':
      return disc(form.radius, form.centre);
    case 'cone':
      return revolve(
        [
          [form.radius, 0],
          [0.5 * form.radius, 0.5 * form.height],
          [0, form.height],
        ],
        64,
      );
    case 'pear':
      return revolve(PEAR, 96);
    case 'stem':
      return tube(STEM, 5, 4, 32);
    case 'leaf':
      return leaf();
  }
}

/** Six squares with their own vertices, so that all edges are creases. */
function cube(side: number): Mesh {
  const h = side / 2;
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (let axis = 0; axis < 3; axis++) {
    for (const sign of [-1, 1]) {
      const first = positions.length / 3;
      for (const [a, b] of [
        [-h, -h],
        [h, -h],
        [h, h],
        [-h, h],
      ] as const) {
        const corner = [0, 0, 0];
        const normal = [0, 0, 0];
        corner[axis] = sign * h;
        corner[(axis + 1) % 3] = a;
        corner[(axis + 2) % 3] = b;
        normal[axis] = sign;
        positions.push(...corner);
        normals.push(...normal);
      }
      const [i, j] = sign > 0 ? [1, 2] : [2, 1];
      indices.push(first, first + i, first + j, first, first + (i === 1 ? 2 : 3), first + (i === 1 ? 3 : 2));
    }
  }
  return mesh(positions, normals, indices);
}

function sphere(radius: number, [x, y, z]: Vec3, rings: number): Mesh {
  return grid(rings * 2, rings, (u, v) => {
    const theta = 2 * Math.PI * u;
    const phi = Math.PI * v;
    const n: Vec3 = [Math.sin(phi) * Math.cos(theta), -Math.cos(phi), -Math.sin(phi) * Math.sin(theta)];
    return [[x + radius * n[0], y + radius * n[1], z + radius * n[2]], n];
  });
}

/** Faces +z, seen from both sides. */
function disc(radius: number, [x, y, z]: Vec3): Mesh {
  return grid(96, 1, (u, v) => {
    const angle = 2 * Math.PI * u;
    return [
      [x + radius * v * Math.cos(angle), y + radius * v * Math.sin(angle), z],
      [0, 0, 1],
    ];
  });
}

/** Radius and height, from the bottom up: a belly and a head, drawn into one. */
const PEAR: readonly (readonly [number, number])[] = Array.from({ length: 97 }, (_, i) => {
  const angle = (Math.PI * i) / 96;
  const height = -Math.cos(angle);
  const belly = 1 / (1 + Math.exp(7 * (height - 0.28)));
  return [Math.sin(angle) * (21 + 25 * belly) * (1 + 0.12 * belly), 55 * height - 10] as const;
});

const STEM = (t: number): Vec3 => [2 + 14 * t * t, 46 + 34 * t, 0];

function revolve(profile: readonly (readonly [number, number])[], sides: number): Mesh {
  const last = profile.length - 1;
  const at = (i: number) => profile[Math.min(last, Math.max(0, i))] ?? [0, 0];
  return grid(sides, last, (u, v) => {
    const i = Math.round(v * last);
    const [radius, height] = at(i);
    const [r0, h0] = at(i - 1);
    const [r1, h1] = at(i + 1);
    const length = Math.hypot(r1 - r0, h1 - h0) || 1;
    const angle = 2 * Math.PI * u;
    const out = (h1 - h0) / length;
    return [
      [radius * Math.cos(angle), height, -radius * Math.sin(angle)],
      [out * Math.cos(angle), (r0 - r1) / length, -out * Math.sin(angle)],
    ];
  });
}

/** A tube in the xy plane with flat ends. */
function tube(centre: (t: number) => Vec3, from: number, to: number, sides: number): Mesh {
  const steps = 24;
  const frame = (t: number) => {
    const [x0, y0] = centre(t - 0.01);
    const [x1, y1] = centre(t + 0.01);
    const length = Math.hypot(x1 - x0, y1 - y0);
    return { along: [(x1 - x0) / length, (y1 - y0) / length, 0] as Vec3, middle: centre(t) };
  };
  const wall = grid(sides, steps, (u, v) => {
    const { along, middle } = frame(v);
    const angle = 2 * Math.PI * u;
    const n: Vec3 = [along[1] * Math.cos(angle), -along[0] * Math.cos(angle), -Math.sin(angle)];
    const r = from + (to - from) * v;
    return [[middle[0] + r * n[0], middle[1] + r * n[1], r * n[2]], n];
  });
  const { along, middle } = frame(1);
  const cap = grid(sides, 1, (u, v) => {
    const angle = 2 * Math.PI * u;
    const r = to * (1 - v);
    const n = [along[1] * Math.cos(angle), -along[0] * Math.cos(angle), -Math.sin(angle)] as const;
    return [[middle[0] + r * n[0], middle[1] + r * n[1], r * n[2]], along];
  });
  return joined(wall, cap);
}

/** A thin cupped sheet: an open surface, seen from both sides. */
function leaf(): Mesh {
  return grid(48, 24, (u, v) => {
    const half = 17 * Math.sin(Math.PI * u) ** 0.8;
    const across = 2 * v - 1;
    const point: Vec3 = [
      16 + 62 * u * 0.93 - 6 * across * Math.sin(Math.PI * u),
      74 + 26 * Math.sin(2.2 * u) - 16 * u + across * half,
      6 - 9 * across * across * Math.sin(Math.PI * u),
    ];
    const slope = (18 * across * Math.sin(Math.PI * u)) / Math.max(half, 1);
    const length = Math.hypot(slope, 1);
    return [point, [0, slope / length, 1 / length]];
  });
}

type Vertex = readonly [position: Vec3, normal: Vec3];

/** Columns × rows of quads; outward is to the left of u, when v goes up. */
function grid(columns: number, rows: number, vertex: (u: number, v: number) => Vertex): Mesh {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (let j = 0; j <= rows; j++) {
    for (let i = 0; i <= columns; i++) {
      const [position, normal] = vertex(i / columns, j / rows);
      positions.push(...position);
      normals.push(...normal);
      if (i === columns || j === rows) continue;
      const a = j * (columns + 1) + i;
      const b = a + columns + 1;
      indices.push(a, a + 1, b, b, a + 1, b + 1);
    }
  }
  return mesh(positions, normals, indices);
}

function joined(a: Mesh, b: Mesh): Mesh {
  const first = a.positions.length / 3;
  return mesh(
    [...a.positions, ...b.positions],
    [...a.normals, ...b.normals],
    [...a.indices, ...[...b.indices].map((i) => i + first)],
  );
}

function mesh(positions: number[], normals: number[], indices: number[]): Mesh {
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    uvs: new Float32Array((positions.length / 3) * 2),
    indices: new Uint32Array(indices),
  };
}
