#import kernel/evenMoments

// Polygon edges for q^(−n/2), q = m + ρ², n = 4 and 6 (as in powerEdge.ts): the polygon is P_n/(n − 2), along z −z P_(n+2),
// with P_2 = 0 and P_(n+2) = (P_n + d ∫ q^(−n/2))/m.

fn even_edge(f: EdgeFrame, m: f32, n: f32) -> vec3f {
  let w2 = m + f.d * f.d;
  let e = ends_of(LineFrame(w2, f.alpha, f.beta, f.length, vec4f(0.0), 0u, 0.0, 0.0), w2);
  let first = even_1(e);
  let second = even_2(e, first);
  let four = f.d * first.x / m;
  let six = (four + f.d * second.x) / m;
  if (n == 4.0) {
    return vec3f(0.5 * four, -second.x, -f.z * six);
  }
  let third = even_3(e, second);
  return vec3f(0.25 * six, -third.x, -f.z * (six + f.d * third.x) / m);
}
