#import polygonize/lattice
#import polygonize/loops
#import polygonize/state

// What is crossed, one after the other: vertices and cells get their numbers in the mesh, and lists that later stages walk. A group is a brick.

// of each brick: what all bricks before it have
@group(0) @binding(1) var<storage, read> before: array<vec4u>;
@group(0) @binding(2) var<storage, read> cells: array<vec2u>;
// as number.wgsl left them; the first vertex becomes its number in the mesh
@group(0) @binding(3) var<storage, read_write> crossings: array<u32>;
// of each vertex: 512 · brick + 3 · node + axis of its edge, or + 384 + cell where it is in the middle of a loop
@group(0) @binding(4) var<storage, read_write> vertex_edges: array<u32>;
// of each crossed cell: 64 · brick + cell, row of the loop table, first triangle, first vertex in the middle
@group(0) @binding(5) var<storage, read_write> crossed_cells: array<vec4u>;

@compute @workgroup_size(128)
fn compact(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) thread: u32,
) {
  let brick = brick_of(group, groups);
  if (brick >= lattice.bricks.w || state.overflow != 0u) {
    return;
  }
  let first = before[brick];
  let crossing = crossings[128u * brick + thread];
  var vertex = first.x + (crossing >> 3u);
  crossings[128u * brick + thread] = (vertex << 3u) | (crossing & 7u);
  for (var axis = 0u; axis < 3u; axis++) {
    if (((crossing >> axis) & 1u) == 1u) {
      vertex_edges[vertex] = 512u * brick + 3u * thread + axis;
      vertex++;
    }
  }
  if (thread < 64u) {
    list_cell(64u * brick + thread, first);
  }
}

fn list_cell(number: u32, first: vec4u) {
  let cell = cells[number];
  let row = cell.x & 65535u;
  // the first row of the loop table is that of cells without surface
  if (row == 0u) {
    return;
  }
  let triangle = first.z + (cell.y & 65535u);
  let middle = state.counts.x + first.w + (cell.y >> 16u);
  crossed_cells[first.y + (cell.x >> 16u)] = vec4u(number, row, triangle, middle);
  for (var i = 0u; i < loop_middles(loop_table[row]); i++) {
    vertex_edges[middle + i] = 512u * (number / 64u) + 384u + number % 64u;
  }
}
