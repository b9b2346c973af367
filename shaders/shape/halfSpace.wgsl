// All behind a plane (normal of length 1): value = distance, gradient. Twin of src/shape/halfSpace.ts.

fn half_space_field(p: vec3f, normal: vec3f, offset: f32) -> vec4f {
  return vec4f(offset - dot(normal, p), -normal);
}
