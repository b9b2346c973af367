// ln(1 + x) for x ≥ 0, relative error 2e-7 down to x = 0. WGSL's log knows 1 + x only: nothing is left of a small x.
// By 2 atanh(s), s = (m − 1)/(m + 1), m in [√½, √2]; polynomial: Chebyshev, 7e-10.

fn log_1p(x: f32) -> f32 {
  let bits = bitcast<u32>(1.0 + x);
  // 0x3f3504f3 is √½: the exponent that leaves m between √½ and √2
  let exponent = (i32(bits) - 0x3f3504f3) >> 23u;
  let m = bitcast<f32>(i32(bits) - (exponent << 23u));
  let over = select(m - 1.0, x, exponent == 0);
  let s = over / (2.0 + over);
  let z = s * s;
  let near = s * (2.0 + z * (0.66666815792 + z * (0.39974799076 + z * 0.29925789480)));
  return near + f32(exponent) * 0.69314718056;
}

// the inverse of sinh
fn arsinh(x: f32) -> f32 {
  let a = abs(x);
  let unsigned = log_1p(a + a * (a / (1.0 + sqrt(1.0 + a * a))));
  return select(unsigned, -unsigned, x < 0.0);
}
