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

// where the nearest place of the surface is: on the side, the lower or the upper end
fn cylinder_side(p: vec3f, radius: f32, half_height: f32) -> u32 {
  if (length(p.xz) - radius >= abs(p.y) - half_height) {
    return 0u;
  }
  return select(2u, 1u, p.y < 0.0);
}

// value and gradient of what continues it
fn cylinder_on_side(p: vec3f, radius: f32, half_height: f32, side: u32) -> vec4f {
  if (side == 0u) {
    let rho = length(p.xz);
    let inverse = select(0.0, 1.0 / rho, rho > 0.0);
    return vec4f(radius - rho, -p.x * inverse, 0.0, -p.z * inverse);
  }
  let way = select(1.0, -1.0, side == 1u);
  return vec4f(half_height - way * p.y, 0.0, -way, 0.0);
}
