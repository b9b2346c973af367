// A skel with a section of its own, `stretch` = (m, ∂m/∂x, ∂m/∂y) of that section at q.xy; round: (1, 0, 0).
// The columns of `axes` are the skel's x, y, z: orthonormal. Twin of src/field/warp.ts.

// p in the skel's frame: across it in units of the scales, z along it
fn warp_place(p: vec3f, origin: vec3f, axes: mat3x3f, scale: vec2f) -> vec3f {
  let q = (p - origin) * axes;
  return vec3f(q.xy / scale, q.z);
}

// where the plain skel is evaluated
fn warp_mapped(q: vec3f, stretch: vec3f) -> vec3f {
  return vec3f(stretch.x * q.xy, q.z);
}

// Jᵀ g of the plain skel's gradient g there
fn warp_gradient(q: vec3f, stretch: vec3f, g: vec3f, axes: mat3x3f, scale: vec2f) -> vec3f {
  let across = (stretch.x * g.xy + dot(g.xy, q.xy) * stretch.yz) / scale;
  return axes * vec3f(across, g.z);
}
