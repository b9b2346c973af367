/**
 * From outlines to surfaces on one thread, by the processor's time: skeletons and fits of outlines with 100 and 1,000 points, and what
 * lies between pen-up and the surfaces of the solids among the samples, beside Tai et al. 2004 (table 1, Pentium IV of 2.4 GHz) and
 * Zhu et al. 2011 (table 2, quartic and Cauchy: 128³ values of plates of 69 and 223 vertices, one core of 2.67 GHz).
 */
import { readFileSync } from 'node:fs';
import { makeBody } from '../../src/document/bodies.ts';
import { bodiesOf } from '../../src/document/fieldParts.ts';
import { parse } from '../../src/document/serialize.ts';
import { DRAFT } from '../../src/field/fieldWork.ts';
import { kernelNamed } from '../../src/kernel/index.ts';
import { cos, PI, sin } from '../../src/math/trig.ts';
import type { Vec2 } from '../../src/math/vec.ts';
import { silhouetteOf, skeletonOf } from '../../src/skeleton/medial/silhouette.ts';
import { processorTime } from './timing.ts';

const CELLS = 128;

/** Five soft arms. */
const star = (count: number): Vec2[] =>
  Array.from({ length: count }, (_, i) => {
    const angle = (2 * PI * i) / count;
    const radius = 40 + 15 * cos(5 * angle);
    return [radius * cos(angle), radius * sin(angle)];
  });

const cauchy = kernelNamed('cauchy')!;
// the first calls are slow whatever they do
processorTime(() => silhouetteOf([star(300)], cauchy, {}, 0.5), 20);
console.log('Outlines, ms');
console.table(
  [100, 1000].map((points) => {
    const loops = [star(points)];
    return {
      points,
      skeleton: processorTime(() => skeletonOf(loops)),
      'skeleton, weights and places': processorTime(() => silhouetteOf(loops, cauchy, {}, 0.5)),
      'while the pen moves': processorTime(() => silhouetteOf(loops, cauchy, {}, 0.5, { quick: true })),
    };
  }),
);

/** seconds of their tables, at the finer of two resolutions */
const THEIRS: Readonly<Record<string, string>> = {
  rabbit: 'ConvMo 31.6 s, 178 skels',
  mouse: 'ConvMo 14.7 s, 95 skels',
  cup: 'ConvMo 27.4 s, 74 skels',
  chairs: 'Zhu 2.8 to 287 s; ConvMo’s chair 6.1 s, 32 skels',
  pretzel: '',
};

console.log(
  `Solids, ms: their fields, and coarse and fine (${CELLS} cells) surfaces after the pen was lifted`,
);
console.table(
  Object.entries(THEIRS).map(([name, theirs]) => {
    const text = readFileSync(`public/samples/${name}.rotund`, 'utf8');
    const nodes = () => bodiesOf(parse(text, name).document).map(({ node }) => node);
    const meshed = (cells: number) => nodes().map((node) => makeBody(node, cells).mesh);
    const fields = processorTime(nodes, 2);
    return {
      name,
      fields,
      coarse: processorTime(() => meshed(DRAFT), 2),
      fine: processorTime(() => meshed(CELLS), 1),
      triangles: meshed(CELLS).reduce((sum, { indices }) => sum + indices.length / 3, 0),
      theirs,
    };
  }),
);
