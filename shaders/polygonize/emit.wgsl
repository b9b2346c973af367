#import polygonize/loops
#import polygonize/ring
#import polygonize/state
#import polygonize/vertexOn

// The triangles of each crossed cell, loop by loop. Twin of BrickMesh in src/field/brickMesh.ts.

@group(0) @binding(1) var<storage, read> crossed_cells: array<vec4u>;
@group(0) @binding(3) var<storage, read> lists: array<vec4u>;

@compute @workgroup_size(64)
fn emit(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) thread: u32,
) {
  let i = item_of(group, groups, thread);
  if (i >= state.counts.y) {
    return;
  }
  let cell = crossed_cells[i];
  let place = 4u * brick_place(lists[cell.x / 64u]) + cell_place(cell.x % 64u);
  let row = loop_table[cell.y];
  var index = 3u * cell.z;
  var middle = cell.w;
  var start = 0u;
  for (var number = 0u; number < loop_count(row); number++) {
    let end = loop_end(row, number);
    for (var k = start; k < end; k++) {
      ring[k - start] = vertex_on(place, loop_edge(row, k));
    }
    let length = end - start;
    if (is_twisted(row, number)) {
      add_middle(middle, length);
      add_around(index, middle, length);
      middle++;
      index += 3u * length;
    } else {
      add_fan(index, length);
      index += 3u * (length - 2u);
    }
    start = end;
  }
}
