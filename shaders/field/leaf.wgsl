#import field/place
#import field/sum
#import program
#import record/step
#import shape

// A leaf of the tree where it was put: value and gradient, or value and colour.
fn leaf_field(step: Step, p: vec3f, colours: bool) -> vec4f {
  let is_moved = step.place != 0u;
  var place: Place;
  var q = p;
  if (is_moved) {
    place = load_place(step.place);
    q = to_local(place, p);
  }
  var field: vec4f;
  if (step.take == TAKE_SUM) {
    field = sum_field(step.at, q, colours);
  } else {
    let shape = load_shape(step.at);
    field = shape_field(shape, q);
    field = select(field, vec4f(field.x, shape.colour), colours);
  }
  if (is_moved) {
    field = select(to_world(place, field), vec4f(place.scale * field.x, field.yzw), colours);
  }
  return field;
}
