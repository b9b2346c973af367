/** What of @kninnug/constrainautor is used. Its own types are its source, which our strict compiler would check along. */
import type Delaunator from 'delaunator';

export default class Constrainautor {
  constructor(triangulation: Delaunator<ArrayLike<number>>);
  /** Makes the edges, and the triangulation Delaunay but for them, in place. Throws where edges cross or points lie on them. */
  constrainAll(edges: readonly (readonly [number, number])[]): this;
  /** looked at again and again on the way: whether two segments, four indices of points, meet */
  protected intersectSegments(a: number, b: number, c: number, d: number): boolean;
  /** whether the circle of a triangle at an edge is empty */
  protected isDelaunay(edge: number): boolean;
}
