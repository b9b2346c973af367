#import kernel/oddMoments
#import lib/atan

// Polygon edges for q^(−n/2), n = 1, 3, 5, q = m + ρ²: m = z² for 1/r, 1/r³, 1/r⁵ and 1 + z² for the power family
// (powerEdge.ts; n = 1 by G = √(m + ρ²) − √m, whose edge integral is d J_0[1] − m Q_1).

struct OddEdge {
  // ∫ q^(−n/2) along the edge
  j1: f32,
  j3: f32,
  j5: f32,
  // the solid angle's share by √m, and what follows from it by recurrence
  q1: f32,
  q3: f32,
  q5: f32,
  m: f32,
}

fn odd_edge(f: EdgeFrame, m: f32) -> OddEdge {
  let q = max(f.d * f.d + m, 1e-30);
  let root = sqrt(m);
  let e = ends_of(LineFrame(q, f.alpha, f.beta, f.length, vec4f(0.0), 0u, 0.0, 0.0), q);
  let ends = f.alpha * f.beta;
  let across = f.beta * e.ra - f.alpha * e.rb;
  let turned = select(across, q * e.area / (f.beta * e.ra + f.alpha * e.rb), ends > 0.0);
  let x = (q + root * e.ra) * (q + root * e.rb) + ends * f.d * f.d;
  let q1 = angle_of(f.d * (q * f.length + root * turned), x) / root;

  let third = odd_3(e);
  let j5 = odd_5(e, third, averages(e)).x;
  let q3 = (q1 + f.d * third.x) / m;
  return OddEdge(odd_1(e).x, third.x, j5, q1, q3, (q3 + f.d * j5) / m, m);
}

fn odd_edge_1(f: EdgeFrame, o: OddEdge) -> vec3f {
  return vec3f(f.d * o.j1 - o.m * o.q1, -o.j1, -f.z * o.q1);
}

fn odd_edge_3(f: EdgeFrame, o: OddEdge) -> vec3f {
  return vec3f(o.q1, -o.j3, -f.z * o.q3);
}

fn odd_edge_5(f: EdgeFrame, o: OddEdge) -> vec3f {
  return vec3f(o.q3 / 3.0, -o.j5, -f.z * o.q5);
}
