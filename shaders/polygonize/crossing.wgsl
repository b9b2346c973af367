#import polygonize/lattice
#import near

// Where the surface crosses a line, mostly an edge of the lattice: Newton's steps along it from the secant of its ends, the gradient being
// nearly free; kept between places of opposite signs, which are halved where Newton's leave them or dawdle. Twin of
// src/field/surfacePoint.ts, which takes values first, as they are what is cheap there.

// evaluations along an edge at most
const STEPS = 16u;
// from here on every other one halves what is left: beside an axis where the field is nearly infinite Newton's come no nearer
const NEWTONS = 4u;
// parts of the edge: after a step that is shorter the place is right to its square
const CLOSE = 0.01;
// parts of the edge that are kept from its ends: edges that meet at a node must not put their vertices into one place
const ENDS = 1e-4;

// From `start` by way of `middle` to `end`: straight for edges of the lattice.
struct Search {
  start: vec3f,
  middle: vec3f,
  end: vec3f,
  // values, of which one is positive
  ends: vec2f,
  // where the field has no slope, or is cut off
  normal: vec3f,
  // where to begin, of 0 to 1
  first: f32,
}

struct Crossing {
  position: vec3f,
  // unit, out of where the field is positive
  normal: vec3f,
  colour: vec3f,
  // that the normal is of; −1: none
  branch: f32,
}

// inside of the body at both ends: the lattice is left
fn is_cut(ends: vec2f) -> bool {
  return (ends.x > 0.0) == (ends.y > 0.0);
}

// `list`: where the brick's entries begin
fn surface_crossing(list: u32, search: Search) -> Crossing {
  let ends = search.ends;
  let least = min(abs(ends.x), abs(ends.y));
  var range = vec2f(0.0, 1.0);
  var t = search.first;
  var normal = search.normal;
  var branch = -1.0;
  var is_found = is_cut(ends);
  // the last round is for the colour: one call, for compilers put the whole field in the place of each
  for (var round = 0u; round <= STEPS; round++) {
    let is_last = is_found || round == STEPS;
    let field = near_field(list, search_place(search, t), is_last);
    if (is_last) {
      return Crossing(search_place(search, t), normal, field.yzw, branch);
    }
    normal = outward(field.yzw, normal);
    branch = near_branch();
    let is_before = (field.x > 0.0) == (ends.x > 0.0);
    range = select(vec2f(range.x, t), vec2f(t, range.y), is_before);
    let is_late = t > 0.5 || (t == 0.5 && is_before);
    let along = 2.0 * select(search.middle - search.start, search.end - search.middle, is_late);
    let guess = t - field.x / dot(field.yzw, along);
    // a short step from a large value is one down the steep side of a singular kernel
    is_found = abs(guess - t) < CLOSE && abs(field.x) <= least;
    let is_next = round < NEWTONS || round % 2u == 0u;
    let is_within = is_found || (guess > range.x && guess < range.y && is_next);
    t = kept(select(0.5 * (range.x + range.y), guess, is_within));
  }
  return Crossing(search.middle, normal, vec3f(0.0), branch);
}

fn search_place(search: Search, t: f32) -> vec3f {
  if (t < 0.5) {
    return search.middle + (1.0 - 2.0 * t) * (search.start - search.middle);
  }
  return search.middle + (2.0 * t - 1.0) * (search.end - search.middle);
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
