#import polygonize/loops
#import polygonize/owner

// Which edges that a brick owns are crossed, and which of its cells. A group is a brick.

@group(0) @binding(1) var<storage, read> values: array<f32>;
@group(0) @binding(2) var<storage, read> lists: array<vec4u>;
// of each place for a node: along which axes the edges from it on are crossed, as bits 1, 2, 4
@group(0) @binding(3) var<storage, read_write> crossings: array<u32>;
// of each cell: its row of the loop table, and room for a number
@group(0) @binding(4) var<storage, read_write> cells: array<vec2u>;

@compute @workgroup_size(128)
fn classify(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) thread: u32,
) {
  let brick = brick_of(group, groups);
  if (brick >= lattice.bricks.w) {
    return;
  }
  let corner = 4u * brick_place(lists[brick]);
  var axes = 0u;
  if (thread < 125u) {
    axes = crossed_axes(brick, thread, corner);
  }
  crossings[128u * brick + thread] = axes;
  if (thread < 64u) {
    cells[64u * brick + thread] = vec2u(cell_row(brick, cell_place(thread), corner), 0u);
  }
}

fn crossed_axes(brick: u32, node: u32, corner: vec3u) -> u32 {
  let place = node_place(node);
  let n = corner + place;
  let is_in = is_inside(n, values[128u * brick + node]);
  var axes = 0u;
  for (var axis = 0u; axis < 3u; axis++) {
    if (place[axis] == 4u) {
      continue;
    }
    let next = values[128u * brick + node + vec3u(1u, 5u, 25u)[axis]];
    if (is_in != is_inside(n + unit_along(axis), next)) {
      axes |= select(0u, 1u << axis, owner_of_edge(n, axis).number == i32(brick));
    }
  }
  return axes;
}

// of the loop table
fn cell_row(brick: u32, place: vec3u, corner: vec3u) -> u32 {
  let first = 128u * brick + dot(place, vec3u(1u, 5u, 25u));
  var corners: array<f32, 8>;
  var mask = 0u;
  for (var i = 0u; i < 8u; i++) {
    let step = (vec3u(i) >> vec3u(0u, 1u, 2u)) & vec3u(1u);
    let value = values[first + dot(step, vec3u(1u, 5u, 25u))];
    corners[i] = value;
    mask |= u32(is_inside(corner + place + step, value)) << i;
  }
  // most cells are of one sign
  if (mask == 0u || mask == 255u) {
    return 0u;
  }
  return loop_case(mask, corners);
}
