import { describe, expect, it } from 'vitest';
import { Heap } from '../../src/gpu/heap.ts';
import { EDGE, PROGRAM, TERM } from '../../src/gpu/structs.ts';

const edge = (n: number) => ({ start: [n, 0], end: [0, n], u: [1, 0], length: n });

describe('a heap', () => {
  it('keeps records of all kinds one after the other, however many they become', () => {
    const heap = new Heap();
    const program = heap.add(PROGRAM, { first: 0, end: 0 });
    const places = Array.from({ length: 1000 }, (_, i) => heap.add(EDGE, edge(i)));
    heap.put(PROGRAM, program, { first: places[0]!, end: heap.next });
    const bytes = heap.bytes();
    expect(bytes.byteLength).toBe(PROGRAM.stride + 1000 * EDGE.stride);
    expect(PROGRAM.read(new DataView(bytes), 0)).toEqual({ first: 1, end: 1 + (1000 * EDGE.stride) / 16 });
    for (const i of [0, 1, 500, 999]) {
      expect(EDGE.read(new DataView(bytes, 16 * places[i]!), 0)).toEqual(edge(i));
    }
  });

  it('begins every record at a multiple of 16 bytes', () => {
    for (const layout of [PROGRAM, EDGE, TERM]) {
      expect(layout.stride % 16).toBe(0);
      expect(layout.stride).toBeGreaterThanOrEqual(layout.size);
    }
  });
});
