// The edges of triangles as lines, three a triangle, and how many: an indexed indirect draw of triangles becomes one of lines.

@group(0) @binding(0) var<storage, read> indices: array<u32>;
// number of indices, instances, first index, base vertex, first instance
@group(0) @binding(1) var<storage, read> draw: array<u32, 5>;
@group(0) @binding(2) var<storage, read_write> line_indices: array<u32>;
@group(0) @binding(3) var<storage, read_write> draw_lines: array<u32, 5>;

// a thread a triangle that there is room for, in rows of workgroups
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
  let triangle = id.x + 64u * groups.x * id.y;
  if (triangle == 0u) {
    draw_lines = array(2u * draw[0], draw[1], 0u, draw[3], draw[4]);
  }
  if (3u * triangle + 2u >= draw[0]) {
    return;
  }
  let first = draw[2] + 3u * triangle;
  for (var side = 0u; side < 3u; side++) {
    line_indices[6u * triangle + 2u * side] = indices[first + side];
    line_indices[6u * triangle + 2u * side + 1u] = indices[first + (side + 1u) % 3u];
  }
}
