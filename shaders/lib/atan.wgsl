// The angle of (x, y), −π…π, 0 for (0, 0). WGSL's own atan2 may be 4096 ulp off (lavapipe: 1.8e-5 relative, SwiftShader:
// 7e-7); this is within 3e-7 wherever division is right to 2.5 ulp. Polynomial: Chebyshev on |t| ≤ tan(π/8), 2e-8.

const PI = 3.14159265358979;

fn angle_of(y: f32, x: f32) -> f32 {
  let small = min(abs(x), abs(y));
  let large = max(abs(x), abs(y));
  if (large == 0.0) {
    return 0.0;
  }
  var t = small / large;
  var base = 0.0;
  if (t > 0.41421356) {
    t = (small - large) / (small + large);
    base = 0.25 * PI;
  }
  let z = t * t;
  let tail = -0.33332783755 + z * (0.19974012559 + z * (-0.13847735426 + z * 0.07973791190));
  var angle = base + (t + t * z * tail);
  angle = select(angle, 0.5 * PI - angle, abs(y) > abs(x));
  angle = select(angle, PI - angle, x < 0.0);
  return select(angle, -angle, y < 0.0);
}
