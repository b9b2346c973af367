#import distance
#import field/unseen
#import polygonize/nearList
#import raycast/ahead
#import record/leaf
#import record/sum
#import skeleton/look
#import skeleton/spread
#import term

// Σ λ F − T along a ray: value and gradient, or value and colour, and what is sure ahead. Twin of src/field/sumSight.ts.

// since it was last set to 0; shapes too
var<private> asked_terms: u32;

struct Seen {
  field: vec4f,
  sight: Sight,
}

// `ray`: a mm of the world in the frame of the sum; `reach`: mm of the world that are of interest, 0 for none
fn seen_sum(sum: Sum, leaf: Leaf, p: vec3f, ray: vec3f, reach: f32, colours: bool) -> Seen {
  let curve = next_curve(ray);
  let list = list_of(sum, p);
  let stretch = length(ray);
  asked_terms += list.count;
  var total = list.rest;
  var colour = list.colour;
  var weight = list.weight;
  var least = 1e30;
  var ahead = Ahead(0.0, 1e30, 0.0, 4.0);
  for (var i = 0u; i < list.count; i++) {
    let number = list_term(list, i);
    let term = load_term(sum.first + number * TERM_STRIDE);
    let field = term.factor * term_field(term, p);
    total += field;
    if (leaf.power > 0.0) {
      let m2 = (leaf.core + noted_r2) / (noted_scale * noted_scale);
      least = min(least, m2);
      ahead.loose += SAFE * abs(field.x) / m2;
    } else if (reach > 0.0) {
      add_ahead(&ahead, load_bound(leaf.bounds + number * BOUND_STRIDE), term, field.x, p, reach * stretch);
    }
    let seen = field.x - UNSEEN * sum.threshold;
    if (colours && seen > 0.0) {
      // a running mean: sums of singular fields would overflow
      weight += seen;
      colour += seen / weight * (term.colour - colour);
    }
  }
  if (leaf.power > 0.0) {
    ahead.power = leaf.power;
    ahead.width = sqrt(least) * (1.0 - BLUR);
  }
  ahead.loose *= stretch * stretch;
  ahead.bend *= stretch * stretch;
  ahead.width /= stretch;
  var seen = Seen(select(total, vec4f(total.x, colour), colours), Sight(0.0, 0.0, 0.0));
  if (reach > 0.0) {
    seen.sight = sight_of(total.x, dot(total.yzw, ray), curve, ahead, reach);
  }
  return seen;
}

fn add_ahead(ahead: ptr<function, Ahead>, bound: Bound, term: Term, value: f32, p: vec3f, reach: f32) {
  let look = look_at(bound, term, p, reach);
  if (look.is_nothing) {
    return;
  }
  let per2 = bound.per * bound.per;
  if (bound.change == CHANGE_POWER) {
    let m2 = (bound.core + look.r * look.r) / per2;
    var size = abs(value);
    if (bound.sign == 0.0) {
      size = most_at(bound, look.r);
    }
    size += look.slack;
    (*ahead).loose += SAFE * size / m2;
    (*ahead).width = min((*ahead).width, sqrt(m2));
    (*ahead).power = bound.power;
    return;
  }
  var bend = slopes_of(bound, look.near, 0u).y;
  if (bound.dimension > 0u) {
    bend = min(bound.size * bend, bound.turns * slopes_of(bound, look.near, bound.dimension).y);
  }
  (*ahead).bend += SAFE * select(1.0, 2.0, bound.sign == 0.0) * bound.most * per2 * bend;
}

// Half the second derivative of what stands for the terms that are not asked; before list_of goes on to the next.
fn next_curve(ray: vec3f) -> f32 {
  if (cursor == WHOLE || lists[cursor].x != LISTED) {
    return 0.0;
  }
  let squares = bitcast<vec4f>(lists[cursor + 3u]).xyz;
  let mixed = bitcast<vec4f>(lists[cursor + 4u]).xyz;
  return dot(squares, ray * ray) + dot(mixed, ray * ray.yzx);
}
