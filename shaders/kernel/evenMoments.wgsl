#import kernel/moments
#import lib/atan

// Moments J_0…J_3 of q^(−m), m = 1, 2, 3, 4: one arc tangent, then by parts upwards in m.
// Beyond an end the recurrence cancels; there J_0 = m2^(½−m) ∫ sin^(2m−2) between the angles at which the ends are seen.

fn even_1(e: Ends) -> vec4f {
  let m = sqrt(e.m2);
  let j0 = angle_of(e.length * m, e.m2 + e.alpha * e.beta) / m;
  let j1 = half_log(e);
  return vec4f(j0, j1, e.length - e.m2 * j0, 0.5 * e.area - e.m2 * j1);
}

fn even_2(e: Ends, lower: vec4f) -> vec4f {
  return even_next(e, lower, 2.0, 0.5 * e.area * e.ia * e.ib);
}

fn even_3(e: Ends, lower: vec4f) -> vec4f {
  return even_next(e, lower, 3.0, 0.25 * e.area * e.ia * e.ib * (e.ia + e.ib));
}

fn even_4(e: Ends, lower: vec4f) -> vec4f {
  return even_next(e, lower, 4.0, e.area * e.ia * e.ib * (e.ia * e.ia + e.ia * e.ib + e.ib * e.ib) / 6.0);
}

fn even_next(e: Ends, lower: vec4f, m: f32, j1: f32) -> vec4f {
  var j0 = 0.0;
  if (e.alpha * e.beta > 0.0) {
    j0 = abs(sine_integral(e, abs(e.alpha), m) - sine_integral(e, abs(e.beta), m));
  } else {
    let ends = e.beta * whole_power(e.ib, m) - e.alpha * whole_power(e.ia, m);
    j0 = (ends + (2.0 * m - 3.0) * lower.x) / (2.0 * (m - 1.0) * e.m2);
  }
  return vec4f(j0, j1, lower.x - e.m2 * j0, lower.y - e.m2 * j1);
}

// x^(m−1)
fn whole_power(x: f32, m: f32) -> f32 {
  return select(select(x * x * x, x * x, m == 3.0), x, m == 2.0);
}

// m2^(½−m) ∫_0^ψ sin^(2m−2), tan ψ = √m2/τ: an odd series in ψ; polynomials: Chebyshev on [0, π/2], below 2e-8.
// Written with ψ/√m2, which stays finite for a point on the axis.
fn sine_integral(e: Ends, tau: f32, m: f32) -> f32 {
  let root = sqrt(e.m2);
  let psi = angle_of(root, tau);
  let z = psi * psi;
  let s = psi / root;
  let s3 = s * s * s;
  if (m == 2.0) {
    let tail = 0.00634920489 + z * (-0.000352730124 + z * (1.28225327e-5 + z * (-3.264001626e-7 + z * 5.5158872e-9)));
    return s3 * (0.33333333333 + z * (-0.06666666644 + z * tail));
  }
  if (m == 3.0) {
    let end = 0.000336261546 + z * (-2.54843101e-5 + z * (1.42579386e-6 + z * -4.84366e-8));
    let tail = -0.09523809095 + z * (0.02222218563 + z * (-0.003270683876 + z * end));
    return s3 * s * s * (0.2 + z * tail);
  }
  let end = 0.001833331311 + z * (-0.000244536666 + z * (2.52330781e-5 + z * (-1.91330950e-6 + z * 8.16007e-8)));
  let tail = -0.1111111019 + z * (0.04242414267 + z * (-0.01041879196 + z * end));
  return s3 * s3 * s * (0.14285714272 + z * tail);
}
