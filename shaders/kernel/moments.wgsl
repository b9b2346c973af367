#import kernel/inversePower

// What all moments J_k[n] = ∫ τ^k (m2 + τ²)^(−n/2) dτ of a segment are made of, and how a line integral is made of them.

struct Ends {
  m2: f32,
  alpha: f32,
  beta: f32,
  length: f32,
  // 1/(m2 + α²), 1/(m2 + β²)
  ia: f32,
  ib: f32,
  // square roots of what is under them
  ra: f32,
  rb: f32,
  // length · (α + β) = β² − α²
  area: f32,
}

fn ends_of(f: LineFrame, m2: f32) -> Ends {
  let a = m2 + f.alpha * f.alpha;
  let b = m2 + f.beta * f.beta;
  let area = f.length * (f.alpha + f.beta);
  return Ends(m2, f.alpha, f.beta, f.length, 1.0 / a, 1.0 / b, sqrt(a), sqrt(b), area);
}

// ½ ln(B/A), exact to the last digits where the ends are nearly as far away
fn half_log(e: Ends) -> f32 {
  if (e.area > 0.0) {
    return 0.5 * log_1p(e.area * e.ia);
  }
  return -0.5 * log_1p(-e.area * e.ib);
}

// Taylor coefficients of w at the foot of the perpendicular
fn shifted(f: LineFrame) -> vec4f {
  let w = f.weights;
  let h = -f.alpha;
  return vec4f(
    w.x + h * (w.y + h * (w.z + h * w.w)),
    w.y + h * (2.0 * w.z + 3.0 * h * w.w),
    w.z + 3.0 * h * w.w,
    w.w,
  );
}

// (∫ w f, ∫ w df/dr², ∂ along u) from the moments of f and of df/dr², by parts along u
fn from_moments(f: LineFrame, e: Ends, n: f32, values: vec4f, slopes: vec4f) -> vec3f {
  let c = shifted(f);
  let fa = inverse_power(1.0 / e.ia, n);
  let fb = inverse_power(1.0 / e.ib, n);
  let along = f.weights.x * fa - weight_at(f, f.length) * fb + dot(c.yzw * vec3f(1.0, 2.0, 3.0), values.xyz);
  return vec3f(dot(c, values), dot(c, slopes), along);
}
