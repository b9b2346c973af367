#import kernel/frame
#import lib/atan
#import lib/tan
#import table/gauss

// f = exp(−r²), r in units of 1/s. WGSL has no erf and its difference cancels beyond the ends: Gauss points where the
// integrand is above e^−17.5 of its largest value.

fn gaussian_value(r2: f32, exponent: f32) -> vec2f {
  let f = exp(-r2);
  return vec2f(f, -f);
}

fn gaussian_line(f: LineFrame) -> vec3f {
  let near = max(max(f.alpha, -f.beta), 0.0);
  let g = sqrt(near * near + 17.5);
  let lo = max(f.alpha, -g);
  let hi = min(f.beta, g);
  let foot = clamp(0.0, lo, hi);
  var sum = vec2f(0.0);
  for (var i = 0u; i < 20u; i++) {
    let node = GAUSS_10[i % 10u];
    let from_foot = select(lo - foot, hi - foot, i >= 10u);
    let tau = foot + from_foot * node.x;
    let v = weight_at(f, tau - f.alpha) * abs(from_foot) * node.y * exp(-f.rho2 - tau * tau);
    sum += vec2f(v, 2.0 * tau * v);
  }
  return vec3f(sum.x, -sum.x, sum.y);
}

// τ = c tan φ, 16 points
fn gaussian_edge(f: EdgeFrame) -> vec3f {
  let c2 = f.d * f.d + 1.0;
  let c = sqrt(c2);
  let start = angle_of(f.alpha, c);
  let turn = angle_of(f.length * c, c2 + f.alpha * f.beta);
  var sum = vec2f(0.0);
  for (var i = 0u; i < 16u; i++) {
    let t = tan_of(start + turn * GAUSS_16[i].x);
    let tau = c * t;
    let u = f.d * f.d + tau * tau;
    sum += GAUSS_16[i].y * (1.0 + t * t) * vec2f(half_decline(u), exp(-u));
  }
  sum *= c * turn * exp(-f.z * f.z);
  let value = f.d * sum.x;
  return vec3f(value, -sum.y, -2.0 * f.z * value);
}

// (1 − e^−x)/(2x)
fn half_decline(x: f32) -> f32 {
  if (x < 0.2) {
    return 0.5 - x * (0.25 - x * (1.0 / 12.0 - x * (1.0 / 48.0 - x * (1.0 / 240.0 - x / 1440.0))));
  }
  return (1.0 - exp(-x)) / (2.0 * x);
}
