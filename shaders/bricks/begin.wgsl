#import bricks/level

// All bricks are outside until something else is known.

@group(0) @binding(3) var<storage, read_write> grid: array<i32>;

@compute @workgroup_size(64)
fn begin(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
  for (var i = id.x; i < arrayLength(&grid); i += 64u * groups.x) {
    grid[i] = OUTSIDE;
  }
}
