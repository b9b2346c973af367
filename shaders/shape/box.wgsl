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
