#import lib/log

// r² = x² + |y|^α: m, ∂m/∂x, ∂m/∂y at q. Twin of src/field/extrusion.ts. In units of the larger coordinate and
// with |y|^α = y² |y|^(α − 2), so that nothing over- or underflows and α = 2 stays round.

// ln of the largest |y|^α
const LN_HIGHEST = 27.6310211159;

fn extrusion(q: vec2f, exponent: f32) -> vec3f {
  let large = max(abs(q.x), abs(q.y));
  if (large < 1e-30) {
    return vec3f(1.0, 0.0, 0.0);
  }
  let u = q / large;
  let rho2 = dot(u, u);
  let log_y = ln_of(max(abs(q.y), 1e-30));
  // from there on a square
  let is_beyond = exponent * log_y > LN_HIGHEST;
  let power = exp(select((exponent - 2.0) * log_y, LN_HIGHEST - 2.0 * LN_HIGHEST / exponent, is_beyond));
  let steep = select(0.5 * exponent, 1.0, is_beyond) * power;
  let m2 = (u.x * u.x + u.y * u.y * power) / rho2;
  let m = sqrt(m2);
  let inverse = select(0.0, 1.0 / (m * rho2), m > 0.0);
  return vec3f(m, (u * inverse) * vec2f(1.0 - m2, steep - m2) / large);
}

// ln x for x > 0, relative error 3e-7 also near 1, where high powers live and WGSL's own may be off by 2^-21
fn ln_of(x: f32) -> f32 {
  if (x < 1.0) {
    return -log_1p((1.0 - x) / x);
  }
  return log_1p(x - 1.0);
}
