/** The mesh that the CPU makes of all values of a lattice. */
import { type Lattice, nodeCount } from '../../../src/field/lattice.ts';
import { type FieldMesh, meshing } from '../../../src/field/latticeMesh.ts';
import type { TreeField } from '../../../src/field/treeField.ts';

export function valuesOf(field: TreeField, lattice: Lattice): Float64Array {
  const { origin, step, counts } = lattice;
  const [nx, ny] = counts;
  return Float64Array.from({ length: nodeCount(lattice) }, (_, node) => {
    const place = [node % nx, Math.floor(node / nx) % ny, Math.floor(node / (nx * ny))];
    const [x, y, z] = place.map((n, axis) => origin[axis]! + n * step);
    return field.value(x!, y!, z!);
  });
}

export function onCpu(field: TreeField, lattice: Lattice): FieldMesh {
  const steps = meshing(field, lattice, valuesOf(field, lattice));
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}
