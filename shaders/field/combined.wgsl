// Two fields (value, gradient) under a union of their values (value, ∂/∂a, ∂/∂b); a ∩ b = −(−a ∪ −b), a \ b = −(−a ∪ b),
// operands and result negated as a whole. Twin of src/field/combined.ts.

fn combined(a: vec4f, b: vec4f, united: vec3f) -> vec4f {
  return vec4f(united.x, united.y * a.yzw + united.z * b.yzw);
}

// how much of b's colour is seen
fn share_of_b(united: vec3f) -> f32 {
  let to = max(united.yz, vec2f(0.0));
  let sum = to.x + to.y;
  return select(0.5, to.y / sum, sum > 0.0);
}
