#import field/joined
#import field/leaf
#import field/sides
#import program
#import record/program

// A field tree as in tree.wgsl, whose values know their branch: the smooth field that they are from, which changes at creases. Twin of
// branch and onBranch in src/field/near.ts; numbers are the same. Blends and morphs are one field: all leaves within have its number.

const NO_BRANCH = 0xffffffffu;

struct Branched {
  field: vec4f,
  branch: u32,
  // whether the branch that is wanted is in it
  holds: bool,
}

// `wanted`: of that branch alone, beyond its creases too, or NO_BRANCH
fn run_branches(p: vec3f, colours: bool, wanted: u32) -> Branched {
  let program = load_program(0u);
  var stack: array<Branched, STACK>;
  var height = 0u;
  var result: Branched;
  for (var at = program.first; at < program.end; at += STEP_STRIDE) {
    let step = load_step(at);
    var early = result;
    var late = result;
    if (step.take == TAKE_STACK) {
      height -= 1u;
      early = stack[height];
    } else {
      late = branched_leaf(step, p, colours, wanted);
    }
    if (step.role == ROLE_JOIN) {
      result = joined_branches(step, early, late, colours);
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

fn branched_leaf(step: Step, p: vec3f, colours: bool, wanted: u32) -> Branched {
  let first = step.sides / SIDES;
  let count = step.sides % SIDES;
  let holds = wanted >= first && wanted < first + count;
  wanted_side = select(ALL_SIDES, wanted - first, holds && count > 1u);
  found_side = 0u;
  let field = leaf_field(step, p, colours);
  return Branched(field, first + select(0u, found_side, count > 1u), holds);
}

fn joined_branches(step: Step, early: Branched, late: Branched, colours: bool) -> Branched {
  var a = early;
  var b = late;
  if (step.swapped == 1u) {
    a = late;
    b = early;
  }
  if (a.holds && !b.holds) {
    return a;
  }
  if (b.holds && !a.holds) {
    // what is taken away is turned inside out
    return Branched(step.outer * step.sign * b.field, b.branch, true);
  }
  let is_first = step.outer * a.field.x >= step.sign * b.field.x;
  let field = joined(step, early.field, late.field, colours);
  return Branched(field, select(b.branch, a.branch, is_first), a.holds);
}
