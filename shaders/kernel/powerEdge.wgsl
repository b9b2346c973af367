#import kernel/inversePower

// Polygon edges for q^(−n/2), q = m + ρ², any n in (1, 8], by quadrature: G/ρ² = ½ m^(−n/2) E(y) L(x) with x = ρ²/m,
// L = ln(1 + x)/x, y = (n/2 − 1) ln(1 + x), E = (1 − e^−y)/y, which holds at n = 2 too. τ = c sinh v, c² = m + d², split at
// the foot, 16 Gauss points a half.

fn power_edge_quadrature(f: EdgeFrame, m: f32, n: f32) -> vec3f {
  let c = sqrt(m + f.d * f.d);
  let start = arsinh(f.alpha / c);
  let end = arsinh(f.beta / c);
  let foot = clamp(0.0, start, end);
  let at_m = inverse_power_of(m, n);
  var sum = vec3f(0.0);
  for (var i = 0u; i < 32u; i++) {
    let node = GAUSS_16[i % 16u];
    let from_foot = select(start - foot, end - foot, i >= 16u);
    let grown = exp(foot + from_foot * node.x);
    let tau = 0.5 * c * (grown - 1.0 / grown);
    let share = 0.5 * c * (grown + 1.0 / grown) * abs(from_foot) * node.y;
    let x = (f.d * f.d + tau * tau) / m;
    let log_q = log_1p(x);
    let spread = 0.5 * f.d * at_m * select(log_q / x, 1.0, x == 0.0);
    let value = spread * decline((0.5 * n - 1.0) * log_q);
    let slope = -n * f.z / m * spread * decline(0.5 * n * log_q);
    sum += share * vec3f(value, -at_m * exp(-0.5 * n * log_q), slope);
  }
  return sum;
}

// m^(−n/2), for m below 1 too
fn inverse_power_of(m: f32, n: f32) -> f32 {
  return select(exp(0.5 * n * log_1p(1.0 / m - 1.0)), inverse_power(m, n), m >= 1.0 || n == 2.0);
}

// (1 − e^−y)/y
fn decline(y: f32) -> f32 {
  if (abs(y) < 0.2) {
    return 1.0 - y * (0.5 - y * (1.0 / 6.0 - y * (1.0 / 24.0 - y * (1.0 / 120.0 - y / 720.0))));
  }
  return (1.0 - exp(-y)) / y;
}
