#import field/unseen
#import list
#import term
#import record/sum

// Σ λ F − T: value and gradient, or value and the mean colour of what adds to it. Twin of src/field/skelSum.ts.
fn sum_field(at: u32, p: vec3f, colours: bool) -> vec4f {
  let sum = load_sum(at);
  let list = list_of(sum, p);
  var total = list.rest;
  var colour = list.colour;
  var weight = list.weight;
  for (var i = 0u; i < list.count; i++) {
    let term = load_term(sum.first + list_term(list, i) * TERM_STRIDE);
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
