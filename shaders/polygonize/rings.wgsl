#import polygonize/creased
#import polygonize/loops
#import polygonize/state
#import polygonize/vertexOn

// Loops whose vertices are on more than one branch: first how many there are in each crossed cell, which is scanned next, then a list of them.

@group(0) @binding(1) var<storage, read> crossed_cells: array<vec4u>;
@group(0) @binding(3) var<storage, read> lists: array<vec4u>;
// and the branch
@group(0) @binding(4) var<storage, read> normals: array<vec4f>;
// of each crossed cell: loops around creases, their sides; then what all cells before it have
@group(0) @binding(5) var<storage, read_write> ring_counts: array<vec4u>;
@group(0) @binding(6) var<storage, read_write> creased_loops: array<CreasedLoop>;

@compute @workgroup_size(64)
fn count_rings(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) thread: u32,
) {
  let i = item_of(group, groups, thread);
  if (i >= arrayLength(&ring_counts)) {
    return;
  }
  var counts = vec4u(0u);
  if (state.overflow == 0u && i < state.counts.y) {
    let cell = crossed_cells[i];
    let row = loop_table[cell.y];
    for (var number = 0u; number < loop_count(row); number++) {
      let sides = sides_of_ring(ring_at(cell, number)).count;
      counts += select(vec4u(0u), vec4u(1u, sides, 0u, 0u), sides > 1u);
    }
  }
  ring_counts[i] = counts;
}

@compute @workgroup_size(64)
fn list_rings(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) thread: u32,
) {
  let i = item_of(group, groups, thread);
  if (state.overflow != 0u || i >= state.counts.y) {
    return;
  }
  let cell = crossed_cells[i];
  let row = loop_table[cell.y];
  var at = ring_counts[i].x;
  var copy = state.counts.x + state.counts.w + ring_counts[i].y;
  var triangle = cell.z;
  for (var number = 0u; number < loop_count(row); number++) {
    var creased = ring_at(cell, number);
    let sides = sides_of_ring(creased).count;
    if (sides > 1u) {
      creased.triangle = triangle;
      creased.copy = copy;
      creased_loops[at] = creased;
      at++;
      copy += sides;
    }
    triangle += ring_length(creased) - select(2u, 0u, is_twisted(row, number));
  }
}

fn ring_at(cell: vec4u, number: u32) -> CreasedLoop {
  let row = loop_table[cell.y];
  let place = 4u * brick_place(lists[cell.x / 64u]) + cell_place(cell.x % 64u);
  let start = loop_start(row, number);
  let length = loop_end(row, number) - start;
  var creased: CreasedLoop;
  creased.cell = cell.x;
  creased.row = cell.y | (number << 16u) | (length << 24u);
  for (var k = 0u; k < length; k++) {
    creased.ring[k] = vertex_on(place, loop_edge(row, start + k));
  }
  return creased;
}

fn sides_of_ring(creased: CreasedLoop) -> Sides {
  var ring = creased.ring;
  var branches: array<f32, 12>;
  for (var k = 0u; k < ring_length(creased); k++) {
    branches[k] = normals[ring[k]].w;
  }
  return sides_of(branches, ring_length(creased));
}
