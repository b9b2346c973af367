#import field/branches
#import polygonize/nearList

// near.wgsl for fields that have creases.

var<private> branch_found: u32;

fn near_field(at: u32, p: vec3f, colours: bool) -> vec4f {
  return branch_field(at, p, colours, NO_BRANCH);
}

// Value and gradient of that branch alone, or of the field where it is NO_BRANCH.
fn branch_field(at: u32, p: vec3f, colours: bool, wanted: u32) -> vec4f {
  begin_list(at);
  let found = run_branches(p, colours, wanted);
  branch_found = found.branch;
  return found.field;
}

// of the value before
fn near_branch() -> f32 {
  return f32(branch_found);
}
