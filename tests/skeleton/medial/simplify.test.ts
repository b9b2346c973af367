import { describe, expect, it } from 'vitest';
import { medialAxis } from '../../../src/skeleton/medial/axis.ts';
import { chainsOf, neighboursOf } from '../../../src/skeleton/medial/branches.ts';
import { prune } from '../../../src/skeleton/medial/prune.ts';
import { SIMPLIFYING, simplify } from '../../../src/skeleton/medial/simplify.ts';
import { even, plate, SHAPES, stadium } from '../../fixtures/silhouettes.ts';

const before = (shape: (typeof SHAPES)[string]) => {
  const loops = even(shape, 1.2);
  return prune(medialAxis(loops), loops);
};
const rings = ({ nodes, links }: ReturnType<typeof before>) => links.length - nodes.length;

describe('simplify', () => {
  it.each(Object.entries(SHAPES))(
    '%s: rings and ends stay, and circles lie between those that are left',
    (_, shape) => {
      const whole = before(shape);
      const few = simplify(whole, { ...SIMPLIFYING, joints: 0 });
      expect(rings(few)).toBe(rings(whole));
      const ends = (graph: typeof whole) =>
        neighboursOf(graph).filter((others) => others.length === 1).length;
      expect(ends(few)).toBe(ends(whole));
      const most = Math.max(...whole.nodes.map(({ radius }) => radius));
      for (const { at, radius } of whole.nodes) {
        const gaps = few.links.map(([a, b]) => gapTo(at, radius, few.nodes[a]!, few.nodes[b]!));
        if (gaps.length > 0)
          expect(Math.min(...gaps)).toBeLessThanOrEqual(SIMPLIFYING.deviation * most + 1e-9);
      }
    },
  );

  it('halves what is longer than its circles are wide', () => {
    const { nodes, links } = simplify(before([stadium(50, 4)]));
    for (const [a, b] of links) {
      const [p, q] = [nodes[a]!, nodes[b]!];
      const length = Math.hypot(p.at[0] - q.at[0], p.at[1] - q.at[1]);
      expect(length).toBeLessThan(SIMPLIFYING.longest * Math.max(p.radius, q.radius) + 1.2);
    }
  });

  it('joins joints that are close, and no ring goes (plate with 3 holes)', () => {
    const whole = before(plate(3));
    const joined = simplify(whole, { ...SIMPLIFYING, joints: 3 });
    expect(rings(joined)).toBe(rings(whole));
  });

  it('has every link in one chain', () => {
    const whole = before(SHAPES.star!);
    const count = chainsOf(whole).reduce((sum, chain) => sum + chain.length - 1, 0);
    expect(count).toBe(whole.links.length);
  });
});

type Node = ReturnType<typeof before>['nodes'][number];

function gapTo([x, y]: Node['at'], radius: number, a: Node, b: Node): number {
  const [dx, dy] = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
  const t = Math.min(Math.max(((x - a.at[0]) * dx + (y - a.at[1]) * dy) / (dx * dx + dy * dy || 1), 0), 1);
  const aside = Math.hypot(x - a.at[0] - t * dx, y - a.at[1] - t * dy);
  return Math.max(aside, Math.abs(radius - a.radius - t * (b.radius - a.radius)));
}
