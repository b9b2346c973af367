/**
 * Tree to mesh of 64 segments against the MarchingCubes addon of three.js with 45 metaballs, both at 128 cells, in turn. The balls are
 * those of the addon's own example at one moment; a frame there is: clear, add the balls, polygonize.
 */
import { MeshBasicMaterial } from 'three';
import { MarchingCubes } from 'three/addons/objects/MarchingCubes.js';
import { bindField } from '../../src/field/bind.ts';
import { polygonize } from '../../src/field/polygonize.ts';
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

export function timeMetaballs(): void {
  const cubes = new MarchingCubes(CELLS, new MeshBasicMaterial(), false, false, MOST_TRIANGLES);
  const node = sceneNode('tree64');
  const triangles = { three: 0, ours: 0 };
  const least = leastOf(ROUNDS, {
    three() {
      cubes.reset();
      addBalls(cubes);
      cubes.update();
      triangles.three = cubes.count / 3;
      return triangles.three;
    },
    ours() {
      triangles.ours = polygonize(bindField(node), CELLS).mesh.indices.length / 3;
      return triangles.ours;
    },
  });
  console.log(`\nEnd to end, ${CELLS} cells`);
  console.table({
    'three.js, 45 metaballs': { ms: rounded(least.three), triangles: triangles.three },
    'ours, 64 segments': { ms: rounded(least.ours), triangles: triangles.ours },
    'ours / three.js': { ms: rounded(least.ours / least.three, 2) },
  });
}
