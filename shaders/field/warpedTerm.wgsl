#import field/warp
#import record/term
#import record/warp
#import section
#import skeleton

// One skel of a sum in a field that has cross sections: value and gradient. One call for plain and warped skels, for
// compilers put the whole kernel in the place of each.
fn term_field(term: Term, p: vec3f) -> vec4f {
  let is_warped = term.warp != 0u;
  var warp: Warp;
  var q = p;
  var stretch = vec3f(1.0, 0.0, 0.0);
  var place = p;
  if (is_warped) {
    warp = load_warp(term.warp);
    q = warp_place(p, warp.origin, warp.axes, warp.scale);
    stretch = section_stretch(warp.section, q.xy, warp);
    place = warp_mapped(q, stretch);
  }
  var field = skel_field(term.primitive, term.kernel, term.skel, place);
  if (is_warped) {
    field = vec4f(field.x, warp_gradient(q, stretch, field.yzw, warp.axes, warp.scale));
  }
  return field;
}
