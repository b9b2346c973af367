#import polygonize/creased
#import polygonize/lattice
#import polygonize/leastStep
#import polygonize/nearBranches
#import polygonize/state

// The point of each loop that is around a crease or a corner: on all of its sides at once, or where these meet in no point nearby on the two that
// most of it is on. Twin of src/field/crease.ts and loopPoints.ts.

@group(0) @binding(1) var<storage, read_write> creased_loops: array<CreasedLoop>;
@group(0) @binding(2) var<storage, read_write> positions: array<vec4f>;
// and the branch; of points on creases − 2 − the loop
@group(0) @binding(3) var<storage, read_write> normals: array<vec4f>;
@group(0) @binding(4) var<storage, read_write> colours: array<vec4f>;

// of Newton's
const STEPS = 8u;
// of all sides, of two, and of each a look at the whole
const ROUNDS = 8u * 12u + 8u * 2u + 2u;
// cells from the middle of its loop that a point may be
const REACH = 3.0;
// of that, along each axis: close enough
const CLOSE = 1e-4;
// cells: what is farther is held against the whole field
const OWN = 1.0;
const ON = 0.05;
// sine of an angle: what is turned by less is flat
const TURNED = 0.05;
// Below, sides meet too flatly: the cosine of 8°.
const FLAT = 0.99;

var<private> side_normals: array<vec3f, 12>;

@compute @workgroup_size(64)
fn creases(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) thread: u32,
) {
  let i = item_of(group, groups, thread);
  if (i >= state.creased_loops) {
    return;
  }
  let creased = creased_loops[i];
  let length = ring_length(creased);
  var ring = creased.ring;
  var branches: array<f32, 12>;
  var middle = vec3f(0.0);
  for (var k = 0u; k < length; k++) {
    branches[k] = normals[ring[k]].w;
    middle += positions[ring[k]].xyz / f32(length);
  }
  let sides = sides_of(branches, length);
  var side_branches = sides.branches;
  let point = crease_near(lists[creased.cell / 64u].y, sides, middle);
  if (point.w == 0.0 || is_turned(creased, branches, sides, point.xyz)) {
    creased_loops[i].copy = NO_POINT;
    return;
  }
  for (var side = 0u; side < sides.count; side++) {
    var colour = vec4f(0.0);
    for (var k = 0u; k < length; k++) {
      colour += select(vec4f(0.0), colours[ring[k]], branches[k] == side_branches[side]);
    }
    let vertex = creased.copy + side;
    positions[vertex] = vec4f(point.xyz, 1.0);
    normals[vertex] = vec4f(side_normals[side], -2.0 - f32(i));
    colours[vertex] = colour / max(colour.w, 1.0);
  }
}

// The point, and 1 where there is one; leaves a normal for each side. One call of the field, for compilers put all of it in the place of each.
fn crease_near(list: u32, sides: Sides, middle: vec3f) -> vec4f {
  let reach = REACH * lattice.step;
  // numbers of the sides that are asked
  var asked = array<u32, 12>(0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u, 9u, 10u, 11u);
  var branches = sides.branches;
  var count = sides.count;
  var at = middle;
  var step = 0u;
  var side = 0u;
  var planes: Planes;
  var is_found = false;
  for (var round = 0u; round < ROUNDS; round++) {
    let is_far = is_found && !is_within(at - middle, OWN * lattice.step);
    let wanted = select(u32(branches[asked[side]]), NO_BRANCH, is_found);
    let field = branch_field(select(list, WHOLE, is_far), at, false, wanted);
    let slope = length(field.yzw);
    // what else there is may hide where these sides meet
    if (is_found && abs(field.x) <= ON * lattice.step * slope) {
      spread_normals(asked, count, sides.count);
      return vec4f(at, 1.0);
    }
    var is_lost = is_found || !(slope > 0.0 && slope < 3e38);
    if (!is_lost) {
      side_normals[asked[side]] = -field.yzw / slope;
      planes = with_plane(planes, side_normals[asked[side]], field.x / slope);
      side++;
    }
    if (side == count && !is_lost) {
      let shift = least_step(planes);
      at += shift;
      is_found = is_within(shift, CLOSE * reach);
      let is_late = step + 1u == STEPS && !is_found;
      is_lost = is_late || !is_within(at - middle, reach) || (step == 0u && is_flat(asked, count));
      step++;
      side = 0u;
      planes = Planes();
    }
    if (is_lost) {
      if (count == 2u) {
        break;
      }
      asked = two_most(sides);
      count = 2u;
      at = middle;
      step = 0u;
      side = 0u;
      planes = Planes();
      is_found = false;
    }
  }
  return vec4f(0.0);
}

// along each axis; nothing that is no number is
fn is_within(v: vec3f, most: f32) -> bool {
  return all(abs(v) <= vec3f(most));
}

// Whether sides meet so flatly that nothing is seen of the edge.
fn is_flat(asked: array<u32, 12>, count: u32) -> bool {
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
fn spread_normals(asked: array<u32, 12>, count: u32, all: u32) {
  var sides = asked;
  for (var k = 0u; k < all && count < all; k++) {
    if (k != sides[0] && k != sides[1]) {
      side_normals[k] = side_normals[sides[0]];
    }
  }
}

// Whether a triangle around the point would be seen from within: of blades too thin for the lattice the tip is behind the loop.
fn is_turned(creased: CreasedLoop, ring_branches: array<f32, 12>, sides: Sides, at: vec3f) -> bool {
  var ring = creased.ring;
  var branches = ring_branches;
  let length = ring_length(creased);
  for (var k = 0u; k < length; k++) {
    let next = (k + 1u) % length;
    if (branches[k] != branches[next]) {
      continue;
    }
    let p = positions[ring[k]].xyz - at;
    let q = positions[ring[next]].xyz - at;
    let normal = side_normals[side_number(sides, branches[k])];
    if (dot(cross(p, q), normal) < -TURNED * sqrt(dot(p, p) * dot(q, q))) {
      return true;
    }
  }
  return false;
}
