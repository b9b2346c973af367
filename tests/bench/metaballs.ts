/**
 * Tree to mesh of 64 segments against the MarchingCubes addon of three.js with 45 metaballs, in turn. The balls are those of the addon's
 * own example at one moment; a frame there is: clear, add the balls, polygonize 128³ cells of a cube that has air around them. Ours in a
 * cube likewise, 128³ cells of the scene's own box, and, what `rotund mesh` does, in 128 cells along the body, whose box is found first.
 */
import { MeshBasicMaterial } from 'three';
import { MarchingCubes } from 'three/addons/objects/MarchingCubes.js';
import { bindField } from '../../src/field/bind.ts';
import type { FieldMesh } from '../../src/field/brickMesh.ts';
import { culling } from '../../src/field/bricks.ts';
import type { Lattice } from '../../src/field/lattice.ts';
import { Tally } from '../../src/field/near.ts';
import type { FieldNode } from '../../src/field/node.ts';
import { meshing, polygonize } from '../../src/field/polygonize.ts';
import { finished } from '../field/finished.ts';
import { sceneNode } from './scenes/index.ts';
import { leastOf, rounded } from './timing.ts';

const CELLS = 128;
const BALLS = 45;
const ROUNDS = 12;
/** s, of the example's motion */
const TIME = 10;
const MOST_TRIANGLES = 400_000;

/** webgl_marchingcubes.html, updateCubes() */
function addBalls(cubes: MarchingCubes): void {
  const subtract = 12;
  const strength = 1.2 / ((Math.sqrt(BALLS) - 1) / 4 + 1);
  for (let i = 0; i < BALLS; i++) {
    const x = Math.sin(i + 1.26 * TIME * (1.03 + 0.5 * Math.cos(0.21 * i))) * 0.27 + 0.5;
    const y = Math.abs(Math.cos(i + 1.12 * TIME * Math.cos(1.22 + 0.1424 * i))) * 0.77;
    const z = Math.cos(i + 1.32 * TIME * 0.1 * Math.sin(0.92 + 0.53 * i)) * 0.27 + 0.5;
    cubes.addBall(x, y, z, strength, subtract);
  }
}

/** mm, half of the scene's own box (polygonizeBoxes.ts) */
const HALF = 1;

function inCube(node: FieldNode): FieldMesh {
  const nodes = CELLS + 1;
  const lattice: Lattice = {
    origin: [-HALF, -HALF, -HALF],
    step: (2 * HALF) / CELLS,
    counts: [nodes, nodes, nodes],
  };
  const tally = new Tally();
  const whole = bindField(node).near(tally);
  const bricks = finished(culling(whole, lattice));
  return finished(meshing({ whole, tally, bricks })).mesh;
}

export function timeMetaballs(): void {
  const cubes = new MarchingCubes(CELLS, new MeshBasicMaterial(), false, false, MOST_TRIANGLES);
  const node = sceneNode('tree64');
  const triangles = { three: 0, cube: 0, body: 0 };
  const least = leastOf(ROUNDS, {
    three() {
      cubes.reset();
      addBalls(cubes);
      cubes.update();
      triangles.three = cubes.count / 3;
      return triangles.three;
    },
    cube() {
      triangles.cube = inCube(node).indices.length / 3;
      return triangles.cube;
    },
    body() {
      triangles.body = polygonize(bindField(node), CELLS).mesh.indices.length / 3;
      return triangles.body;
    },
  });
  console.log(`\nEnd to end, ${CELLS} cells`);
  console.table({
    'three.js, 45 metaballs': { ms: rounded(least.three), triangles: triangles.three },
    'ours, 64 segments, cube': { ms: rounded(least.cube), triangles: triangles.cube },
    'ours, 64 segments, body': { ms: rounded(least.body), triangles: triangles.body },
    'cube / three.js': { ms: rounded(least.cube / least.three, 2) },
    'body / three.js': { ms: rounded(least.body / least.three, 2) },
  });
}
