// Ring about the y axis: value = distance, gradient. Twin of src/shape/torus.ts.

fn torus_field(p: vec3f, ring: f32, tube: f32) -> vec4f {
  let rho = length(p.xz);
  let across = rho - ring;
  let distance = length(vec2f(across, p.y));
  let inverse = select(0.0, 1.0 / distance, distance > 0.0);
  let outwards = select(0.0, across * inverse / rho, rho > 0.0);
  return vec4f(tube - distance, -p.x * outwards, -p.y * inverse, -p.z * outwards);
}
