#import kernel
#import record/point

@group(1) @binding(1) var<storage, read> points: array<Point>;

// value and gradient; weight in kernel units, scale in 1/mm
fn point_field(i: u32, p: vec3f) -> vec4f {
  let skel = points[i];
  let q = (p - skel.at) * skel.scale;
  let f = kernel_value(skel.kernel, max(dot(q, q), skel.floor2), skel.exponent);
  return skel.weight * vec4f(f.x, 2.0 * f.y * skel.scale * q);
}
