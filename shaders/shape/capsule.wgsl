// Points within the radius of a segment on the y axis: value = distance, gradient. Twin of src/shape/capsule.ts.

fn capsule_field(p: vec3f, radius: f32, half_height: f32) -> vec4f {
  let from_segment = vec3f(p.x, p.y - clamp(p.y, -half_height, half_height), p.z);
  let distance = length(from_segment);
  let inverse = select(0.0, 1.0 / distance, distance > 0.0);
  return vec4f(radius - distance, -from_segment * inverse);
}
