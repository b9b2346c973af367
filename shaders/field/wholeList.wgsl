#import record/sum
#import record/term

// What of a sum is asked, where all of it is.

struct List {
  // what need not be asked, less T: value and gradient
  rest: vec4f,
  // its colour, and how much that weighs
  colour: vec3f,
  weight: f32,
  // where the numbers of the terms are, and how many
  at: u32,
  count: u32,
}

fn list_of(sum: Sum, p: vec3f) -> List {
  let count = (sum.end - sum.first) / TERM_STRIDE;
  return List(vec4f(-sum.threshold, 0.0, 0.0, 0.0), sum.colour, 0.0, 0u, count);
}

// the number of the i-th
fn list_term(list: List, i: u32) -> u32 {
  return i;
}
