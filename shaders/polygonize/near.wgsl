#import field/tree
#import polygonize/nearList

// The field as it is in a brick: value and gradient, or value and colour. `at`: where the brick's entries begin, or WHOLE.
fn near_field(at: u32, p: vec3f, colours: bool) -> vec4f {
  begin_list(at);
  return run_program(p, colours);
}

// of the value before; smooth fields have one
fn near_branch() -> f32 {
  return 0.0;
}
