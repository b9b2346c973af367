#import distance
#import field/unseen
#import polygonize/nearList
#import raycast/ahead
#import raycast/sections
#import raycast/terms
#import record/leaf
#import record/sum
#import skeleton

// Σ λ F − T along a ray: value and gradient, or value and colour, and what is sure ahead. Twin of src/field/sumSight.ts.

// since it was last set to 0; shapes too
var<private> asked_terms: u32;

struct Sighted {
  field: vec4f,
  sight: Sight,
}

// `ray`: a mm of the world in the frame of the sum; `reach`: mm of the world that are of interest, 0 for none
fn seen_sum(sum: Sum, leaf: Leaf, p: vec3f, ray: vec3f, reach: f32, colours: bool) -> Sighted {
  let curve = next_curve(ray);
  let list = list_of(sum, p);
  let stretch = length(ray);
  asked_terms += list.count;
  var total = list.rest;
  var colour = list.colour;
  var weight = list.weight;
  var least = 1e30;
  var ahead = Ahead(0.0, FREE, 0.0, 4.0);
  for (var i = 0u; i < list.count; i++) {
    let number = list_term(list, i);
    let term = load_term(sum.first + number * TERM_STRIDE);
    let is_warped = HAS_SECTIONS && term.warp != 0u;
    var bound: Bound;
    if (HAS_SECTIONS || leaf.power == 0.0) {
      bound = load_bound(leaf.bounds + number * BOUND_STRIDE);
    }
    let at = seen_from(bound, term, p, 0.0);
    let local = term.factor * skel_field(term.primitive, term.kernel, term.skel, at.place);
    var field = local;
    if (is_warped) {
      let warp = load_warp(term.warp);
      field = vec4f(local.x, warp_gradient(vec3f(at.q, 0.0), at.stretch, local.yzw, warp.axes, warp.scale));
    }
    total += field;
    if (is_warped) {
      if (reach > 0.0) {
        add_section_ahead(&ahead, bound, term, local, p, reach * stretch);
      }
    } else if (leaf.power > 0.0) {
      let m2 = (leaf.core + noted_r2) / (noted_scale * noted_scale);
      least = min(least, m2);
      ahead.loose += SAFE * abs(field.x) / m2;
    } else if (reach > 0.0) {
      add_ahead(&ahead, bound, term, field.x, p, reach * stretch);
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
    ahead.width = min(ahead.width, sqrt(least) * (1.0 - BLUR));
  }
  ahead.loose *= stretch * stretch;
  ahead.bend *= stretch * stretch;
  ahead.width /= stretch;
  var seen = Sighted(select(total, vec4f(total.x, colour), colours), Sight(0.0, 0.0, 0.0));
  if (reach > 0.0) {
    seen.sight = sight_of(total.x, dot(total.yzw, ray), curve, ahead, reach);
  }
  return seen;
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
