// What a kernel sees of a skel, in kernel units. Twins of LineFrame and EdgeFrame in src/kernel/kernel.ts.

struct LineFrame {
  // squared distance from the line
  rho2: f32,
  // the ends along the line, from the foot of the perpendicular; beta − alpha = length
  alpha: f32,
  beta: f32,
  length: f32,
  // w(t) = Σ weights[k] t^k, t from the end at alpha
  weights: vec4f,
  degree: u32,
  // singular kernels see no squared distance below this
  floor2: f32,
  exponent: f32,
}

struct EdgeFrame {
  // signed distance of the origin from the edge's line: positive where the origin lies on its left
  d: f32,
  alpha: f32,
  beta: f32,
  length: f32,
  // signed height of the point above the plane
  z: f32,
  floor2: f32,
  exponent: f32,
}

// w at t from the end at alpha
fn weight_at(f: LineFrame, t: f32) -> f32 {
  let w = f.weights;
  return w.x + t * (w.y + t * (w.z + t * w.w));
}

// Squared distance from the line such that no point of the segment is nearer than the floor. 2⁻²⁰ of the length is about
// how well the axis is known, and keeps r⁻⁷ a float32 (without it 0/0 on the axis beyond an end).
fn floored(f: LineFrame) -> f32 {
  let out = max(max(f.alpha, -f.beta), 0.0);
  let unknown = 9.5367431640625e-7 * f.length;
  return max(max(f.rho2, f.floor2 - out * out), unknown * unknown);
}
