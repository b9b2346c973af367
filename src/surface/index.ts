/**
 * Parametric surfaces from strokes. A new one is a file that makes a mesh from curves, and a line in the list.
 * Menus, documents and tests read the list.
 */
import type { Mesh } from '../mesh/mesh.ts';
import type { Curve } from '../stroke/curve.ts';
import type { Plane } from '../stroke/stroke.ts';
import { rotational } from './rotational.ts';
import { tube } from './tube.ts';

export type SurfaceKind = 'tube' | 'rotational' | 'crossSection' | 'bspline';

export interface SurfaceOptions {
  /** of tubes, mm, above 0 */
  readonly radius: number;
  /** tubes: the pen's pressure changes the radius */
  readonly pressure: boolean;
  /** ends are closed: tubes by domes, rotational surfaces by discs */
  readonly caps: boolean;
  /** quads along the strokes (about) */
  readonly u: number;
  /** quads around */
  readonly v: number;
}

export interface Surface {
  readonly id: SurfaceKind;
  readonly label: string;
  /** how many strokes it is made from */
  readonly strokes: number;
  /** `curves` holds `strokes` curves, all on `plane` */
  build(curves: readonly Curve[], plane: Plane, options: SurfaceOptions): Mesh;
}

export const surfaces: Readonly<Record<SurfaceKind, Surface>> = {
  tube: {
    id: 'tube',
    label: 'Tube',
    strokes: 1,
    build: ([curve], plane, options) =>
      tube(curve!, plane, { ...options, caps: options.caps ? 'round' : 'none' }),
  },
  rotational: {
    id: 'rotational',
    label: 'Rotational surface',
    strokes: 2,
    build: ([left, right], plane, options) => rotational(left!, right!, plane, options),
  },
  crossSection: {
    id: 'crossSection',
    label: 'Section surface',
    strokes: 2,
    build: ([left, right], plane, options) => rotational(left!, right!, plane, options),
  },
  bspline: {
    id: 'bspline',
    label: 'Patch',
    strokes: 2,
    build: ([left, right], plane, options) => rotational(left!, right!, plane, options),
  },
};

/**
 * The outward mesh of a surface, closed with `caps`; without triangles where the strokes enclose nothing.
 * Throws RangeError when the number of curves does not fit the kind, or an option is out of its range.
 */
export function buildSurface(
  kind: SurfaceKind,
  curves: readonly Curve[],
  plane: Plane,
  options: SurfaceOptions,
): Mesh {
  const surface = surfaces[kind];
  if (!surface) throw new RangeError(`surface: unknown kind '${kind}'`);
  if (curves.length !== surface.strokes) {
    throw new RangeError(`surface '${kind}' takes ${surface.strokes} strokes, got ${curves.length}`);
  }
  return surface.build(curves, plane, options);
}
