#import bricks/entries
#import bricks/level
#import bricks/sumRange
#import bricks/treeRange
#import field/place
#import polygonize/lattice
#import record/program
#import shapeRange

// Cubes of one level: what of the field matters in each, and whether the surface may be there. A thread is a cube, eight in a row those of
// one of the level above. Twin of src/field/bricks.ts, which begins with one cube for all.

@group(0) @binding(2) var<storage, read_write> counters: array<atomic<u32>>;
// of all bricks; of those that are kept their places among the headers
@group(0) @binding(3) var<storage, read_write> grid: array<i32>;
// of each level: groups of cubes, and how many cubes
@group(0) @binding(4) var<storage, read> dispatches: array<vec4u>;

// half a last digit of coordinates and what is added to them
const EPSILON = 4e-7;
// of the counters: the work of culling in twentieths of a value (src/skeleton/work.ts), and what a value asks in all bricks together
const WORK = 8u;
const ASKED = 9u;
// √3
const AROUND = 1.7320509;

// in twentieths of a value
var<private> work: u32;
var<private> shapes: u32;

// the entry that comes next in the list of the cube around, and sums and their terms there so far
struct Cursor {
  at: u32,
  met: u32,
  choices: u32,
}

@compute @workgroup_size(32)
fn cull(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) thread: u32,
) {
  let number = 32u * brick_of(group, groups) + thread;
  if (number >= dispatches[level.number].w) {
    return;
  }
  var cursor = Cursor(WHOLE, 0u, 0u);
  var place: vec3u;
  if (level.number == 0u) {
    let along = (lattice.bricks.xyz + level.size - 1u) / level.size;
    place = level.size * vec3u(number % along.x, number / along.x % along.y, number / along.x / along.y);
  } else {
    let header = outer[number / 8u];
    cursor.at = header.y;
    place = brick_place(header) + level.size * ((vec3u(number % 8u) >> vec3u(0u, 1u, 2u)) & vec3u(1u));
  }
  if (any(place >= lattice.bricks.xyz)) {
    return;
  }
  let range = tree_range(place, &cursor);
  atomicAdd(&counters[WORK], work);
  // nothing is known beyond the border: what is inside there is cut off
  let is_at_border = any(place == vec3u(0u)) || any(place + level.size >= lattice.bricks.xyz);
  // what is no number stays
  if (range.high <= 0.0) {
    return;
  }
  if (range.low > 0.0 && !is_at_border) {
    fill_inside(place);
    return;
  }
  keep(place, range, cursor.met);
}

fn tree_range(place: vec3u, cursor: ptr<function, Cursor>) -> Range {
  let half = 2.0 * f32(level.size) * lattice.step;
  let centre = lattice.origin + lattice.step * (4.0 * vec3f(place) + 2.0 * f32(level.size));
  let far = max(abs(centre.x), max(abs(centre.y), abs(centre.z)));
  let origin = abs(lattice.origin);
  let grown = half * SAFE + EPSILON * (far + half + max(origin.x, max(origin.y, origin.z)));
  let program = load_program(0u);
  var stack: array<Range, STACK>;
  var height = 0u;
  var result: Range;
  var leaf = level.leaves;
  for (var at = program.first; at < program.end; at += STEP_STRIDE) {
    let step = load_step(at);
    var early = result;
    var late = result;
    if (step.take == TAKE_STACK) {
      height -= 1u;
      early = stack[height];
    } else {
      late = leaf_range(step, load_leaf(leaf), centre, grown, cursor);
    }
    leaf += LEAF_STRIDE;
    if (step.role == ROLE_JOIN) {
      result = joined_range(step, early, late, (*cursor).met);
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

fn leaf_range(
  step: Step,
  leaf: Leaf,
  centre: vec3f,
  half: f32,
  cursor: ptr<function, Cursor>,
) -> Range {
  let radius = AROUND * half;
  var ball = Ball(centre, radius, 0.0, half, step.place != 0u, mat3x3f());
  var scale = 1.0;
  if (ball.is_moved) {
    let moving = load_place(step.place);
    let from_origin = dot(abs(centre), vec3f(1.0)) + dot(abs(moving.origin), vec3f(1.0)) + radius;
    ball.off = EPSILON * (leaf.stretch * from_origin + dot(abs(moving.low), vec3f(1.0)));
    ball.centre = to_local(moving, centre);
    ball.radius = leaf.stretch * radius + ball.off;
    ball.inverse = moving.inverse;
    scale = moving.scale;
  }
  if (step.take == TAKE_SHAPE) {
    work += 32u;
    shapes++;
    let range = scale * shape_range(load_shape(step.at), ball);
    return Range(range.x, range.y, 0.0, (*cursor).met, true);
  }
  let first = (*cursor).met;
  (*cursor).met += 1u;
  let sum = load_sum(step.at);
  var list = whole_sum(sum);
  if ((*cursor).at != WHOLE) {
    let head = outer[(*cursor).at];
    if (head.x != LISTED) {
      (*cursor).at += select(0u, 1u, head.y == (*cursor).met);
      dropped_low |= select(0u, 1u << first, head.x == DROPPED_LOW);
      dropped_high |= select(0u, 1u << first, head.x == DROPPED_HIGH);
      let value = select(-MOST, MOST, head.x == DROPPED_HIGH);
      return Range(value, value, 0.0, first, true);
    }
    list = outer_sum((*cursor).at, head);
    (*cursor).at = list.at + (head.z + 3u) / 4u;
  }
  let range = sum_range(sum, leaf, list, ball, level.allowed, first, (*cursor).choices);
  (*cursor).choices += list.count;
  let stay = entries[5u * first].z;
  // a bound without an evaluation; value and gradient, and once more a bound; for the others about two sources
  work += 5u * list.count + 37u * stay + 18u * (list.count - stay);
  return Range(range.low, range.high, range.error, first, true);
}

// What there is no room for only counts.
fn keep(place: vec3u, range: Range, sums: u32) {
  let rows = rows_needed(sums);
  var asked = shapes;
  for (var sum = 0u; sum < sums; sum++) {
    asked += select(0u, entries[5u * sum].z, kind_of(sum) == LISTED);
  }
  let slot = atomicAdd(&counters[cubes_of(level.number)], 1u);
  let row = level.entries + atomicAdd(&counters[rows_of(level.number)], rows);
  if (slot >= level.room || row + rows > level.end) {
    return;
  }
  let packed = place.x | (place.y << 10u) | (place.z << 20u);
  lists[level.slots + slot] = vec4u(packed, row, bitcast<u32>(range.error), 0u);
  if (level.size == 1u) {
    atomicAdd(&counters[ASKED], asked);
    grid[place.x + lattice.bricks.x * (place.y + lattice.bricks.y * place.z)] = i32(slot);
  }
  write_entries(row, sums);
}

fn fill_inside(place: vec3u) {
  let size = level.size;
  for (var i = 0u; i < size * size * size; i++) {
    let at = place + vec3u(i % size, i / size % size, i / size / size);
    if (all(at < lattice.bricks.xyz)) {
      grid[at.x + lattice.bricks.x * (at.y + lattice.bricks.y * at.z)] = INSIDE;
    }
  }
}
