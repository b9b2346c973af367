#import term
#import record/sum

// of T: what adds less has no colour
const UNSEEN = 1e-3;

// Σ λ F − T: value and gradient, or value and the mean colour of what adds to it. Twin of src/field/skelSum.ts.
fn sum_field(at: u32, p: vec3f, colours: bool) -> vec4f {
  let sum = load_sum(at);
  var total = vec4f(-sum.threshold, 0.0, 0.0, 0.0);
  var colour = sum.colour;
  var weight = 0.0;
  for (var i = sum.first; i < sum.end; i += TERM_STRIDE) {
    let term = load_term(i);
    let field = term.factor * term_field(term, p);
    total += field;
    let seen = field.x - UNSEEN * sum.threshold;
    if (colours && seen > 0.0) {
      // a running mean: sums of singular fields would overflow
      weight += seen;
      colour += seen / weight * (term.colour - colour);
    }
  }
  return select(total, vec4f(total.x, colour), colours);
}
