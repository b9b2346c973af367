/** What of @kninnug/constrainautor is used. Its own types are its source, which our strict compiler would check along. */
import type Delaunator from 'delaunator';

export default class Constrainautor {
  /** Makes the edges, and the triangulation Delaunay but for them, in place. Throws where edges cross or points lie on them. */
  constructor(triangulation: Delaunator<Float64Array>, edges?: readonly (readonly [number, number])[]);
}
