#import kernel
#import record/segment
#import distance

// value and gradient. The perpendicular is taken from the nearer end and made perpendicular twice: d² − h² would lose all
// its digits beyond an end (9e-2 against 1e-6).
fn segment_field(kernel: u32, at: u32, p: vec3f) -> vec4f {
  let skel = load_segment(at);
  let from_a = (p - skel.a) * skel.scale;
  let from_b = (p - skel.b) * skel.scale;
  let nearer_a = dot(from_a, from_a) <= dot(from_b, from_b);
  let from_end = select(from_b, from_a, nearer_a);
  let along = dot(from_end, skel.u);
  var perp = from_end - along * skel.u;
  perp -= dot(perp, skel.u) * skel.u;

  var f: LineFrame;
  f.rho2 = dot(perp, perp);
  f.length = skel.length;
  f.alpha = select(-along - skel.length, -along, nearer_a);
  f.beta = select(-along, skel.length - along, nearer_a);
  let beyond = max(max(f.alpha, -f.beta), 0.0);
  note_distance(f.rho2 + beyond * beyond, skel.scale);
  f.weights = skel.weights;
  f.degree = skel.degree;
  f.floor2 = skel.floor2;
  f.exponent = skel.exponent;
  let line = kernel_line(kernel, f);
  return vec4f(line.x, (2.0 * line.y * perp + line.z * skel.u) * skel.scale);
}
