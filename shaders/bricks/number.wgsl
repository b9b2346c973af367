#import bricks/level

// Active bricks get their numbers, ascending along the grid, and their headers that order: owners are found by it.

const RUN = 16u;

@group(0) @binding(1) var<storage, read_write> lists: array<vec4u>;
@group(0) @binding(3) var<storage, read_write> grid: array<i32>;
@group(0) @binding(6) var<storage, read> runs: array<vec4u>;

@compute @workgroup_size(64)
fn number(@builtin(global_invocation_id) id: vec3u) {
  if (id.x >= arrayLength(&runs)) {
    return;
  }
  var found = runs[id.x].x;
  for (var i = RUN * id.x; i < min(RUN * (id.x + 1u), arrayLength(&grid)); i++) {
    if (grid[i] < 0 || found >= level.room) {
      continue;
    }
    lists[found] = lists[level.slots + u32(grid[i])];
    grid[i] = i32(found);
    found++;
  }
}
