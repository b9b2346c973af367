#import kernel
#import record/point
#import distance

// value and gradient; weight in kernel units, scale in 1/mm
fn point_field(kernel: u32, at: u32, p: vec3f) -> vec4f {
  let skel = load_point(at);
  let q = (p - skel.at) * skel.scale;
  note_distance(dot(q, q), skel.scale);
  let f = kernel_value(kernel, max(dot(q, q), skel.floor2), skel.exponent);
  return skel.weight * vec4f(f.x, 2.0 * f.y * skel.scale * q);
}
