#import kernel
#import record/polygon
#import record/edge
#import skeleton/plateFloor

// value and gradient: a sum over the edges of all loops (Green, as Zhu et al. 2011 §3.3), in the polygon's plane
fn polygon_field(kernel: u32, at: u32, p: vec3f) -> vec4f {
  let skel = load_polygon(at);
  let q = (p - skel.origin) * skel.scale;
  let foot = vec2f(dot(q, skel.u), dot(q, skel.v));
  let z = dot(q, skel.n) - skel.lift;
  // the angles of a polygon out of reach leave 1e-7 in place of 0
  let far = max(length(foot) - skel.radius, 0.0);
  if (far * far + z * z > skel.support * skel.support) {
    return vec4f(0.0);
  }
  let floor2 = plate_floor2(skel, foot, z);
  var sum = vec4f(0.0);
  for (var k = skel.first; k < skel.end; k += EDGE_STRIDE) {
    sum += edge_field(kernel, load_edge(k), floor2, skel.exponent, foot, z);
  }
  let gradient = sum.y * skel.u + sum.z * skel.v + sum.w * skel.n;
  return skel.weight * vec4f(sum.x, gradient * skel.scale);
}

// value and gradient in the frame of the plane
fn edge_field(kernel: u32, edge: Edge, floor2: f32, exponent: f32, foot: vec2f, z: f32) -> vec4f {
  let a = edge.start - foot;
  let b = edge.end - foot;
  let nearer_a = dot(a, a) <= dot(b, b);
  let near = select(b, a, nearer_a);
  let along = dot(near, edge.u);
  var f: EdgeFrame;
  f.d = near.x * edge.u.y - near.y * edge.u.x;
  f.length = edge.length;
  f.alpha = select(along - edge.length, along, nearer_a);
  f.beta = select(along, along + edge.length, nearer_a);
  f.z = z;
  f.floor2 = floor2;
  f.exponent = exponent;
  let share = kernel_edge(kernel, f);
  return vec4f(share.x, share.y * edge.u.y, -share.y * edge.u.x, share.z);
}
