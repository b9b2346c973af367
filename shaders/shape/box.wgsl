// Box about the origin: value = distance (positive inside), gradient. Twin of src/shape/box.ts.

fn box_field(p: vec3f, half_size: vec3f) -> vec4f {
  let towards = select(vec3f(1.0), vec3f(-1.0), p < vec3f(0.0));
  let d = abs(p) - half_size;
  let beyond = max(d, vec3f(0.0));
  let outside = length(beyond);
  if (outside > 0.0) {
    return vec4f(-outside, -towards * beyond / outside);
  }
  let nearest = max(d.x, max(d.y, d.z));
  // of two faces equally near the first
  let x = d.x == nearest;
  let y = !x && d.y == nearest;
  let z = !x && !y;
  return vec4f(-nearest, select(vec3f(0.0), -towards, vec3<bool>(x, y, z)));
}

// the face that the nearest place of the surface is on: −x, x, −y, y, −z, z
fn box_side(p: vec3f, half_size: vec3f) -> u32 {
  let d = abs(p) - half_size;
  if (d.x >= d.y && d.x >= d.z) {
    return select(1u, 0u, p.x < 0.0);
  }
  if (d.y >= d.z) {
    return select(3u, 2u, p.y < 0.0);
  }
  return select(5u, 4u, p.z < 0.0);
}

// value and gradient of that face's plane
fn box_on_side(p: vec3f, half_size: vec3f, side: u32) -> vec4f {
  let way = select(1.0, -1.0, (side & 1u) == 0u);
  let out = way * select(vec3f(0.0), vec3f(1.0), vec3u(0u, 1u, 2u) == vec3u(side >> 1u));
  return vec4f(half_size[side >> 1u] - dot(out, p), -out);
}
