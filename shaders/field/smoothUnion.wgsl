// a + b + √(a² + b²): value, ∂/∂a, ∂/∂b. Twin of src/field/smoothUnion.ts, which says why in this form.

fn smooth_union(a: f32, b: f32) -> vec3f {
  let large = max(abs(a), abs(b));
  // a device may take what is smaller for 0
  if (large < 1e-37) {
    return vec3f(max(a, b), 1.0, 1.0);
  }
  let ratio = min(abs(a), abs(b)) / large;
  let q = large * sqrt(1.0 + ratio * ratio);
  let sum = a + b;
  let value = select(sum + q, 2.0 * a * (b / (sum - q)), sum < 0.0);
  return vec3f(value, smooth_share(a, b, q), smooth_share(b, a, q));
}

// 1 + a/q, of which nothing is left for a = −q
fn smooth_share(a: f32, b: f32, q: f32) -> f32 {
  return select(1.0 + a / q, (b / q) * (b / (q - a)), a < 0.0);
}
