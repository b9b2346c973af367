// Sphere about the origin: value = distance (positive inside), gradient. Twin of src/shape/sphere.ts.

fn sphere_field(p: vec3f, radius: f32) -> vec4f {
  let distance = length(p);
  let inverse = select(0.0, 1.0 / distance, distance > 0.0);
  return vec4f(radius - distance, -p * inverse);
}
