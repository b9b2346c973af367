#import field/joined
#import field/leaf
#import program
#import record/program

// A field tree as a flat program (src/gpu/program.ts). What is combined with a leaf stays in registers; the stack holds
// only what waits for a whole subtree.

fn tree_field(p: vec3f) -> vec4f {
  return run_program(p, false);
}

// (value, red, green, blue)
fn tree_colour(p: vec3f) -> vec4f {
  return run_program(p, true);
}

fn run_program(p: vec3f, colours: bool) -> vec4f {
  let program = load_program(0u);
  var stack: array<vec4f, STACK>;
  var height = 0u;
  var result = vec4f(0.0);
  for (var at = program.first; at < program.end; at += STEP_STRIDE) {
    let step = load_step(at);
    var early = result;
    var late = result;
    if (step.take == TAKE_STACK) {
      height -= 1u;
      early = stack[height];
    } else {
      late = leaf_field(step, p, colours);
    }
    if (step.role == ROLE_JOIN) {
      result = joined(step, early, late, colours);
      continue;
    }
    if (step.role == ROLE_PUSH) {
      stack[height] = result;
      height += 1u;
    }
    result = late;
  }
  return result;
}
