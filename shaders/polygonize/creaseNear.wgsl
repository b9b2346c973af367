#import polygonize/creased
#import polygonize/lattice
#import polygonize/leastStep
#import polygonize/nearBranches

// A point on all sides of a loop at once by Newton's least steps, or where these meet in no point nearby on the two that most of the loop is on. Twin of
// src/field/crease.ts.

// of Newton's
const STEPS = 8u;
// of all sides and of two, and of each a look at the whole
const ROUNDS = STEPS * 12u + STEPS * 2u + 2u;
// cells from the middle of its loop that a point may be
const REACH = 3.0;
// of that, along each axis: close enough
const CLOSE = 1e-4;
// cells: what is farther is held against the whole field
const OWN = 1.0;
const ON = 0.05;
// Below, sides meet too flatly: the cosine of 8°.
const FLAT = 0.99;

// A search that is under way.
struct Search {
  at: vec3f,
  // numbers of the sides that are asked, and how many
  asked: array<u32, 12>,
  count: u32,
  // of Newton's, and the side that is next
  step: u32,
  side: u32,
  planes: Planes,
  // on all that are asked: what is left is a look at the whole
  is_found: bool,
}

// outward, of each side
var<private> side_normals: array<vec3f, 12>;

// The point, and 1 where there is one; leaves a normal for each side. One call of the field, for compilers put all of it in the place of each.
fn crease_near(list: u32, sides: Sides, middle: vec3f) -> vec4f {
  var branches = sides.branches;
  var search: Search;
  search.at = middle;
  search.count = sides.count;
  search.asked = array<u32, 12>(0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u, 9u, 10u, 11u);
  for (var round = 0u; round < ROUNDS; round++) {
    let is_far = search.is_found && !is_within(search.at - middle, OWN * lattice.step);
    let wanted = select(u32(branches[search.asked[search.side]]), NO_BRANCH, search.is_found);
    let field = branch_field(select(list, WHOLE, is_far), search.at, false, wanted);
    let slope = length(field.yzw);
    // what else there is may hide where these sides meet
    if (search.is_found && abs(field.x) <= ON * lattice.step * slope) {
      spread_normals(search, sides.count);
      return vec4f(search.at, 1.0);
    }
    if (!search.is_found && slope > 0.0 && slope < 3e38 && goes_on(&search, field / slope, middle)) {
      continue;
    }
    if (search.count == 2u) {
      break;
    }
    search = Search(middle, two_most(sides), 2u, 0u, 0u, Planes(), false);
  }
  return vec4f(0.0);
}

// With value and gradient of the side that is next, over its slope. False where that leads nowhere.
fn goes_on(search: ptr<function, Search>, field: vec4f, middle: vec3f) -> bool {
  let normal = -field.yzw;
  side_normals[(*search).asked[(*search).side]] = normal;
  (*search).planes = with_plane((*search).planes, normal, field.x);
  (*search).side++;
  if ((*search).side < (*search).count) {
    return true;
  }
  let shift = least_step((*search).planes);
  (*search).at += shift;
  (*search).is_found = is_within(shift, CLOSE * REACH * lattice.step);
  (*search).step++;
  (*search).side = 0u;
  (*search).planes = Planes();
  let is_flat = (*search).step == 1u && are_flat((*search).asked, (*search).count);
  let is_late = (*search).step == STEPS && !(*search).is_found;
  return !is_flat && !is_late && is_within((*search).at - middle, REACH * lattice.step);
}

// along each axis; nothing that is no number is
fn is_within(v: vec3f, most: f32) -> bool {
  return all(abs(v) <= vec3f(most));
}

// Whether sides meet so flatly that nothing is seen of the edge.
fn are_flat(asked: array<u32, 12>, count: u32) -> bool {
  var sides = asked;
  for (var i = 1u; i < count; i++) {
    for (var k = 0u; k < i; k++) {
      if (dot(side_normals[sides[i]], side_normals[sides[k]]) <= FLAT) {
        return false;
      }
    }
  }
  return true;
}

// the sides that most vertices are on, of two alike the first
fn two_most(among: Sides) -> array<u32, 12> {
  var sides = among;
  var two: array<u32, 12>;
  for (var k = 1u; k < sides.count; k++) {
    two[0] = select(two[0], k, sides.vertices[k] > sides.vertices[two[0]]);
  }
  two[1] = select(0u, 1u, two[0] == 0u);
  for (var k = two[1] + 1u; k < sides.count; k++) {
    two[1] = select(two[1], k, k != two[0] && sides.vertices[k] > sides.vertices[two[1]]);
  }
  return two;
}

// Sides that were not asked have the normal of the one that most of the loop is on.
fn spread_normals(search: Search, all: u32) {
  var asked = search.asked;
  for (var k = 0u; k < all && search.count < all; k++) {
    if (k != asked[0] && k != asked[1]) {
      side_normals[k] = side_normals[asked[0]];
    }
  }
}
