#import record/term
#import skeleton

// One skel of a sum in a field without cross sections: value and gradient.
fn term_field(term: Term, p: vec3f) -> vec4f {
  return skel_field(term.primitive, term.kernel, term.skel, p);
}
