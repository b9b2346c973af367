/**
 * The mesh of all values of a lattice, in the plainest way and in float64: the loops around each cube, vertices by bisection of the
 * field along the edges.
 */
import { CubeLoops } from '../../../src/field/cubeLoops.ts';
import type { Lattice } from '../../../src/field/lattice.ts';
import { eachTriangle } from '../../../src/field/loopTriangles.ts';
import type { TreeField } from '../../../src/field/treeField.ts';
import type { Mesh } from '../../../src/mesh/mesh.ts';
import { nodeCount } from '../../field/nodeCount.ts';

export interface PaintedMesh extends Mesh {
  readonly colours: Float32Array;
}

type Place = readonly [number, number, number];

/** parts of an edge that vertices are kept from its ends, as in WGSL and TypeScript */
const ENDS = 1e-4;

export function valuesOf(field: TreeField, lattice: Lattice): Float64Array {
  return Float64Array.from({ length: nodeCount(lattice) }, (_, node) =>
    field.value(...at(lattice, placeOf(lattice, node))),
  );
}

export function onCpu(field: TreeField, lattice: Lattice): PaintedMesh {
  const values = valuesOf(field, lattice);
  const made: Made = { positions: [], normals: [], colours: [], known: new Map() };
  const indices: number[] = [];
  const loops = new CubeLoops();
  const [nx, ny] = lattice.counts;
  const offsets = Array.from({ length: 8 }, (_, c) => (c & 1) + nx * (((c >> 1) & 1) + ny * (c >> 2)));
  const inside = Array.from(values, (value, node) => value > 0 && !isBorder(lattice, placeOf(lattice, node)));
  for (let node = 0; node < values.length - offsets[7]!; node++) {
    const place = placeOf(lattice, node);
    if (place.some((n, axis) => n === lattice.counts[axis]! - 1)) continue;
    const mask = offsets.reduce((bits, offset, c) => bits | (Number(inside[node + offset]) << c), 0);
    if (mask === 0 || mask === 255) continue;
    loops.trace(
      mask,
      offsets.map((offset) => values[node + offset]!),
    );
    for (let loop = 0, start = 0; loop < loops.count; start = loops.ends[loop++]!) {
      const ring = Array.from(loops.edges.subarray(start, loops.ends[loop]), (edge) =>
        vertexOn(made, field, lattice, values, node + offsets[edge & 7]!, edge >> 3),
      );
      const middle = loops.isTwisted[loop] ? addMean(made, ring) : null;
      eachTriangle(ring, middle, made.positions, (a, b, c) => indices.push(a, b, c));
    }
  }
  return {
    positions: Float32Array.from(made.positions),
    normals: Float32Array.from(made.normals),
    colours: Float32Array.from(made.colours),
    uvs: new Float32Array((2 * made.positions.length) / 3),
    indices: Uint32Array.from(indices),
  };
}

interface Made {
  readonly positions: number[];
  readonly normals: number[];
  readonly colours: number[];
  /** by 3 node + axis */
  readonly known: Map<number, number>;
}

function placeOf({ counts: [nx, ny] }: Lattice, node: number): Place {
  return [node % nx, Math.floor(node / nx) % ny, Math.floor(node / (nx * ny))];
}

function at({ origin, step }: Lattice, [i, j, k]: Place): Place {
  return [origin[0] + i * step, origin[1] + j * step, origin[2] + k * step];
}

const isBorder = ({ counts }: Lattice, place: Place) =>
  place.some((n, axis) => n === 0 || n === counts[axis]! - 1);

function vertexOn(
  made: Made,
  field: TreeField,
  lattice: Lattice,
  values: Float64Array,
  node: number,
  axis: number,
): number {
  const known = made.known.get(3 * node + axis);
  if (known !== undefined) return known;
  const next = node + [1, lattice.counts[0], lattice.counts[0] * lattice.counts[1]][axis]!;
  const start = at(lattice, placeOf(lattice, node));
  const along = (t: number) =>
    start.map((x, k) => (k === axis ? x + t * lattice.step : x)) as [number, number, number];
  const isFirst = values[node]! > 0;
  // where both are inside the body is cut off halfway
  const isCut = isFirst === values[next]! > 0;
  let [low, high] = isCut ? [0.5, 0.5] : [0, 1];
  for (let round = 0; low < high && round < 50; round++) {
    const t = 0.5 * (low + high);
    if (field.value(...along(t)) > 0 === isFirst) low = t;
    else high = t;
  }
  const point = along(Math.min(Math.max(low, ENDS), 1 - ENDS));
  const [out, paint] = [new Float64Array(4), new Float64Array(3)];
  field.evaluate(...point, out);
  field.colour(...point, paint);
  if (isCut) out.set(intoBorder(lattice, placeOf(lattice, node), axis), 1);
  const steep = Math.hypot(out[1]!, out[2]!, out[3]!);
  made.known.set(3 * node + axis, made.positions.length / 3);
  made.positions.push(...point);
  made.normals.push(-out[1]! / steep, -out[2]! / steep, -out[3]! / steep);
  made.colours.push(...paint);
  return made.positions.length / 3 - 1;
}

/** The slope of what is cut off: it falls towards the side of the lattice that the edge ends at. */
function intoBorder(lattice: Lattice, first: Place, axis: number): Place {
  const slope = [0, 0, 0] as [number, number, number];
  slope[axis] = isBorder(lattice, first) ? 1 : -1;
  return slope;
}

function addMean({ positions, normals, colours }: Made, ring: readonly number[]): number {
  for (const list of [positions, normals, colours]) {
    const mean = (axis: number) => ring.reduce((sum, v) => sum + list[3 * v + axis]!, 0) / ring.length;
    list.push(mean(0), mean(1), mean(2));
  }
  return positions.length / 3 - 1;
}
