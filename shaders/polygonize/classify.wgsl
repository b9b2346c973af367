#import polygonize/loops
#import polygonize/owner
#import scan/workgroup

// Which edges that a brick owns are crossed, and which of its cells; numbered within the brick, whose sums are scanned next. A group is a brick.

const WIDTH = 128u;

@group(0) @binding(1) var<storage, read> values: array<f32>;
@group(0) @binding(2) var<storage, read> lists: array<vec4u>;
// of each place for a node, for the edges from it on: first vertex · 8 + which axes are crossed
@group(0) @binding(3) var<storage, read_write> crossings: array<u32>;
// of each cell: row of the loop table + 65536 · cells before; triangles before + 65536 · middles before
@group(0) @binding(4) var<storage, read_write> cells: array<vec2u>;
// of each brick: vertices on edges, crossed cells, triangles, vertices in the middle of loops
@group(0) @binding(5) var<storage, read_write> counts: array<vec4u>;

var<workgroup> brick_values: array<f32, 128>;
var<workgroup> brick_insides: array<u32, 128>;

@compute @workgroup_size(WIDTH)
fn classify(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) thread: u32,
) {
  let brick = brick_of(group, groups);
  if (brick >= lattice.bricks.w) {
    // where no brick is active
    if (brick == 0u && thread == 0u) {
      counts[0] = vec4u(0u);
    }
    return;
  }
  let corner = 4u * brick_place(lists[brick]);
  let place = node_place(thread);
  if (thread < 125u) {
    let value = values[128u * brick + thread];
    brick_values[thread] = value;
    brick_insides[thread] = u32(is_inside(corner + place, value));
  }
  workgroupBarrier();
  var axes = 0u;
  if (thread < 125u) {
    axes = crossed_axes(brick, thread, corner + place, place);
  }
  var row = 0u;
  if (thread < 64u) {
    row = cell_row(thread);
  }
  let pieces = loop_table[row];
  let is_crossed = (pieces.z & 15u) != 0u;
  let own = vec4u(countOneBits(axes), u32(is_crossed), loop_triangles(pieces), loop_middles(pieces));
  let before = scan_group(thread, own);
  crossings[128u * brick + thread] = (before.x << 3u) | axes;
  if (thread < 64u) {
    cells[64u * brick + thread] = vec2u(row | (before.y << 16u), before.z | (before.w << 16u));
  }
  if (thread == WIDTH - 1u) {
    counts[brick] = before + own;
  }
}

// as bits: 1 along x, 2 along y, 4 along z
fn crossed_axes(brick: u32, node: u32, n: vec3u, place: vec3u) -> u32 {
  var axes = 0u;
  for (var axis = 0u; axis < 3u; axis++) {
    let next = node + vec3u(1u, 5u, 25u)[axis];
    if (place[axis] < 4u && brick_insides[node] != brick_insides[next]) {
      axes |= select(0u, 1u << axis, owner_of_edge(n, axis).number == i32(brick));
    }
  }
  return axes;
}

// of the loop table
fn cell_row(cell: u32) -> u32 {
  let first = dot(cell_place(cell), vec3u(1u, 5u, 25u));
  var corners: array<f32, 8>;
  var mask = 0u;
  for (var corner = 0u; corner < 8u; corner++) {
    let node = first + dot((vec3u(corner) >> vec3u(0u, 1u, 2u)) & vec3u(1u), vec3u(1u, 5u, 25u));
    corners[corner] = brick_values[node];
    mask |= brick_insides[node] << corner;
  }
  return loop_case(mask, corners);
}
