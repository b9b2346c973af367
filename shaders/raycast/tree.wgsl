#import bricks/ball
#import field/combined
#import field/place
#import isDistance
#import operation
#import program
#import raycast/sum
#import record/program
#import record/step
#import shape
#import shapeRange
#import table/numbers

// A tree along a ray. Twin of `look` and `clear` in src/field/nearSet.ts, two operands at a time; blends, whose intervals the CPU halves,
// keep their sign as far as their operands' slopes say.

const MOST = 1e30;
// of what is looked ahead at a shape that is no distance
const SHORTENINGS = 14u;

// `at`: where the brick's entries begin, or WHOLE; `leaves`: of the records
fn seen_tree(at: u32, leaves: u32, p: vec3f, ray: vec3f, reach: f32, colours: bool) -> Sighted {
  begin_list(at);
  let program = load_program(0u);
  var stack: array<Sighted, STACK>;
  var height = 0u;
  var leaf = leaves;
  var result: Sighted;
  for (var i = program.first; i < program.end; i += STEP_STRIDE) {
    let step = load_step(i);
    var early = result;
    var late = result;
    if (step.take == TAKE_STACK) {
      height -= 1u;
      early = stack[height];
    } else {
      late = seen_leaf(step, leaf, p, ray, reach, colours);
    }
    leaf += LEAF_STRIDE;
    if (step.role == ROLE_JOIN) {
      result = seen_join(step, early, late, colours);
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

fn seen_leaf(step: Step, leaf: u32, p: vec3f, ray: vec3f, reach: f32, colours: bool) -> Sighted {
  var place: Place;
  var q = p;
  var along = ray;
  if (step.place != 0u) {
    place = load_place(step.place);
    q = to_local(place, p);
    along = place.inverse * ray;
  }
  var seen: Sighted;
  if (step.take == TAKE_SUM) {
    seen = seen_sum(load_sum(step.at), load_leaf(leaf), q, along, reach, colours);
  } else {
    let shape = load_shape(step.at);
    asked_terms += 1u;
    let field = shape_field(shape, q);
    seen.field = select(field, vec4f(field.x, shape.colour), colours);
  }
  if (step.place != 0u) {
    let value = place.scale * seen.field.x;
    seen.field = select(to_world(place, seen.field), vec4f(value, seen.field.yzw), colours);
    seen.sight.slope *= place.scale;
  }
  if (step.take == TAKE_SHAPE) {
    seen.sight = shape_sight(load_shape(step.at), seen.field.x, dot(seen.field.yzw, ray), q, along, reach);
  }
  return seen;
}

// Outside of what is convex, and on it, the value never rises faster than it does here: rays along a wall see all of it at once, which were 1,024 looks where they
// came closer than a thousandth of its length. Elsewhere distances change by no more than what is gone, in the world; what is none is asked for its interval over the next part of the ray, which is
// shortened until that does not hold 0.
fn shape_sight(shape: Shape, value: f32, slope: f32, p: vec3f, ray: vec3f, reach: f32) -> Sight {
  if (is_convex(shape.kind) && value <= 0.0) {
    return Sight(min(select(MOST, -value / slope, slope > 0.0), reach), 1.0, reach);
  }
  if (is_distance(shape.kind)) {
    return Sight(min(abs(value), reach), 1.0, reach);
  }
  let stretch = length(ray);
  var t = reach;
  for (var i = 0u; i < SHORTENINGS; i++) {
    let radius = 0.5 * t * stretch;
    let range = shape_range(shape, Ball(p + 0.5 * t * ray, radius, 0.0, radius, false, mat3x3f()));
    if (range.x > 0.0 || range.y < 0.0) {
      return Sight(t, 0.0, t);
    }
    t *= 0.5;
  }
  return Sight(0.0, 0.0, 0.0);
}

fn seen_join(step: Step, early: Sighted, late: Sighted, colours: bool) -> Sighted {
  var a = late;
  var b = early;
  if (step.swapped == 0u) {
    a = early;
    b = late;
  }
  let x = step.outer * a.field.x;
  let y = step.sign * b.field.x;
  let united = operation(step.operation, x, y, step.amounts);
  let value = clamp(step.outer * united.x, -MOST, MOST);
  var seen: Sighted;
  if (colours) {
    seen.field = vec4f(value, mix(a.field.yzw, b.field.yzw, share_of_b(united)));
  } else {
    let field = step.outer * combined(step.outer * a.field, step.sign * b.field, united);
    seen.field = select(field, vec4f(value, 0.0, 0.0, 0.0), value != field.x);
  }
  seen.sight = seen_sight(step, a.sight, b.sight, vec2f(x, y), united.x);
  return seen;
}

fn seen_sight(step: Step, a: Sight, b: Sight, operands: vec2f, united: f32) -> Sight {
  let known = min(a.known, b.known);
  if (step.operation == HARD_UNION || step.operation == SMOOTH_UNION) {
    // below 0 all keep their signs, above it one is enough
    let above = operands > vec2f(0.0);
    let of_above = max(select(0.0, a.clear, above.x), select(0.0, b.clear, above.y));
    let slope = select(max(a.slope, b.slope), 2.0 * (a.slope + b.slope), step.operation == SMOOTH_UNION);
    return Sight(select(min(a.clear, b.clear), of_above, any(above)), slope, known);
  }
  let is_blend = step.operation == BLEND_UNION;
  let bump = 0.65 * abs(step.amounts.x) / min(step.amounts.y, step.amounts.z);
  let slope = select(1.0, 2.0 + bump, is_blend) * (a.slope + b.slope);
  return Sight(min(abs(united) / max(slope, 1e-30), known), slope, known);
}
