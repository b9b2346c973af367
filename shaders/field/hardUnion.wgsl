// The larger of the two: value, ∂/∂a, ∂/∂b. Twin of src/field/hardUnion.ts.

fn hard_union(a: f32, b: f32) -> vec3f {
  return vec3f(max(a, b), select(vec2f(0.0, 1.0), vec2f(1.0, 0.0), a >= b));
}
