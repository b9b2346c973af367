/**
 * Rotational blending of two strokes (thesis 5.3): at each u the circle perpendicular to the drawing plane
 * through q_l(u) and q_r(u),
 *     S(u, v) = c + ρ (cos v x′ ± sin v n),   c = (q_l + q_r)/2,   ρ x′ = (q_l − q_r)/2,
 * with n the plane's normal and v = 0 at q_l (as in 5.3.1; 5.3.2 has it at q_r).
 *
 * Departures. The radius is half the distance: 5.3.2 scales by all of it, and the program of B.1.1 does not close.
 * Where the strokes cross, x′ flips and would turn the surface inside out. The sense of v flips with it, which is
 * the same as keeping x′ and giving ρ a sign, and needs no bookkeeping: each lobe between poles goes round in the
 * sense that makes its volume ∫ πρ² c′·(n × x′) du (area of the circles times the way of their centres) positive.
 * Where circles are wider than the bend they follow, the surface overlaps itself; it stays closed.
 */
import { cross2, length2 } from '../math/tuple.ts';
import { emptyMesh, evenColumns, gridMesh, type Row } from '../mesh/grid.ts';
import type { Mesh } from '../mesh/mesh.ts';
import type { Curve } from '../stroke/curve.ts';
import type { Plane } from '../stroke/stroke.ts';
import { disc, outsideIn, rigid } from './caps.ts';
import { type Circle, closedCircle } from './circle.ts';
import { type Pair, pairCurves } from './pair.ts';
import { type Ring, ringAt, ringNormals, ringPoints, type Sense } from './ring.ts';
import { pieces, quadCount } from './rows.ts';
import type { Sheet, SheetRow } from './sheet.ts';
import { pairSpine } from './spine.ts';

export interface RotationalOptions {
  /** discs close open ends */
  readonly caps: boolean;
  /** quads along the strokes (about) and around, at least 1 and 3 */
  readonly u: number;
  readonly v: number;
}

/** The rings of one smooth piece and their u. */
interface Stretch {
  readonly us: readonly number[];
  readonly rings: readonly Ring[];
}

/** Pieces between two poles (or ends): a solid of its own. */
interface Lobe {
  readonly stretches: readonly Stretch[];
  readonly sense: Sense;
}

/** circles that move in their own planes, to this part of their way, enclose nothing */
const FLAT = 1e-9;

/**
 * The closed solid between two strokes, outward, pinched to points where they cross; open at its ends without
 * `caps` (ends that meet need none). Two closed strokes make a ring or a torus, see align.ts. Without triangles when
 * the strokes lie on each other or have no length. Throws RangeError when u or v is not finite.
 */
export function rotational(left: Curve, right: Curve, plane: Plane, options: RotationalOptions): Mesh {
  const sheet = rotationalSheet(left, right, options);
  const mesh = sheet ? gridMesh(sheet.rows, sheet.columns, plane) : emptyMesh();
  return mesh.indices.length > 0 ? mesh : emptyMesh();
}

/** The same before it is a mesh; null when the strokes enclose nothing. */
export function rotationalSheet(left: Curve, right: Curve, options: RotationalOptions): Sheet | null {
  const u = quadCount('u', options.u, 1);
  const v = quadCount('v', options.v, 3);
  const pair = pairCurves(left, right);
  if (!(pair.length > 0)) return null;
  const circle = closedCircle(v);
  const found = lobes(pair, u);
  if (found.length === 0) return null;
  const rows = found.flatMap((lobe) => lobeRows(lobe, circle));
  return {
    rows: finish(rows, found, pair, options.caps),
    columns: evenColumns(v),
    spine: pairSpine(pair),
  };
}

/** Stretches from pole to pole; none when all circles lie in one plane (strokes on one line). */
function lobes(pair: Pair, quads: number): Lobe[] {
  const groups: Stretch[][] = [[]];
  stretches(pair, quads).forEach((stretch, i) => {
    if (i > 0 && pair.stops[i]!.pole) groups.push([]);
    groups[groups.length - 1]!.push(stretch);
  });
  const signed = groups.map((group) => sweep(group, ({ axis, dCentre }) => cross2(axis, dCentre)));
  const most = groups.map((group) => sweep(group, ({ dCentre }) => length2(dCentre)));
  if (signed.every((volume, i) => Math.abs(volume) <= FLAT * most[i]!)) return [];
  return groups.map((stretches, i) => ({ stretches, sense: signed[i]! < 0 ? -1 : 1 }));
}

function stretches(pair: Pair, quads: number): Stretch[] {
  const { stops } = pair;
  const least = (i: number): number => {
    if (stops[i]!.pole && stops[i + 1]!.pole) return 2;
    return pair.closed ? Math.ceil(3 / (stops.length - 1)) : 1;
  };
  const us = stops.map((stop) => stop.u);
  return pieces(us, quads, least).map((piece, i) => {
    const last = piece.length - 1;
    const pole = (k: number): boolean => (k === 0 && stops[i]!.pole) || (k === last && stops[i + 1]!.pole);
    return { us: piece, rings: piece.map((u, k) => ringAt(pair, u, k === last ? -1 : 1, pole(k))) };
  });
}

/** ∫ ρ² f du by the trapezoid rule; with f = c′·(n × x′) the volume over π. */
function sweep(stretches: readonly Stretch[], f: (ring: Ring) => number): number {
  let sum = 0;
  for (const { us, rings } of stretches) {
    const flow = rings.map((ring) => ring.radius * ring.radius * f(ring));
    for (let k = 1; k < us.length; k++) sum += ((us[k]! - us[k - 1]!) * (flow[k]! + flow[k - 1]!)) / 2;
  }
  return sum;
}

function lobeRows({ stretches, sense }: Lobe, circle: Circle): SheetRow[] {
  return stretches.flatMap(({ us, rings }) =>
    rings.map((ring, k) => ({
      points: ringPoints(ring, sense, circle),
      normals: ringNormals(ring, sense, circle),
      pole: ring.radius === 0,
      joined: k > 0,
      at: { u: us[k]!, side: k === rings.length - 1 ? -1 : 1 },
    })),
  );
}

/** Ends what is open: a closed pair in its first row, an open one in discs. */
function finish(rows: readonly SheetRow[], found: readonly Lobe[], pair: Pair, caps: boolean): SheetRow[] {
  const first = rows[0]!;
  const last = rows[rows.length - 1]!;
  if (pair.closed) return [...rows.slice(0, -1), { ...last, points: first.points }];
  if (!caps) return [...rows];
  const head = found[0]!;
  const tail = found[found.length - 1]!;
  const { cap } = outsideIn(endDisc(head.stretches[0]!.rings[0]!, first, -head.sense));
  const end = endDisc(tail.stretches.at(-1)!.rings.at(-1)!, last, tail.sense);
  return [...rigid(cap, first.at), ...rows, ...rigid(end, last.at)];
}

/** A disc whose normal is along ± n × x′; poles need none. */
function endDisc({ centre, axis }: Ring, rim: Row, side: number): Row[] {
  return rim.pole ? [] : disc(rim, [centre[0], centre[1], 0], [-side * axis[1], side * axis[0], 0]);
}
