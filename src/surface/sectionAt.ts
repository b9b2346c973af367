/** The section of a sheet at one u as it is seen, bends included: between rows points are mixed, as on the mesh's quads. */
import type { Vec3 } from '../math/vec.ts';
import type { Sheet, SheetRow } from './sheet.ts';

/** Its points along v in the coordinates of the sheet, of closed ones the first again at the end; null where there are no rows. */
export function sectionAt({ rows }: Pick<Sheet, 'rows'>, u: number): Vec3[] | null {
  const body = rows.filter(({ at }) => !at.rigid);
  const first = body[0];
  if (!first) return null;
  const next = body.findIndex(({ at }) => at.u >= u);
  const b: SheetRow = next < 0 ? body[body.length - 1]! : body[next]!;
  const a: SheetRow = next > 0 ? body[next - 1]! : b;
  const span = b.at.u - a.at.u;
  const t = span > 0 ? Math.min(Math.max((u - a.at.u) / span, 0), 1) : 1;
  return Array.from({ length: b.points.length / 3 }, (_, j) => {
    const mix = (k: number): number => a.points[3 * j + k]! * (1 - t) + b.points[3 * j + k]! * t;
    return [mix(0), mix(1), mix(2)];
  });
}
