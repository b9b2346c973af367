// Round cylinder about the y axis with flat ends: value = distance, gradient. Twin of src/shape/cylinder.ts.

fn cylinder_field(p: vec3f, radius: f32, half_height: f32) -> vec4f {
  let rho = length(p.xz);
  let d = vec2f(rho - radius, abs(p.y) - half_height);
  let beyond = max(d, vec2f(0.0));
  let outside = length(beyond);
  // how much of the gradient points across and along; inside, the nearer face has all of it
  var share = select(vec2f(0.0, 1.0), vec2f(1.0, 0.0), d.x > d.y);
  var value = -max(d.x, d.y);
  if (outside > 0.0) {
    share = beyond / outside;
    value = -outside;
  }
  let inverse = select(0.0, share.x / rho, rho > 0.0);
  return vec4f(value, -p.x * inverse, select(-share.y, share.y, p.y < 0.0), -p.z * inverse);
}
