#import kernel/evenEdge
#import kernel/oddEdge
#import kernel/powerEdge

// f = (1 + r²)^(−n/2), r in units of 1/s: the generalised Cauchy family (n = 4 is Cauchy), after Jin & Tai's kernel with
// smoothness control, whose own definition was not at hand. Closed forms for n = 2…6; else τ = √m2 sinh v, split at the
// foot, 16 Gauss points a half (measured in float64: 2e-8 of the whole line below n = 4, 7e-7 at n = 8).

fn power_value(r2: f32, exponent: f32) -> vec2f {
  return inverse_power_value(1.0 + r2, exponent);
}

fn power_line(f: LineFrame) -> vec3f {
  let m2 = 1.0 + f.rho2;
  let n = f.exponent;
  if (is_far(f, m2)) {
    return inverse_power_far(f, m2, n);
  }
  if (n != round(n) || n > 6.0) {
    return power_quadrature(f, m2);
  }
  let e = ends_of(f, m2);
  var moments: PowerMoments;
  if (n == 3.0 || n == 5.0) {
    moments = power_odd(e, n);
  } else {
    moments = power_even(e, n);
  }
  return from_moments(f, e, n, moments.values, -0.5 * n * moments.slopes);
}

// of q^(−n/2) and q^(−n/2 − 1)
struct PowerMoments { values: vec4f, slopes: vec4f }

fn power_odd(e: Ends, n: f32) -> PowerMoments {
  let third = odd_3(e);
  let mean = averages(e);
  let fifth = odd_5(e, third, mean);
  if (n == 3.0) {
    return PowerMoments(third, fifth);
  }
  return PowerMoments(fifth, odd_7(e, third, fifth, mean));
}

fn power_even(e: Ends, n: f32) -> PowerMoments {
  let first = even_1(e);
  let second = even_2(e, first);
  if (n == 2.0) {
    return PowerMoments(first, second);
  }
  let third = even_3(e, second);
  if (n == 4.0) {
    return PowerMoments(second, third);
  }
  return PowerMoments(third, even_4(e, third));
}

fn power_quadrature(f: LineFrame, m2: f32) -> vec3f {
  let root = sqrt(m2);
  // beyond it less than 1e-9 is left
  let reach = 0.7 + 21.0 / (f.exponent - 1.0) + arsinh(max(max(f.alpha, -f.beta), 0.0) / root);
  let start = max(arsinh(f.alpha / root), -reach);
  let end = min(arsinh(f.beta / root), reach);
  let foot = clamp(0.0, start, end);
  var sum = vec3f(0.0);
  for (var i = 0u; i < 32u; i++) {
    let node = GAUSS_16[i % 16u];
    let from_foot = select(start - foot, end - foot, i >= 16u);
    let grown = exp(foot + from_foot * node.x);
    let tau = 0.5 * root * (grown - 1.0 / grown);
    let share = 0.5 * root * (grown + 1.0 / grown) * abs(from_foot) * node.y;
    sum += inverse_power_node(f, m2, f.exponent, tau - f.alpha, share);
  }
  return sum;
}

fn power_edge(f: EdgeFrame) -> vec3f {
  let m = 1.0 + f.z * f.z;
  if (f.exponent == 4.0 || f.exponent == 6.0) {
    return even_edge(f, m, f.exponent);
  }
  if (f.exponent == 3.0) {
    return odd_edge_3(f, odd_edge(f, m));
  }
  if (f.exponent == 5.0) {
    return odd_edge_5(f, odd_edge(f, m));
  }
  return power_edge_quadrature(f, m, f.exponent);
}
