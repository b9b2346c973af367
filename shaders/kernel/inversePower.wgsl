#import kernel/frame
#import lib/log
#import table/gauss

// f = q^(−n/2) with q = m2 + τ²: what Cauchy, the inverse powers and the power family have in common.

fn inverse_power(q: f32, n: f32) -> f32 {
  let i = 1.0 / q;
  if (n == 1.0) { return sqrt(i); }
  if (n == 2.0) { return i; }
  if (n == 3.0) { return i * sqrt(i); }
  if (n == 4.0) { return i * i; }
  if (n == 5.0) { return i * i * sqrt(i); }
  if (n == 6.0) { return i * i * i; }
  // only the power kernel gets here, whose q is at least 1
  return exp(-0.5 * n * log_1p(q - 1.0));
}

// (f, df/dq)
fn inverse_power_value(q: f32, n: f32) -> vec2f {
  let f = inverse_power(q, n);
  return vec2f(f, -0.5 * n * f / q);
}

// One node of a quadrature at t from the end at alpha: its share of (∫ w f, ∫ w df/dq, ∂ along u).
fn inverse_power_node(f: LineFrame, m2: f32, n: f32, t: f32, share: f32) -> vec3f {
  let tau = f.alpha + t;
  let v = inverse_power_value(m2 + tau * tau, n) * (weight_at(f, t) * share);
  return vec3f(v, -2.0 * tau * v.y);
}

// The Taylor shift to the foot cancels far away; there the integrand is nearly flat, for
// higher degrees already nearer.
fn is_far(f: LineFrame, m2: f32) -> bool {
  let lengths = select(3.0, 2.0, f.degree > 1u);
  return sqrt(m2 + f.alpha * f.alpha) + sqrt(m2 + f.beta * f.beta) > lengths * f.length;
}

fn inverse_power_far(f: LineFrame, m2: f32, n: f32) -> vec3f {
  var sum = vec3f(0.0);
  if (f.degree > 1u) {
    for (var i = 0u; i < 10u; i++) {
      sum += inverse_power_node(f, m2, n, f.length * GAUSS_10[i].x, f.length * GAUSS_10[i].y);
    }
    return sum;
  }
  for (var i = 0u; i < 6u; i++) {
    sum += inverse_power_node(f, m2, n, f.length * GAUSS_6[i].x, f.length * GAUSS_6[i].y);
  }
  return sum;
}
