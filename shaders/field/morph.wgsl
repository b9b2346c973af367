// (1 − t) a + t b: value, ∂/∂a, ∂/∂b. Twin of src/field/morph.ts.

fn morph(a: f32, b: f32, t: f32) -> vec3f {
  return vec3f((1.0 - t) * a + t * b, 1.0 - t, t);
}
