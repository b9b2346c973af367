/**
 * The loops around every cube (cubeLoops.ts) as a table for WGSL, made by following them: for each mask of inside corners and each
 * way in which its open faces may be decided a row, so that both processors triangulate alike by construction.
 */
import { CubeLoops, FACES, isOpen, MOST_CROSSINGS } from '../../field/cubeLoops.ts';

/** numbers of a row */
const ROW = 4;

interface Case {
  readonly mask: number;
  /** as CubeLoops.follow takes it */
  readonly joined: number;
}

/** Rows are ascending by mask; among those of a mask bit i of the number is the i-th open face. */
const CASES: readonly Case[] = Array.from({ length: 256 }, (_, mask) => {
  const open = FACES.flatMap((face, number) => (isOpen(face, mask) ? [number] : []));
  return Array.from({ length: 1 << open.length }, (_, choice) => ({
    mask,
    joined: open.reduce((bits, face, i) => bits | (((choice >> i) & 1) << face), 0),
  }));
}).flat();

/** `loop_table`, its length, and the corners of faces; the rows are in shaders/polygonize/loops.wgsl. */
export function loopModule(): string {
  const corners = FACES.map((face) => `vec4u(${face.corners.map((corner) => `${corner}u`).join(', ')})`);
  return [
    `const FACE_CORNERS = array<vec4u, 6>(\n  ${corners.join(',\n  ')},\n);\n`,
    `@group(0) @binding(9) var<uniform> loop_table: array<vec4u, ${CASES.length}>;\n`,
  ].join('');
}

/**
 * Four numbers a row: twelve edges of four bits (the first eight in the first number), then in the upper half of the second where
 * each loop ends; loops, which of them are twisted (from bit 4 on), triangles (8), vertices in the middle (16); and row m < 256 says
 * where the rows of mask m begin.
 */
export function loopTable(): Uint32Array<ArrayBuffer> {
  const table = new Uint32Array(ROW * CASES.length);
  const loops = new CubeLoops();
  CASES.forEach(({ mask, joined }, row) => {
    loops.follow(mask, joined);
    table.set(rowOf(loops), ROW * row);
  });
  CASES.forEach(({ mask }, row) => {
    if (CASES[row - 1]?.mask !== mask) table[ROW * mask + 3] = row;
  });
  return table;
}

function rowOf({ edges, ends, count, isTwisted }: CubeLoops): readonly number[] {
  const nibbles = new Array<number>(16).fill(0);
  const total = count > 0 ? ends[count - 1]! : 0;
  for (let i = 0; i < total; i++) nibbles[i] = packedEdge(edges[i]!);
  let [twisted, triangles, middles] = [0, 0, 0];
  for (let loop = 0; loop < count; loop++) {
    const length = ends[loop]! - (loop > 0 ? ends[loop - 1]! : 0);
    nibbles[MOST_CROSSINGS + loop] = ends[loop]!;
    twisted |= isTwisted[loop]! << loop;
    triangles += isTwisted[loop] ? length : length - 2;
    middles += isTwisted[loop]!;
  }
  const eight = (first: number) =>
    nibbles.slice(first, first + 8).reduce((word, nibble, i) => word | (nibble << (4 * i)), 0);
  return [eight(0), eight(8), count | (twisted << 4) | (triangles << 8) | (middles << 16)];
}

/** Axis and the two bits of the corner that are not along it: 12 edges in four bits. */
function packedEdge(edge: number): number {
  const [corner, axis] = [edge & 7, edge >> 3];
  const below = corner & ((1 << axis) - 1);
  return (axis << 2) | below | ((corner >> (axis + 1)) << axis);
}
