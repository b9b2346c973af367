#import lib/log

// |x|^α + |y|^α = r^α: m, ∂m/∂x, ∂m/∂y at q. Twin of src/field/superQuadric.ts. t = min/max; ln t by way of
// 1 − t, for WGSL's own may be off by 2^-21 near 1, which α = 100 makes 1e-5 of the slope.

// closer to an axis the slope of t^α is not followed
const CREASE = 1e-6;

fn super_quadric(q: vec2f, exponent: f32) -> vec3f {
  let wide = abs(q.x) >= abs(q.y);
  let ordered = select(q.yx, q, wide);
  let large = abs(ordered.x);
  let small = abs(ordered.y);
  if (large < 1e-30) {
    return vec3f(1.0, 0.0, 0.0);
  }
  let t = small / large;
  let fall = log_1p((large - small) / large / max(t, 1e-30));
  let s = select(exp(-exponent * fall), 0.0, t < 1e-30);
  let m = exp(log_1p(s) / exponent) / sqrt(1.0 + t * t);
  let slope = m * (s / (max(t, CREASE) * (1.0 + s)) - t / (1.0 + t * t)) / large;
  // t falls with the larger coordinate and rises with the smaller
  let along = vec2f(-slope * t, slope) * select(vec2f(1.0), vec2f(-1.0), ordered < vec2f(0.0));
  return vec3f(m, select(along.yx, along, wide));
}
