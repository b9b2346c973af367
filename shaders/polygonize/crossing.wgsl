#import polygonize/lattice
#import polygonize/near

// Where the surface crosses an edge of the lattice: Newton's steps along the edge from the secant of its ends, the gradient being
// nearly free; kept between places of opposite signs, which are halved where Newton's leave them or dawdle. Twin of
// src/field/surfacePoint.ts, which takes values first, as they are what is cheap there.

// evaluations along an edge at most
const STEPS = 16u;
// from here on every other one halves what is left: beside an axis where the field is nearly infinite Newton's come no nearer
const NEWTONS = 4u;
// parts of the edge: after a step that is shorter the place is right to its square
const CLOSE = 0.02;
// parts of the edge that are kept from its ends: edges that meet at a node must not put their vertices into one place
const ENDS = 1e-3;

struct Crossing {
  position: vec3f,
  // unit, out of where the field is positive
  normal: vec3f,
  colour: vec3f,
}

// between the nodes a and b, with these values; `list`: where the brick's entries begin
fn crossing_between(list: u32, a: vec3u, b: vec3u, ends: vec2f) -> Crossing {
  let start = node_position(a);
  let along = lattice.step * vec3f(b - a);
  let least = min(abs(ends.x), abs(ends.y));
  let is_cut = (ends.x > 0.0) == (ends.y > 0.0);
  var range = vec2f(0.0, 1.0);
  var t = select(kept(ends.x / (ends.x - ends.y)), 0.5, is_cut);
  var normal = vec3f(b - a) * select(1.0, -1.0, ends.y > 0.0);
  if (is_cut) {
    normal = normalize(vec3f(node_side(a) + node_side(b)));
  }
  var is_found = is_cut;
  // the last round is for the colour: one call, for compilers put the whole field in the place of each
  for (var round = 0u; round <= STEPS; round++) {
    let is_last = is_found || round == STEPS;
    let field = near_field(list, start + t * along, is_last);
    if (is_last) {
      return Crossing(start + t * along, normal, field.yzw);
    }
    normal = outward(field.yzw, normal);
    range = select(vec2f(range.x, t), vec2f(t, range.y), (field.x > 0.0) == (ends.x > 0.0));
    let guess = t - field.x / dot(field.yzw, along);
    // a short step from a large value is one down the steep side of a singular kernel
    is_found = abs(guess - t) < CLOSE && abs(field.x) <= least;
    let is_next = round < NEWTONS || round % 2u == 0u;
    let is_within = is_found || (guess > range.x && guess < range.y && is_next);
    t = kept(select(0.5 * (range.x + range.y), guess, is_within));
  }
  return Crossing(start + t * along, normal, vec3f(0.0));
}

fn kept(t: f32) -> f32 {
  return clamp(t, ENDS, 1.0 - ENDS);
}

// the one before where there is no slope
fn outward(gradient: vec3f, before: vec3f) -> vec3f {
  // squares of the slopes of singular kernels may overflow
  let most = max(abs(gradient.x), max(abs(gradient.y), abs(gradient.z)));
  if (!(most > 0.0 && most < 3e38)) {
    return before;
  }
  return -normalize(gradient / most);
}
